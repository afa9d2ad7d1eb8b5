/** Lines over the picture are cut at its edges. */
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { clip } from "../../web/src/geometry/clip.ts";

const [width, height] = [700, 420];
/** How far beyond the edges lines go on. */
const margin = 50;
const coordinate = fc.oneof(
  fc.double({ min: -1e3, max: 1e3, noNaN: true }),
  fc.double({ min: -1e9, max: 1e9, noNaN: true }),
);
const line = fc.array(fc.record({ x: coordinate, y: coordinate }), { maxLength: 20 });

describe("a line over the picture", () => {
  it("that is on it stays as it is", () => {
    const inside = [
      { x: 0, y: 0 },
      { x: 700, y: 420 },
      { x: 350, y: -40 },
    ];
    expect(clip(inside, width, height)).toEqual([inside]);
    expect(clip([{ x: 1, y: 1 }], width, height)).toEqual([]);
  });

  it("that leaves it and comes back is two lines", () => {
    const around = [
      { x: 650, y: 100 },
      { x: 1e6, y: 100 },
      { x: 1e6, y: 200 },
      { x: 650, y: 200 },
    ];
    const [there, back, ...more] = clip(around, width, height);
    expect(more).toEqual([]);
    expect(there?.map(({ y }) => y)).toEqual([100, 100]);
    expect(there?.[1]?.x).toBeCloseTo(width + margin, 6);
    expect(back?.[0]?.x).toBeCloseTo(width + margin, 6);
    expect(back?.[1]).toEqual({ x: 650, y: 200 });
  });

  it("is nowhere where its places are no numbers", () => {
    const lost = [
      { x: 1, y: 1 },
      { x: Number.NaN, y: 3 },
      { x: Number.POSITIVE_INFINITY, y: 3 },
    ];
    expect(clip(lost, width, height)).toEqual([]);
  });

  it("never goes farther, and leaves out nothing of what is seen", () => {
    fc.assert(
      fc.property(line, fc.nat({ max: 18 }), fc.double({ min: 0, max: 1, noNaN: true }), (all, at, share) => {
        const parts = clip(all, width, height);
        // A coordinate is a sum of numbers up to 1e9: rounding is up to a few 1e-7.
        const near = 1e-5;
        for (const { x, y } of parts.flat()) {
          expect(Math.abs(x - width / 2)).toBeLessThanOrEqual(width / 2 + margin + near);
          expect(Math.abs(y - height / 2)).toBeLessThanOrEqual(height / 2 + margin + near);
        }
        const [from, to] = [all[at], all[at + 1]];
        if (!from || !to) return;
        const x = from.x + share * (to.x - from.x);
        const y = from.y + share * (to.y - from.y);
        if (x < 0 || x > width || y < 0 || y > height || (from.x === to.x && from.y === to.y)) return;
        const isSeen = parts.some((part) =>
          part.some((end, k) => k > 0 && away(part[k - 1], end, x, y) < 1e-3),
        );
        expect(isSeen).toBe(true);
      }),
    );
  });
});

/** How far a place is from a stretch of a line, px. */
function away(
  from: { x: number; y: number } | undefined,
  to: { x: number; y: number },
  x: number,
  y: number,
) {
  if (!from) return Number.POSITIVE_INFINITY;
  const [across, up] = [to.x - from.x, to.y - from.y];
  const square = across * across + up * up;
  const share = square === 0 ? 0 : ((x - from.x) * across + (y - from.y) * up) / square;
  const near = Math.min(1, Math.max(0, share));
  return Math.hypot(from.x + near * across - x, from.y + near * up - y);
}
