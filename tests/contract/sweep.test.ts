/** Sweeps: rows in order, numbers of the plants, bad rows by themselves. */
import { beforeAll, describe, expect, test } from "vitest";
import { LostError } from "../../web/src/engine/failure.ts";
import { grow, init } from "../../web/src/package/node.ts";
import { measureNames, type Pool, startPool, sweep } from "../../web/src/package/node-worker.ts";
import { measuresOf } from "../../web/src/plant/measures.ts";

beforeAll(() => init());

/** Workers need the built package: the examples have them. */
const here = { worker: false } as const;

describe("a sweep", () => {
  test("of a grid has a row for every combination, the last axis changing fastest", async () => {
    const base = { axis: { segments: 8 } };
    const axes = {
      "loads.gravity": [0, 9.81],
      "growth.thickening": ["none", "pipes"],
      "axis.elevation": [10, 60, 90],
    };
    const { rows, axes: swept, columns, status, problems } = await sweep(base, axes, here);
    expect([rows, problems]).toEqual([12, []]);
    expect(swept["axis.elevation"]).toEqual(
      Float64Array.from([10, 60, 90, 10, 60, 90, 10, 60, 90, 10, 60, 90]),
    );
    expect(swept["growth.thickening"]).toEqual(
      [..."nnnpppnnnppp"].map((c) => (c === "n" ? "none" : "pipes")),
    );
    expect(status).toEqual(new Array(12).fill("converged"));
    expect(Object.keys(columns)).toEqual(measureNames);
    const last = grow({
      axis: { segments: 8, elevation: 90 },
      loads: { gravity: 9.81 },
      growth: { thickening: "pipes" },
    });
    for (const name of measureNames) {
      expect(columns[name]).toBeInstanceOf(Float64Array);
      expect(columns[name][11], name).toBe(measuresOf(last)[name]);
    }
  });

  test("of a list has a row for each of its params, or a grid for each", async () => {
    const list = [{ axis: { segments: 3 } }, { axis: { segments: 5 } }];
    expect([...(await sweep(list, {}, here)).columns.segments]).toEqual([3, 5]);
    const grids = await sweep(list, { "loads.gravity": [0, 1] }, here);
    expect([...grids.columns.segments]).toEqual([3, 3, 5, 5]);
    expect((await sweep([], {}, here)).rows).toBe(0);
  });

  test("lists bad rows with their reasons, and does all others", async () => {
    const { columns, status, problems } = await sweep({}, { "axis.segments": [4, 0, 6, 1.5] }, here);
    expect(problems).toMatchObject([
      {
        row: 1,
        message: "axis.segments must be a whole number from 1 to 100000; it is 0.",
        issues: [{ code: "outOfRange" }],
      },
      { row: 3, issues: [{ code: "notInteger" }] },
    ]);
    expect([...columns.segments]).toEqual([4, Number.NaN, 6, Number.NaN]);
    expect(status).toEqual(["converged", null, "converged", null]);
  });

  test("refuses an axis that is no parameter, before it grows anything", async () => {
    await expect(sweep({}, { "axis.radios": [1] }, here)).rejects.toMatchObject({
      name: "BoughError",
      message: "axis.radios is not a parameter, so it cannot be swept.",
    });
  });

  test("looks at the step it is asked for, tells its progress, and stops when it is told to", async () => {
    const shares: number[] = [];
    const half = await sweep(
      {},
      { "loads.gravity": [1, 2] },
      {
        ...here,
        step: 10,
        onProgress: (share) => shares.push(share),
      },
    );
    expect([...half.columns.steps]).toEqual([10, 10]);
    expect(shares).toEqual([0.5, 1]);
    await expect(sweep({}, {}, { ...here, signal: AbortSignal.abort() })).rejects.toMatchObject({
      name: "AbortError",
    });
  });

  test("tries a plant once more whose worker died, and leaves a pool that it was given running", async () => {
    const own = await startPool(here);
    let asked = 0;
    const failing = (times: number): Pool => ({
      ...own,
      size: 1,
      check: own.check.bind(own),
      hold: own.hold.bind(own),
      dispose: () => expect.fail("It is not the sweep's own."),
      plant: (...request) =>
        asked++ < times ? Promise.reject(new LostError("The worker failed.")) : own.plant(...request),
    });
    expect((await sweep({}, {}, { pool: failing(1) })).problems).toEqual([]);
    asked = 0;
    const { problems, status } = await sweep({}, { "loads.gravity": [1, 2] }, { pool: failing(3) });
    expect(problems.length + status.filter((word) => word === "converged").length).toBe(2);
    expect(problems).toMatchObject([{ message: "The worker failed.", issues: [] }]);
    own.dispose();
  });
});

test("the measures are those of the arrays", () => {
  const plant = grow({
    branching: { pattern: "bifurcation", generations: 2 },
    axis: { segments: 5, elevation: 90 },
  });
  const { tipX, tipY, height, reach, length, axes, segments, stable } = measuresOf(plant);
  const heights = plant.polylines.points.filter((_, i) => i % 3 === 1);
  expect(height).toBe(Math.max(...heights));
  expect(reach).toBeGreaterThan(Math.abs(tipX));
  expect(tipY).toBeGreaterThan(0);
  expect(length).toBeCloseTo(35 * 0.0375, 12);
  expect([axes, segments, stable]).toEqual([7, 35, 1]);
});
