import { describe, expect, it } from "vitest";
import { boundsOf, union } from "../../web/src/geometry/bounds.ts";
import { between, frameOf, girthFor } from "../../web/src/geometry/frame.ts";
import { rulerWithin } from "../../web/src/geometry/ruler.ts";
import { handMade } from "./plants.ts";

describe("bounds", () => {
  const { polylines } = handMade({
    points: [
      [0, 0, 0],
      [1, 2, -3],
    ],
    radii: [0.5, 0.1],
  });

  it("hold every point with its radius", () => {
    expect(boundsOf(polylines)).toEqual({ min: [-0.5, -0.5, -3.1], max: [1.1, 2.1, 0.5] });
    expect(boundsOf(polylines, 2).max).toEqual([1.2, 2.2, 1]);
  });

  it("join", () => {
    const a = { min: [0, 0, 0], max: [1, 1, 1] } as const;
    const b = { min: [-1, 0.5, 0], max: [0, 2, 0] } as const;
    expect(union(a, b)).toEqual({ min: [-1, 0, 0], max: [1, 2, 1] });
  });
});

describe("the frame", () => {
  const upright = { min: [-0.1, 0, -0.1], max: [0.5, 1, 0.1] } as const;
  const hanging = { min: [-0.1, -0.8, -0.1], max: [1.5, 0.6, 0.1] } as const;

  const square = { width: 800, height: 800 };

  it.each([
    [360, 900],
    [800, 800],
    [1600, 700],
    [320, 200],
  ])("shows the whole box and the ground with air around, in %d x %d px", (across, down) => {
    for (const box of [upright, hanging]) {
      const { center, height, ground } = frameOf(box, { width: across, height: down }, 0.05);
      const width = (height * across) / down;
      expect(center[0] - width / 2).toBeLessThan(box.min[0] - 0.05 * width);
      expect(center[0] + width / 2).toBeGreaterThan(box.max[0] + 0.05 * width);
      expect(center[1] + height / 2).toBeGreaterThan(box.max[1] + 0.05 * height);
      expect(center[1] - height / 2).toBeLessThan(ground - 0.1 * height);
      expect(ground).toBeLessThanOrEqual(Math.max(box.min[1], 0));
    }
  });

  it("keeps the ground at the base of a plant that does not hang below it", () => {
    expect(frameOf(upright, square, 0.05).ground).toBe(0);
    expect(frameOf(hanging, square, 0.05).ground).toBeLessThan(-0.8);
  });

  it("takes in what is beside, and leaves the ground where it is", () => {
    const beside = { min: [-2, -1, 0], max: [0.1, 3, 0] } as const;
    const { center, height, ground } = frameOf(upright, square, 0.05, false, beside);
    expect(ground).toBe(0);
    expect(center[0] - height / 2).toBeLessThan(-2 - 0.05 * height);
    expect(center[0] + height / 2).toBeGreaterThan(0.5 + 0.05 * height);
    expect(center[1] - height / 2).toBeLessThan(-1 - 0.1 * height);
    expect(center[1] + height / 2).toBeGreaterThan(3 + 0.05 * height);
    // What lies within it changes nothing.
    const within = { min: [0, 0, 0], max: [0.4, 0.9, 0] } as const;
    expect(frameOf(upright, square, 0.05, false, within)).toEqual(frameOf(upright, square, 0.05));
  });

  it("exists even for a plant without size", () => {
    const frame = frameOf({ min: [0, 0, 0], max: [0, 0, 0] }, square, 0);
    expect(frame.height).toBeGreaterThan(0);
  });

  it("passes evenly from one to the next", () => {
    const from = { center: [0, 0, 0], height: 1, ground: 0 } as const;
    const to = { center: [2, 4, 0], height: 4, ground: -1 } as const;
    expect(between(from, to, 0)).toEqual(from);
    expect(between(from, to, 1)).toEqual(to);
    expect(between(from, to, 0.5)).toEqual({ center: [1, 2, 0], height: 2, ground: -0.5 });
  });
});

describe("girth", () => {
  it("is true where limbs are thick enough, else a round factor", () => {
    expect(girthFor(0.05, 1)).toBe(1);
    expect(girthFor(0.005, 1.5)).toBe(3);
    expect(girthFor(0.0005, 1)).toBe(20);
    expect(girthFor(0, 1)).toBe(1e4);
    expect(girthFor(0, 0)).toBe(1);
  });
});

describe("the ruler", () => {
  it.each([
    [0.37, 0.2, "20 cm"],
    [1, 1, "1 m"],
    [0.999, 0.5, "50 cm"],
    [0.01, 0.01, "1 cm"],
    [0.0099, 0.005, "5 mm"],
    [0.001, 0.001, "1 mm"],
    [3e-4, 2e-4, "200 µm"],
    [4e-7, 2e-7, "0.2 µm"],
    [7300, 5000, "5 km"],
    [999, 500, "500 m"],
  ])("within %d m is %d m, shown as %s", (most, length, text) => {
    expect(rulerWithin(most)).toEqual({ length, text });
  });

  it("is never longer than allowed and never shorter than 40 % of it", () => {
    for (let exponent = -6; exponent < 6; exponent += 0.0137) {
      const most = 10 ** exponent;
      const { length } = rulerWithin(most);
      expect(length).toBeLessThanOrEqual(most);
      expect(length / most).toBeGreaterThanOrEqual(0.4 - 1e-12);
    }
  });
});
