/** What is plotted along the axis: the path through a plant, round values, and the numbers to take away. */
import { beforeAll, describe, expect, test } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { acrossOf, type Chart, sheet } from "../../web/src/plots/chart.ts";
import { csvOf } from "../../web/src/plots/keep.ts";
import { indexAt, profileOf } from "../../web/src/plots/profile.ts";
import { ticksWithin } from "../../web/src/plots/ticks.ts";

beforeAll(() => init());

describe("a profile", () => {
  test("of one axis is all of it, with the plant's own numbers", () => {
    const plant = grow({});
    const { segments, distance, length, values } = profileOf(plant, null);
    expect(segments).toEqual(Array.from({ length: 40 }, (_, k) => k));
    expect(length).toBeCloseTo(1.5, 12);
    expect(distance[39]).toBeCloseTo(1.4625, 12);
    expect(values.moment).toEqual([...plant.segments.moment]);
    expect(values.stress).toEqual([...plant.segments.stress]);
    // It leaves its base near its elevation, and hangs more and more.
    expect(values.angle[0]).toBeLessThan(50);
    expect(values.angle[0]).toBeGreaterThan(47);
    expect(values.angle[39] ?? 0).toBeLessThan(values.angle[0] ?? 0);
  });

  test("of forks goes through the thicker children, or through the segment that is pointed at", () => {
    const plant = grow({
      axis: { segments: 4 },
      branching: { pattern: "bifurcation", generations: 2, girthRatio: 0.6 },
    });
    const { segments } = plant;
    const main = profileOf(plant, null);
    expect(main.segments).toHaveLength(12);
    const thinnest = segments.radius.indexOf(Math.min(...segments.radius));
    expect(main.segments).not.toContain(thinnest);
    const through = profileOf(plant, thinnest);
    expect(through.segments).toContain(thinnest);
    for (const path of [main, through]) {
      expect(path.segments[0]).toBe(0);
      path.segments.slice(1).forEach((segment, k) => {
        expect(segments.parent[segment]).toBe(path.segments[k]);
      });
    }
  });

  test("around a stem is that of the lowest axis, not of the stem", () => {
    const plant = grow({ arrangement: { pattern: "stem", count: 3 }, axis: { segments: 6 } });
    const { segments } = profileOf(plant, null);
    expect(segments).toHaveLength(6);
    expect(segments.map((segment) => plant.segments.axis[segment])).toEqual([1, 1, 1, 1, 1, 1]);
  });

  test("has angles without jumps where an axis curls over", () => {
    const { values } = profileOf(
      grow({ axis: { elevation: 175 }, tropism: { strength: 8, elevation: -120 }, loads: { gravity: 0 } }),
      null,
    );
    values.angle.slice(1).forEach((angle, k) => {
      expect(Math.abs(angle - (values.angle[k] ?? 0))).toBeLessThan(90);
    });
  });

  test("finds the segment at a distance", () => {
    const profile = profileOf(grow({}), null);
    expect([-1, 0, 0.0374, 0.0376, 0.7, 99].map((place) => indexAt(profile, place))).toEqual([
      0, 0, 0, 1, 18, 39,
    ]);
  });
});

test.each([
  [0, 10, [0, 2, 4, 6, 8, 10]],
  [-0.31, 0.12, [-0.3, -0.2, -0.1, 0, 0.1]],
  [42.5, 50.1, [44, 46, 48, 50]],
  [3, 3, [3]],
  [0, Number.POSITIVE_INFINITY, [0]],
])("round values from %d to %d", (min, max, expected) => {
  const ticks = ticksWithin(min, max);
  expect(ticks).toHaveLength(expected.length);
  ticks.forEach((tick, k) => {
    expect(tick).toBeCloseTo(expected[k] ?? Number.NaN, 12);
  });
});

test.each([false, true])("places across a chart and back (logarithmic: %s)", (isLogarithmicAcross) => {
  const curves = [{ x: [1, 10, 1000], y: [1, 2, 3], kind: "first" as const }];
  const chart: Chart = {
    strips: [{ title: "", curves, fromZero: true }],
    across: "",
    isLogarithmicAcross,
    cursor: null,
  };
  const { place, value } = acrossOf(chart);
  expect(place(1000)).toBeCloseTo(sheet.width - sheet.right, 9);
  for (const x of [1, 30, 999]) expect(value(place(x))).toBeCloseTo(x, 9);
});

test("numbers to take away keep all their digits", () => {
  const text = csvOf([
    { name: "a (m)", values: [1 / 3, 2] },
    { name: "b", values: [1e-20, -0.1] },
  ]);
  expect(text).toBe("a (m),b\n0.3333333333333333,1e-20\n2,-0.1\n");
});
