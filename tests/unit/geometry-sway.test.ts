import { expect, test } from "vitest";
import { swayOf } from "../../web/src/geometry/sway.ts";
import { handMade } from "./plants.ts";

/** An upright limb of 2 m, with radii and lengths as the solver gives them. */
function upright(count: number, radiusAt: (height: number) => number) {
  const axes = handMade({
    points: Array.from({ length: count + 1 }, (_, k) => [0, (2 * k) / count, 0]),
    radii: Array.from({ length: count + 1 }, (_, k) => radiusAt((2 * k) / count)),
  });
  axes.segments.length.fill(2 / count);
  for (let k = 0; k < count; k++) axes.segments.radius[k] = radiusAt((2 * (k + 0.5)) / count);
  return axes;
}

test("a uniform limb gives way as a cantilever under an even load does", () => {
  const sways = swayOf(upright(400, () => 0.01));
  expect(sways.at(-1)).toBe(1);
  for (const share of [0.25, 0.5, 0.75]) {
    // x^2 (x^2 - 4x + 6) / 3; joints are at the bases of segments: first order in 400.
    const exact = (share ** 2 * (share ** 2 - 4 * share + 6)) / 3;
    expect(sways[400 * share - 1]).toBeCloseTo(exact, 2);
  }
});

test("only ratios count, and nothing is negative or above 1", () => {
  const thick = swayOf(upright(30, () => 0.1));
  const thin = swayOf(upright(30, () => 0.001));
  for (const [k, sway] of thick.entries()) expect(thin[k]).toBeCloseTo(sway, 12);
  for (const sway of swayOf(upright(30, (height) => 0.02 - 0.009 * height))) {
    expect(sway).toBeGreaterThan(0);
    expect(sway).toBeLessThanOrEqual(1);
  }
});

test("a fork's thin child moves more than its thick one, and both as their parent at their base", () => {
  const fork = handMade(
    {
      points: [
        [0, 0, 0],
        [0, 1, 0],
      ],
      radii: [0.1, 0.1],
    },
    {
      points: [
        [0, 1, 0],
        [1, 2, 0],
      ],
      radii: [0.08, 0.08],
      on: 0,
    },
    {
      points: [
        [0, 1, 0],
        [0, 2, 1],
      ],
      radii: [0.03, 0.03],
      on: 0,
    },
  );
  fork.segments.length.set([1, Math.SQRT2, Math.SQRT2]);
  fork.segments.radius.set([0.1, 0.08, 0.03]);
  const [trunk = 0, thick = 0, thin = 0] = swayOf(fork);
  expect(trunk).toBeLessThan(thick);
  expect(thick).toBeLessThan(thin);
  expect(thin).toBe(1);
});

test("a plant without thickness or segments stands still", () => {
  expect([...swayOf(upright(3, () => 0))]).toEqual([0, 0, 0]);
  expect(swayOf(handMade()).length).toBe(0);
});
