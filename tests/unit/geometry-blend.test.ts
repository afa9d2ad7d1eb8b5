import { describe, expect, it } from "vitest";
import { blend } from "../../web/src/geometry/blend.ts";
import type { Axes } from "../../web/src/geometry/tube.ts";
import { handMade } from "./plants.ts";

const young = handMade({
  points: [
    [0, 0, 0],
    [0, 1, 0],
  ],
  radii: [0.1, 0.1],
});

const older = handMade(
  {
    points: [
      [0, 0, 0],
      [0.5, 0.5, 0],
    ],
    radii: [0.3, 0.2],
  },
  {
    points: [
      [0.5, 0.5, 0],
      [1, 1, 0],
      [2, 1, 0],
    ],
    radii: [0.1, 0.1, 0.1],
    on: 0,
  },
);

function points(axes: Axes | null): number[] {
  return [...(axes?.polylines.points ?? [])];
}

describe("the growth between two steps", () => {
  it("begins with the younger shape, where what is new has no length yet", () => {
    const start = blend(young, older, 0);
    expect(points(start)).toEqual([0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
    expect(start?.polylines.radii.slice(0, 2)).toEqual(new Float64Array([0.1, 0.1]));
  });

  it("ends with the older shape", () => {
    expect(points(blend(young, older, 1))).toEqual([...older.polylines.points]);
    expect(blend(young, older, 1)?.polylines.radii).toEqual(older.polylines.radii);
  });

  it("moves on straight lines in between", () => {
    const middle = blend(young, older, 0.5);
    expect(points(middle).slice(3, 6)).toEqual([0.25, 0.75, 0]);
    expect(points(middle).slice(12, 15)).toEqual([1, 1, 0]);
    expect(middle?.polylines.radii[0]).toBeCloseTo(0.2, 12);
  });

  it("is not made up where an axis got shorter", () => {
    expect(blend(older, young, 0.5)).not.toBeNull();
    const shorter = handMade({ points: [[0, 0, 0]], radii: [0.1] });
    expect(blend(young, shorter, 0.5)).toBeNull();
  });
});
