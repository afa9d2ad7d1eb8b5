/** Holding a plant at a point, over the real core; `tests/browser` does it by hand. */
import { beforeAll, describe, expect, test } from "vitest";
import { threadEngine } from "../../web/src/engine/engine.ts";
import { grow, init } from "../../web/src/package/node.ts";
import type { Plant } from "../../web/src/plant/plant.ts";
import { fingerprint } from "../fingerprint.ts";

beforeAll(() => init());

function end({ polylines, segments }: Plant, segment: number): [number, number, number] {
  const at = 3 * (segments.point[segment] ?? 0);
  const [x = 0, y = 0, z = 0] = polylines.points.subarray(at, at + 3);
  return [x, y, z];
}

describe.each([
  ["the default plant", {}, 39],
  ["a fork", { branching: { pattern: "bifurcation", generations: 2 }, axis: { segments: 12 } } as const, 30],
])("%s", (_, params, segment) => {
  test("comes to where it is wanted, by the force that its params name", async () => {
    const force: [number, number, number] = [0.02, -0.05, 0];
    const pulled = grow({ ...params, loads: { forces: [{ segment, force }] } });
    const place = end(pulled, segment);
    const held = await threadEngine().hold(params, null, segment, place);
    if (!held) throw new Error("It was not held.");
    const [named] = held.params.loads.forces;
    expect(named?.segment).toBe(segment);
    named?.force.forEach((component, k) => {
      expect(component).toBeCloseTo(force[k] ?? 0, 7);
    });
    held.polylines.points.forEach((value, k) => {
      expect(Math.abs(value - (pulled.polylines.points[k] ?? 0))).toBeLessThan(1e-8);
    });
  });

  test("is the same to the last bit when it is let go of", async () => {
    const engine = threadEngine();
    const before = fingerprint(await engine.plant(params));
    await engine.hold(params, null, segment, [0.2, 0.2, 0]);
    expect(fingerprint(await engine.plant(params))).toBe(before);
  });
});

test("a younger age is held at that age", async () => {
  const held = await threadEngine().hold({}, 10, 9, [0.2, 0.2, 0]);
  expect(held?.report.steps).toBe(10);
});

test("the newest place wins", async () => {
  const engine = threadEngine();
  const older = engine.hold({}, null, 39, [0.5, 0.5, 0]);
  const newer = engine.hold({}, null, 39, [0.6, 0.6, 0]);
  await expect(older).rejects.toMatchObject({ name: "AbortError" });
  expect(end((await newer) as Plant, 39)[0]).toBeCloseTo(0.6, 9);
});

test.each([40, -1, 0.5, 2 ** 32 + 39, Number.NaN])("there is no segment %d", async (segment) => {
  expect(await threadEngine().hold({}, null, segment, [0.5, 0.5, 0])).toBeNull();
});

test("a place that is no place is answered, not followed", async () => {
  const engine = threadEngine();
  expect(await engine.hold({}, null, 39, [Number.NaN, 0, 0])).toBeNull();
  expect(await engine.hold({}, null, 39, [Number.POSITIVE_INFINITY, 0, 0])).toBeNull();
});

test("bad params are answered as for a plant", async () => {
  const held = threadEngine().hold({ axis: { segments: -1 } }, null, 0, [0, 0, 0]);
  await expect(held).rejects.toMatchObject({ name: "BoughError" });
});
