import { describe, expect, it } from "vitest";
import { headingOf, pick, type Sight } from "../../web/src/geometry/pick.ts";
import { handMade } from "./plants.ts";

/** An eye far away on the z axis: 100 px a metre, x to the right, y down. */
const flat: Sight = {
  toPicture: [100, 0, 0, 0, 0, -100, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  scale: 100,
  depth: 1,
  girth: 1,
};
/** An eye at z = 10 m: what is nearer is larger; the same at z = 0. */
const near: Sight = {
  toPicture: [1000, 0, 0, 0, 0, -1000, 0, 0, 0, 0, 1, -1, 0, 0, 0, 10],
  scale: 100,
  depth: 10,
  girth: 1,
};

const level = handMade({
  points: [
    [0, 0, 0],
    [1, 0, 0],
    [2, 0, 0],
  ],
  radii: [0.1, 0.1, 0.1],
});
/** Two axes that cross in the picture; the second is nearer. */
const crossing = handMade(
  {
    points: [
      [0, 0, 0],
      [2, 0, 0],
    ],
    radii: [0.1, 0.1],
  },
  {
    points: [
      [1, -1, 1],
      [1, 1, 1],
    ],
    radii: [0.1, 0.1],
  },
);

describe("picking", () => {
  it("finds the segment and the place on its centre line", () => {
    expect(pick(level, flat, 150, 5, 22)).toEqual({ segment: 1, point: [1.5, 0, 0] });
    expect(pick(level, flat, 30, -8, 22)?.point).toEqual([0.3, 0, 0].map((v) => expect.closeTo(v, 12)));
  });

  it("reaches as far beyond the surface as it is told, and past the ends", () => {
    expect(pick(level, flat, 150, 31, 22)?.segment).toBe(1);
    expect(pick(level, flat, 150, 33, 22)).toBeNull();
    expect(pick(level, flat, 225, 0, 22)?.point).toEqual([2, 0, 0]);
    expect(pick(level, { ...flat, girth: 2 }, 150, 33, 22)?.segment).toBe(1);
  });

  it("takes the nearer of two that lie over each other", () => {
    expect(pick(crossing, near, 111, 0, 22)?.segment).toBe(1);
    expect(pick(crossing, near, 60, 0, 22)?.segment).toBe(0);
  });

  it("knows that half way in the picture is not half way along a limb that comes nearer", () => {
    const coming = handMade({
      points: [
        [0, 0, 0],
        [1, 0, 5],
      ],
      radii: [0.1, 0.1],
    });
    // Its ends are seen at 0 and 200 px; what is seen at 100 is 2/3 along.
    expect(pick(coming, near, 100, 0, 22)?.point[0]).toBeCloseTo(2 / 3, 12);
  });

  it("finds nothing behind the eye", () => {
    const behind = handMade({
      points: [
        [0, 0, 11],
        [1, 0, 12],
      ],
      radii: [0.1, 0.1],
    });
    expect(pick(behind, near, 0, 0, 1000)).toBeNull();
  });
});

describe("the heading of an axis", () => {
  it("is horizontal, in the plane in which it grew", () => {
    const axis = handMade({
      points: [
        [0, 0, 0],
        [0, 1, 0],
        [0.3, 1.5, 0.4],
      ],
      radii: [0.1, 0.1, 0.1],
    });
    expect(headingOf(axis, 0)).toEqual([0.6, 0, 0.8].map((v) => expect.closeTo(v, 12)));
  });

  it("is none for an upright one", () => {
    const upright = handMade({
      points: [
        [0, 0, 0],
        [1e-12, 1, 0],
      ],
      radii: [0.1, 0.1],
    });
    expect(headingOf(upright, 0)).toBeNull();
  });
});
