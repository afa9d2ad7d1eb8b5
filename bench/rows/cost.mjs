// How the cost of growth rises with the number of segments, exact and as coarsely as the schema offers; from the package as it is shipped.

import { interleaved, summary } from "../samples.mjs";
import { grownRod, loadPackage } from "../shipped.mjs";
import { digits } from "../table.mjs";

/** @param {import("../bench.mjs").Bench} bench */
export async function costRows({ table, effort, quick }) {
  const { grow, schema } = await loadPackage();
  const steppings = schema.properties.solver.properties.stepping.enum.filter((name) => name !== "static");
  table.heading(
    "Growth with pipes against the number of segments n, wasm in Node, as shipped (arrays copied out included)",
  );
  const sizes = quick ? [100, 1000] : [100, 300, 1000, 3000, 10_000];
  for (const stepping of steppings) {
    /** @type {{ size: number, seconds: number }[]} */
    const course = [];
    for (const size of sizes) {
      const params = grownRod(size, stepping);
      // With a tolerance that leaves nothing over at the tip either: at 1e-10 the exact shape of 10,000 segments is off by 1e-5.
      const exact = stepping === "exact" ? undefined : grow(grownRod(size, "exact", 1e-14));
      const plant = grow(params);
      const time = async (/** @type {number} */ rounds) => {
        const start = performance.now();
        for (let round = 0; round < rounds; round++) grow(params);
        return (performance.now() - start) / 1000;
      };
      const [samples = []] = await interleaved([{ time }], size > 3000 ? { ...effort, repeats: 3 } : effort);
      const seconds = summary(samples).min;
      const before = course.at(-1);
      const words = [`${digits(plant.report.iterations / plant.report.steps)} iterations a step`];
      if (exact)
        words.push(
          `shape off by ${digits(farthest(plant, exact))} of the length (said: ${digits(plant.report.steppingError ?? 0)})`,
        );
      if (before)
        words.push(
          `n^${digits(Math.log(seconds / before.seconds) / Math.log(size / before.size))} from ${before.size}`,
        );
      table.row({
        what: `${stepping}, n = ${size}`,
        who: "wasm, Node",
        samples,
        unit: "s",
        note: words.join("; "),
      });
      course.push({ size, seconds });
    }
    const [first] = course;
    const last = course.at(-1);
    if (!first || !last) continue;
    const exponent = Math.log(last.seconds / first.seconds) / Math.log(last.size / first.size);
    table.row({
      what: `${stepping}, from ${first.size} to ${last.size}`,
      note: `n^${digits(exponent)}, by the shortest times`,
    });
  }
}

/**
 * Largest distance between the same points of two plants, over the length of the axis (1 m).
 * @param {import("../shipped.mjs").Shape} plant
 * @param {import("../shipped.mjs").Shape} other
 */
function farthest({ polylines: { points } }, { polylines: { points: others } }) {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [0, 1, 2].map((k) => (points[i + k] ?? 0) - (others[i + k] ?? 0));
    most = Math.max(most, Math.hypot(x ?? 0, y ?? 0, z ?? 0));
  }
  return most;
}
