import { describe, expect, it } from "vitest";
import { type Detail, detailFor, ringsOf, sidesFor } from "../../web/src/geometry/detail.ts";
import type { Polylines } from "../../web/src/plant/plant.ts";

/** So many axes of so many segments, all as thick. */
function axes(count: number, segments: number): Polylines {
  const offsets = Uint32Array.from({ length: count + 1 }, (_, axis) => axis * (segments + 1));
  return { points: new Float64Array(0), radii: new Float64Array(count * (segments + 1)).fill(1), offsets };
}

function vertices(count: number, segments: number, detail: Detail): number {
  return count * (ringsOf(segments, detail, true) * detail.sides + 2);
}

describe("the detail of a plant", () => {
  it("is the finest for a single axis", () => {
    expect(detailFor(axes(1, 40))).toMatchObject({ rings: 5, sides: 32 });
  });

  it.each([
    [1, 100_000],
    [31, 10],
    [1023, 10],
    [8191, 12],
    [16_383, 6],
    [50_000, 2],
    [100_000, 1],
  ])("keeps %i axes of %i segments below a million vertices, mostly far below", (count, segments) => {
    const detail = detailFor(axes(count, segments));
    const most = count <= 16_383 ? 262_000 : 1_000_000;
    expect(vertices(count, segments, detail)).toBeLessThan(most);
  });

  it("never gets finer with more axes", () => {
    const sides = [1, 10, 100, 1000, 10_000].map((count) => detailFor(axes(count, 10)).sides);
    expect(sides).toEqual(sides.toSorted((a, b) => b - a));
    expect(sides.at(-1)).toBe(8);
  });

  it("keeps thick limbs round among very many thin ones", () => {
    const many = axes(8191, 12);
    many.radii.fill(0.03, 13);
    const detail = detailFor(many);
    expect(sidesFor(1, detail)).toBeGreaterThanOrEqual(8);
    expect(sidesFor(0.03, detail)).toBe(3);
  });

  it("gives thin limbs fewer corners, but at least a third", () => {
    const detail = detailFor(axes(1, 40));
    expect(sidesFor(1, detail)).toBe(32);
    expect(sidesFor(0.25, detail)).toBe(16);
    expect(sidesFor(0, detail)).toBe(11);
  });
});
