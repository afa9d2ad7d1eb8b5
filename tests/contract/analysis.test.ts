/** What is computed about a plant beyond its shape, over the real wasm: against the engine that grows plants. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import { loadAnalysis } from "../../web/src/engine/analysis.ts";
import { analysisAddress } from "../../web/src/engine/analysis-place.ts";
import { Analyst } from "../../web/src/engine/analyst.ts";
import { grow, history, init, type ParamsInput } from "../../web/src/package/node.ts";
import { parameters } from "../../web/src/params/declaration.ts";
import { complete, withValue } from "../../web/src/params/params.ts";

beforeAll(async () => {
  await init();
  await loadAnalysis(() => readFileSync(analysisAddress));
});

const analyst = new Analyst(() => null);

const cases: [string, ParamsInput, number][] = [
  ["an axis", { axis: { segments: 12 }, loads: { tipMass: 0.001 } }, 12],
  [
    "pipes and tropism, young",
    { axis: { segments: 12 }, growth: { thickening: "pipes" }, tropism: { strength: 2, elevation: 80 } },
    9,
  ],
  ["a fork", { axis: { segments: 5 }, branching: { pattern: "bifurcation", generations: 2 } }, 15],
];

const smooth = [
  "axis.segmentLength",
  "axis.radius",
  "axis.elevation",
  "material.youngsModulus",
  "material.density",
  "loads.gravity",
];

describe.each(cases)("%s", (_, input, step) => {
  test.each(smooth)("moves with %s as central differences say", async (path) => {
    const params = complete({ ...input, solver: { tolerance: 1e-14 } });
    const found = await analyst.sensitivity(params, step, [{ path, part: 0 }]);
    const at = (change: number) => {
      const [group = "", field = ""] = path.split(".");
      const value = (params as unknown as Record<string, Record<string, number>>)[group]?.[field] ?? 0;
      return {
        h: change * value,
        points: history(withValue(params, path, value * (1 + change))).at(step).polylines.points,
      };
    };
    // Of fourth order, so that a step of 1e-3 is off by some 1e-9 only.
    const [near, far, nearBack, farBack] = [at(1e-3), at(2e-3), at(-1e-3), at(-2e-3)];
    const slopes = found?.slopes[0] ?? new Float64Array();
    expect(found?.points).toEqual(history(params).at(step).polylines.points);
    const largest = Math.max(...slopes.map(Math.abs));
    expect(largest).toBeGreaterThan(0);
    slopes.forEach((slope, k) => {
      const of = ({ points }: typeof near) => points[k] ?? Number.NaN;
      const difference = (8 * (of(near) - of(nearBack)) - (of(far) - of(farBack))) / (12 * near.h);
      expect(Math.abs(slope - difference)).toBeLessThan(1e-6 * largest);
    });
  });
});

test("what is counted or chosen has no derivative, and is not given one", async () => {
  const places = parameters
    .filter(({ kind }) => kind !== "number" && kind !== "vector")
    .map(({ path }) => ({ path, part: 0 }));
  const found = await analyst.sensitivity(complete({ axis: { segments: 4 } }), 4, places);
  expect(found?.slopes).toEqual(places.map(() => null));
});

test("a plant that is pulled at has none at all", async () => {
  const params = complete({ loads: { forces: [{ segment: 3, force: [0, 1, 0] }] } });
  expect(await analyst.sensitivity(params, 40, [{ path: "material.youngsModulus", part: 0 }])).toBeNull();
});

test("both ways begin with one shape and end in the plant's", async () => {
  const params = complete({ axis: { segments: 10 } });
  const [euler, newton] = await Promise.all([
    analyst.way(params, 10, "euler"),
    analyst.way(params, 10, "newton"),
  ]);
  expect(newton.angle.subarray(0, 10)).toEqual(euler.angle.subarray(0, 10));
  expect([newton.status, euler.status, newton.isLed]).toEqual(["converged", "converged", false]);
  expect(newton.steps).toBeLessThan(6);
  expect(euler.steps).toBeGreaterThan(100);
  expect(newton.residuals).toHaveLength(newton.time.length);
  const { points } = grow(params).polylines;
  for (const way of [euler, newton]) {
    const last = way.angle.subarray(-10);
    const x = last.reduce((sum, angle) => sum + params.axis.segmentLength * Math.cos(angle), 0);
    expect(x).toBeCloseTo(points[30] ?? Number.NaN, 8);
  }
});

test("more than 2000 segments are not relaxed, and that is said", async () => {
  const params = complete({ axis: { segments: 3000 }, solver: { stepping: "static" } });
  await expect(analyst.way(params, 3000, "euler")).rejects.toThrow(/at most 2000/);
});
