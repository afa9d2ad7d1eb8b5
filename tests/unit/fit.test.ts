/** Fitting to a traced line: the arithmetic, on the real core. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import { loadAnalysis } from "../../web/src/engine/analysis.ts";
import { analysisAddress } from "../../web/src/engine/analysis-place.ts";
import { Analyst } from "../../web/src/engine/analyst.ts";
import { type Fit, fitLine, type Study } from "../../web/src/fit/fit.ts";
import { residualsOf, type Traced } from "../../web/src/fit/line.ts";
import { studentQuantile } from "../../web/src/fit/student.ts";
import { grow, init } from "../../web/src/package/node.ts";
import { complete, type Params, type ParamsInput, valueAt, withValue } from "../../web/src/params/params.ts";

beforeAll(async () => {
  await init();
  await loadAnalysis(() => readFileSync(analysisAddress));
});

const analyst = new Analyst(() => null);
const study: Study = (params, step, places) => analyst.sensitivity(params, step, places);

/** Random numbers that are the same in every run. */
function randomFrom(seed: number) {
  let state = seed;
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
  return {
    between: (min: number, max: number) => min + (max - min) * next(),
    normal: () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next()),
  };
}

type Random = ReturnType<typeof randomFrom>;

/** A plant that bends enough to tell what bends it: q from 1 to 10. */
function randomPlant({ between }: Random, pipes: boolean): Params {
  const segments = Math.round(between(12, 30));
  const radius = between(0.004, 0.01);
  const q = between(1, 10);
  const input: ParamsInput = {
    axis: { segments, segmentLength: 1 / segments, radius, elevation: between(5, 75) },
    tropism: { strength: between(0.3, 2.5), elevation: between(50, 90) },
    growth: { thickening: pipes ? "pipes" : "none" },
    material: { youngsModulus: ((4 * 1000 * 9.81) / (q * radius * radius)) * (pipes ? 0.15 / segments : 1) },
  };
  return complete(input);
}

/** So wide is the picture that the plants are in, px, and so much of it they fill. */
const picture = { width: 1280, height: 800, filled: 0.7 };

/** Traces the axis in a picture: points at random places, each off by a normal error of 2 px both ways. */
function trace(params: Params, { between, normal }: Random, count = 25): { traced: Traced[]; pixel: number } {
  const { points } = grow(params).polylines;
  const at = (k: number) => [points[3 * k] ?? 0, points[3 * k + 1] ?? 0] as const;
  const last = points.length / 3 - 1;
  const xs = Array.from({ length: last + 1 }, (_, k) => at(k)[0]);
  const ys = Array.from({ length: last + 1 }, (_, k) => at(k)[1]);
  const span = (values: number[]) => Math.max(...values) - Math.min(...values);
  const pixel = Math.max(span(xs) / picture.width, span(ys) / picture.height) / picture.filled;
  const places = Array.from({ length: count - 1 }, () => between(0.02, 0.97) * last).sort((a, b) => a - b);
  const traced = [...places, last].map((place) => {
    const k = Math.min(last - 1, Math.floor(place));
    const mix = (a: number, b: number) => a + (place - k) * (b - a);
    const [from, to] = [at(k), at(k + 1)];
    return { x: mix(from[0], to[0]) + 2 * pixel * normal(), y: mix(from[1], to[1]) + 2 * pixel * normal() };
  });
  return { traced, pixel };
}

const chosen = ["material.youngsModulus", "tropism.strength", "axis.elevation"];

/** Where a search starts: from twice, half, or 15 degrees off the truth. */
function astray(params: Params, path: string, { between }: Random): Params {
  const value = Number(valueAt(params, path));
  const off = path === "axis.elevation" ? value + between(-15, 15) : value * 2 ** between(-1, 1);
  return withValue(params, path, off);
}

test("50 random plants, traced with 2 px noise: recovered within the stated confidence in at least 90 %", async () => {
  const random = randomFrom(2026);
  let within = 0;
  const widths: number[] = [];
  for (let plant = 0; plant < 50; plant++) {
    const params = randomPlant(random, plant % 2 === 1);
    const path = chosen[plant % chosen.length] ?? "";
    const { traced, pixel } = trace(params, random);
    const start = astray(params, path, random);
    const found = await fitLine(
      { params: start, step: params.axis.segments, paths: [path], traced, lastIsTip: true },
      study,
    );
    if (found.kind !== "found") throw new Error(`Plant ${plant}: ${JSON.stringify(found)}`);
    const [{ low, high } = { low: Number.NaN, high: Number.NaN }] = found.found;
    const truth = Number(valueAt(params, path));
    if (low <= truth && truth <= high) within++;
    widths.push((high - low) / (path === "axis.elevation" ? 90 : truth));
    // The tracing's noise is found, too: its own error is 1 / sqrt(2 * 25) of it, and five times that is never met.
    expect(Math.abs(found.noise / (2 * pixel) - 1)).toBeLessThan(0.75);
  }
  widths.sort((a, b) => a - b);
  console.log(
    `within the stated 95 %: ${within} of 50; median width of the intervals ${widths[25]?.toFixed(3)}`,
  );
  expect(within).toBeGreaterThanOrEqual(45);
  // Intervals that say nothing would hold every truth.
  expect(widths[25]).toBeLessThan(0.3);
});

