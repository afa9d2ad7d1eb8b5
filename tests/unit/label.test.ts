import { expect, it } from "vitest";
import { freest, type Obstacle } from "../../web/src/scene/label.ts";

const label = { width: 30, height: 12 };
const picture = { width: 400, height: 300 };
const across = (y: number, thickness: number): Obstacle => ({
  places: [
    { x: 0, y },
    { x: 400, y },
  ],
  thickness,
});

it("a label stands at the first place where it touches nothing", () => {
  const places = [100, 130, 160, 200].map((y) => ({ x: 200, y }));
  expect(freest(places, label, [across(100, 1)], picture)).toEqual({ x: 200, y: 130 });
  // A thick limb reaches farther than its middle line, even if that has but two points (plates 20 a and b).
  expect(freest(places, label, [across(100, 55)], picture)).toEqual({ x: 200, y: 200 });
});

it("a label is wider than high: it needs more room across than up and down", () => {
  const upright: Obstacle = {
    places: [
      { x: 200, y: 0 },
      { x: 200, y: 300 },
    ],
    thickness: 1,
  };
  expect(
    freest(
      [220, 250].map((x) => ({ x, y: 100 })),
      label,
      [upright],
      picture,
    ),
  ).toEqual({ x: 250, y: 100 });
});

it("a label stays in the picture, and takes the airiest place where none is free", () => {
  expect(
    freest(
      [
        { x: 395, y: 100 },
        { x: 300, y: 100 },
      ],
      label,
      [],
      picture,
    ),
  ).toEqual({ x: 300, y: 100 });
  const crowded = [110, 104, 96].map((y) => ({ x: 200, y }));
  expect(freest(crowded, label, [across(100, 1)], picture)).toEqual({ x: 200, y: 110 });
});
