import { startEngine } from "bough/worker";

const engine = await startEngine();
const gravity = document.querySelector("#gravity");
const report = document.querySelector("#report");

/** Asks on every movement: an older request that is not finished gives way to the newest. */
async function show() {
  try {
    const { polylines, params } = await engine.plant({
      axis: { segments: 300, segmentLength: 0.005 },
      growth: { thickening: "pipes" },
      loads: { gravity: gravity.valueAsNumber },
    });
    const height = polylines.points.at(-2);
    report.textContent = `At ${params.loads.gravity.toFixed(1)} m/s² the tip is ${height.toFixed(3)} m high (${engine.transport}).`;
  } catch (error) {
    if (error.name !== "AbortError") throw error;
  }
}

gravity.addEventListener("input", show);
await show();
