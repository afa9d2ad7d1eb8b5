// Grows plants by the million in one process, with `node --expose-gc`, and fails when memory is not flat:
//   memory.mjs <address of the package> <calls> <failing calls>

const [, , address = "", calls, failing] = process.argv;
const { BoughError, grow, init } = await import(address);

await init();

/** Of all sorts: stiff and slack, young and old, with pipes, with forks. @param {number} call */
function params(call) {
  return {
    axis: { segments: 1 + (call % 17), elevation: (call % 180) - 90 },
    loads: { gravity: (call % 23) / 2 },
    growth: { thickening: call % 3 === 0 ? "pipes" : "none" },
    branching: { pattern: call % 11 === 0 ? "bifurcation" : "none", generations: 1 },
  };
}

const bad = [
  null,
  "axis",
  { axis: 1 },
  { axis: { segments: Number.NaN } },
  { leaves: {} },
  { loads: { gravity: -1 } },
];

/** @param {number} call */
function fails(call) {
  try {
    grow(bad[call % bad.length]);
    return false;
  } catch (error) {
    return error instanceof BoughError;
  }
}

/** Megabytes held when all garbage is gone. */
function held() {
  if (!globalThis.gc) throw new Error("Node must be started with --expose-gc.");
  globalThis.gc();
  const { heapUsed, external, rss } = process.memoryUsage();
  return { heap: heapUsed / 1e6, external: external / 1e6, rss: rss / 1e6 };
}

/**
 * Does the work, a good part of it before the first reading: by then the process has the size that it works in.
 * @param {string} what
 * @param {number} count
 * @param {(call: number) => void} work
 */
function requireFlat(what, count, work) {
  for (let call = 0; call < Math.max(count / 10, 40_000); call++) work(call);
  const before = held();
  for (let call = 0; call < count; call++) work(call);
  const after = held();
  const kinds = /** @type {const} */ (["heap", "external", "rss"]);
  const shown = kinds.map((kind) => `${kind} ${before[kind].toFixed(1)} → ${after[kind].toFixed(1)} MB`);
  console.log(`${what}: ${shown.join(", ")}`);
  const isFlat =
    after.heap - before.heap < 1 && after.external - before.external < 1 && after.rss - before.rss < 16;
  if (!isFlat) throw new Error(`Memory is not flat over ${what}.`);
}

const good = grow({}).polylines.points.join();
requireFlat(`${calls} plants`, Number(calls), (call) => {
  if (grow(params(call)).report.status !== "converged") throw new Error(`Call ${call} did not converge.`);
});
requireFlat(`${failing} calls that fail`, Number(failing), (call) => {
  if (!fails(call)) throw new Error(`Call ${call} did not fail.`);
});
if (grow({}).polylines.points.join() !== good) throw new Error("The next good call grows another plant.");
console.log("and the next good call grows the same plant as the first");
