import { describe, expect, it } from "vitest";
import { modelOf } from "../../web/src/geometry/model.ts";
import type { Axes } from "../../web/src/geometry/tube.ts";
import { handMade } from "./plants.ts";

const made = handMade(
  {
    points: [
      [0, 0, 0],
      [0, 1, 0],
      [1, 1, 0],
    ],
    radii: [0.1, 0.1, 0.1],
  },
  {
    points: [
      [1, 1, 0],
      [1, 1, 2],
    ],
    radii: [0.05, 0.05],
    on: 1,
  },
);
const plant: Axes = { ...made, segments: { ...made.segments, mass: Float64Array.from([8, 2, 1]) } };

describe("the model of a plant", () => {
  const model = modelOf(plant, 100, "distal");

  it("has a straight rod for each segment", () => {
    expect([...model.rods.subarray(0, 12)]).toEqual([0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0]);
    expect([...model.rods.subarray(12)]).toEqual([1, 1, 0, 1, 1, 2]);
  });

  it("has a spring at each base joint, across the plane in which it bends", () => {
    expect([...model.joints]).toEqual([0, 0, 0, 0, 1, 0, 1, 1, 0]);
    expect([...model.pivots].map((value) => value + 0)).toEqual([0, 0, 1, 0, 0, 1, -1, 0, 0]);
  });

  it("has the masses at the far ends, dots whose cubes are as they", () => {
    const [base = 1, first = 0, second = 0, attached = 1, tip = 0] = model.dots;
    expect([base, attached]).toEqual([0, 0]);
    expect((first / second) ** 3).toBeCloseTo(4, 9);
    expect((first / tip) ** 3).toBeCloseTo(8, 9);
    expect(first).toBeLessThan(model.spring);
  });

  it("has half of them at each end, where the rod is cut so", () => {
    const { dots } = modelOf(plant, 100, "ends");
    const [base = 0, first = 0, second = 0, attached = 0, tip = 0] = dots;
    expect((first / base) ** 3).toBeCloseTo(5 / 4, 9);
    expect((first / second) ** 3).toBeCloseTo(5, 9);
    expect(attached).toBeCloseTo(tip, 12);
  });

  it("keeps its springs apart from each other, and to be seen in the whole", () => {
    expect(model.spring).toBeLessThan(0.5);
    expect(modelOf(plant, 1000, "ends").spring).toBe(3);
    expect(modelOf(plant, 1, "ends").spring).toBeLessThan(0.02);
  });

  it("of a plant without mass has no dots", () => {
    expect([...modelOf(made, 1, "ends").dots]).toEqual([0, 0, 0, 0, 0]);
  });
});
