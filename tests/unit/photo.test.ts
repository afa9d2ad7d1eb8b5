/** Where a photo lies in the plane of the picture. */
import fc from "fast-check";
import { expect, test } from "vitest";
import { changedAround, movedTo, toPhoto, toWorld } from "../../web/src/study/photo.ts";

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const frame = fc.record({
  x: number(-5, 5),
  y: number(-5, 5),
  size: number(1e-4, 1e-2),
  turn: number(-3, 3),
});
const pixel = fc.record({ u: number(0, 2400), v: number(0, 2400) });

test("upright, its upper left corner is its place, and down is down", () => {
  const upright = { x: 1, y: 2, size: 0.01, turn: 0 };
  expect(toWorld(upright, { u: 0, v: 0 })).toEqual({ x: 1, y: 2 });
  expect(toWorld(upright, { u: 100, v: 50 })).toEqual({ x: 2, y: 1.5 });
});

test("points of the photo go to the world and back", () => {
  fc.assert(
    fc.property(frame, pixel, (frame, pixel) => {
      const back = toPhoto(frame, toWorld(frame, pixel));
      expect(back.u).toBeCloseTo(pixel.u, 6);
      expect(back.v).toBeCloseTo(pixel.v, 6);
    }),
  );
});

test("moved, a point is where it was wanted; brought to scale or turned, a place stays", () => {
  fc.assert(
    fc.property(frame, pixel, number(1e-4, 1e-2), number(-1, 1), (frame, pixel, size, turn) => {
      const moved = toWorld(movedTo(frame, pixel, { x: 0.3, y: -0.2 }), pixel);
      expect(moved.x).toBeCloseTo(0.3, 9);
      expect(moved.y).toBeCloseTo(-0.2, 9);
      const place = toWorld(frame, pixel);
      const changed = changedAround(frame, place, { size, turn });
      expect([changed.size, changed.turn]).toEqual([size, turn]);
      const still = toWorld(changed, pixel);
      expect(still.x).toBeCloseTo(place.x, 9);
      expect(still.y).toBeCloseTo(place.y, 9);
    }),
  );
});
