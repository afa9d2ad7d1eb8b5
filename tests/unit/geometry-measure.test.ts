import { describe, expect, it } from "vitest";
import { measure } from "../../web/src/geometry/measure.ts";
import { complete } from "../../web/src/params/params.ts";
import type { Plant } from "../../web/src/plant/plant.ts";
import { type HandMadeAxis, handMade } from "./plants.ts";

function plant(input: Parameters<typeof complete>[0], ...axes: HandMadeAxis[]): Plant {
  return { ...handMade(...axes), params: complete(input), version: "" } as Plant;
}

const upright: HandMadeAxis = {
  points: [
    [0, 0, 0],
    [0, 1, 0],
  ],
  radii: [0.1, 0.1],
};
const branch: HandMadeAxis = {
  points: [
    [0, 1, 0],
    [0, 1, -1],
    [0, 0, -1],
  ],
  radii: [0.1, 0.1, 0.1],
  on: 0,
};

describe("measures", () => {
  it("are those of the main axis, from its base", () => {
    const { axis, base, tip, tipElevation } = measure(plant({}, upright, branch));
    expect({ axis, base, tip, tipElevation }).toEqual({
      axis: 0,
      base: [0, 0, 0],
      tip: [0, 1, 0],
      tipElevation: 90,
    });
  });

  it("around a stem are those of the lowest axis", () => {
    const { axis, base, tip, tipElevation, heading } = measure(
      plant({ arrangement: { pattern: "stem" } }, upright, branch),
    );
    expect({ axis, base, tip, tipElevation }).toEqual({
      axis: 1,
      base: [0, 1, 0],
      tip: [0, -1, -1],
      tipElevation: -90,
    });
    expect(heading[2]).toBe(-1);
  });

  it("count the elevation from the other side where an axis leans over backwards", () => {
    const backwards: HandMadeAxis = {
      points: [
        [0, 0, 0],
        [-1, 1, 0],
      ],
      radii: [0.1, 0.1],
    };
    expect(measure(plant({ axis: { elevation: 135 } }, backwards)).heading[0]).toBe(1);
    expect(measure(plant({ axis: { elevation: 90 } }, upright)).heading).toEqual([1, 0, 0]);
  });
});
