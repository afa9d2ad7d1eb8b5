/** A plant that takes too long stops at its deadline, with the last finished step. */
import { beforeAll, describe, expect, test } from "vitest";
import { threadEngine } from "../../web/src/engine/engine.ts";
import { grow, history, init, type ParamsInput } from "../../web/src/package/node.ts";
import { fingerprint } from "../fingerprint.ts";

beforeAll(() => init());

/** Each takes seconds to hours, and each for another reason. */
const endless: Readonly<Record<string, ParamsInput>> = {
  "a hundred thousand segments": { axis: { segments: 100_000, segmentLength: 1e-5 } },
  pipes: { axis: { segments: 14_000, segmentLength: 1e-4 }, growth: { thickening: "pipes" } },
  forks: {
    axis: { segments: 12, segmentLength: 0.01 },
    branching: { pattern: "bifurcation", generations: 15 },
  },
  "axes around a stem": {
    axis: { segments: 10_000, segmentLength: 1e-4 },
    arrangement: { pattern: "stem", count: 20, interval: 5 },
  },
  "the paper's relaxation": { axis: { segments: 2000, segmentLength: 0.001 }, solver: { method: "euler" } },
  "a thread that folds": {
    axis: { segments: 20_000, segmentLength: 0.1, elevation: 89 },
    material: { youngsModulus: 1e6 },
  },
};

const DEADLINE = 200;

describe("grow stops within 50 ms of its deadline", () => {
  test.each(Object.entries(endless))("%s", (name, params) => {
    let [off, steps] = [Number.POSITIVE_INFINITY, 0];
    // Whatever else the machine does makes it later: the best of three is what Bough does.
    for (let attempt = 0; attempt < 3 && off > 50; attempt++) {
      const start = performance.now();
      const { report, segments } = grow(params, { deadline: DEADLINE });
      off = performance.now() - start - DEADLINE;
      steps = report.steps;
      expect(report.status).toBe("budget");
      expect(segments.birth.every((birth) => birth <= report.steps)).toBe(true);
    }
    console.log(`${name}: ${off.toFixed(1)} ms after a deadline of ${DEADLINE} ms, at step ${steps}`);
    // It may be early: a step that would not be done in time is not begun.
    expect(off).toBeLessThanOrEqual(50);
  });
});

test("what is there in time is the plant without a deadline, to the last bit", async () => {
  expect(fingerprint(grow({}, { deadline: 60_000 }))).toBe(fingerprint(grow({})));
  expect(grow({}, { deadline: 60_000 }).report.status).toBe("converged");
  const engine = threadEngine();
  expect(fingerprint(await engine.plant({}, 7, { deadline: 60_000 }))).toBe(fingerprint(history({}).at(7)));
});

test("what is late is the plant of its last finished step, to the last bit", () => {
  const params = { axis: { segments: 20_000, segmentLength: 1e-4 } };
  const late = grow(params, { deadline: 60 });
  expect(late.report.status).toBe("budget");
  expect(late.report.steps).toBeGreaterThan(10);
  expect(fingerprint(late)).toBe(fingerprint(history(params).at(late.report.steps)));
});

test("no time at all gives a plant of no segments, which says so", async () => {
  for (const plant of [grow({}, { deadline: 0 }), await threadEngine().plant({}, null, { deadline: 0 })]) {
    expect(plant.report).toMatchObject({ status: "budget", steps: 0 });
    expect(plant.segments.length).toHaveLength(0);
    expect(plant.polylines.offsets).toEqual(new Uint32Array([0, 1]));
  }
});

test("an engine stops at the deadline, and goes on from there without one", async () => {
  const engine = threadEngine();
  const params = { axis: { segments: 3000, segmentLength: 0.0005 } };
  const late = await engine.plant(params, null, { deadline: 50 });
  expect(late.report.status).toBe("budget");
  const whole = await engine.plant(params);
  expect(whole.report).toMatchObject({ status: "converged", steps: 3000 });
  expect(fingerprint(whole)).toBe(fingerprint(grow(params)));
});

test.each([-1, Number.NaN, "5", null])("a deadline of %o is refused", async (deadline) => {
  const given = { deadline: deadline as number };
  const refusal = { name: "BoughError", issues: [{ path: "deadline", code: "wrongType" }] };
  expect(() => grow({}, given)).toThrow(expect.objectContaining({ name: "BoughError" }));
  await expect(threadEngine().plant({}, null, given)).rejects.toMatchObject(refusal);
});