describe("two parameters at once", () => {
  test("are both found without noise", async () => {
    const random = randomFrom(7);
    const params = randomPlant(random, false);
    const { polylines } = grow(params);
    const traced = Array.from({ length: params.axis.segments }, (_, k) => ({
      x: polylines.points[3 * k + 3] ?? 0,
      y: polylines.points[3 * k + 4] ?? 0,
    }));
    const start = astray(astray(params, "material.youngsModulus", random), "axis.elevation", random);
    const paths = ["material.youngsModulus", "axis.elevation"];
    const found = await fitLine({ params: start, step: 1e5, paths, traced, lastIsTip: true }, study);
    if (found.kind !== "found") throw new Error(found.kind);
    for (const { path, value } of found.found) {
      expect(value / Number(valueAt(params, path))).toBeCloseTo(1, 6);
    }
    expect(found.deviation).toBeLessThan(1e-8);
  });

  test("that only their ratio bends are told to be inseparable, and nothing is made up", async () => {
    const random = randomFrom(8);
    const params = randomPlant(random, false);
    const { traced } = trace(params, random);
    const paths = ["axis.elevation", "material.youngsModulus", "material.density"];
    const found = await fitLine({ params, step: 1e5, paths, traced, lastIsTip: true }, study);
    expect(found).toEqual({ kind: "inseparable", paths: ["material.youngsModulus", "material.density"] });
  });
});

describe("what cannot be fitted is said", () => {
  const few = [
    { x: 0.1, y: 0.1 },
    { x: 0.2, y: 0.2 },
  ];
  const fitted = (paths: string[], change: ParamsInput = {}, traced: Traced[] = few): Promise<Fit> =>
    fitLine({ params: complete(change), step: 40, paths, traced, lastIsTip: false }, study);
  const many = Array.from({ length: 10 }, (_, k) => ({ x: 0.1 * k, y: 0.1 * k - 0.01 * k * k }));

  test("too few points", async () => {
    expect(await fitted(["material.youngsModulus"])).toEqual({ kind: "tooFew", least: 3 });
  });

  test("a parameter that the line does not depend on", async () => {
    const weightless = { loads: { gravity: 0 } };
    const found = await fitted(["material.youngsModulus", "axis.elevation"], weightless, many);
    expect(found).toEqual({ kind: "unseen", paths: ["material.youngsModulus"] });
  });

  test("a plant without derivatives", async () => {
    const pulled = { loads: { forces: [{ segment: 1, force: [0, 1, 0] as [number, number, number] }] } };
    expect(await fitted(["material.youngsModulus"], pulled, many)).toEqual({ kind: "lost" });
  });
});

test("the derivatives of the distances are those of central differences", async () => {
  const random = randomFrom(9);
  const params = withValue(randomPlant(random, true), "solver.tolerance", 1e-14);
  const { traced } = trace(params, random);
  const step = params.axis.segments;
  for (const path of chosen) {
    const residuals = async (value: number) => {
      const found = await study(withValue(params, path, value), step, [{ path, part: 0 }]);
      if (!found) throw new Error("No derivatives.");
      return residualsOf({ points: found.points, slopes: found.slopes as Float64Array[] }, traced, true);
    };
    const value = Number(valueAt(params, path));
    const h = 1e-4 * value;
    const [here, ahead, behind] = [
      await residuals(value),
      await residuals(value + h),
      await residuals(value - h),
    ];
    const slopes = here.rows.map((row) => row[0] ?? 0);
    const largest = Math.max(...slopes.map(Math.abs));
    slopes.forEach((slope, k) => {
      const difference = ((ahead.values[k] ?? 0) - (behind.values[k] ?? 0)) / (2 * h);
      expect(Math.abs(slope - difference)).toBeLessThan(1e-6 * largest);
    });
  }
});

test.each([
  [1, 12.7062],
  [2, 4.30265],
  [3, 3.18245],
  [5, 2.57058],
  [10, 2.22814],
  [24, 2.0639],
  [100, 1.98397],
])("Student's 95 %% for %d degrees of freedom is %d", (freedom, expected) => {
  expect(studentQuantile(0.95, freedom)).toBeCloseTo(expected, 3);
});
