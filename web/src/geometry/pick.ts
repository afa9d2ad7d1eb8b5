/** Finding the limb under a pointer from the centre lines alone. */
import type { Vector } from "./bounds.ts";
import type { Axes } from "./tube.ts";

/** A place on a plant. */
export interface Pick {
  /** Index of the segment. */
  readonly segment: number;
  /** On its centre line, m. */
  readonly point: Vector;
}

/** How a plant is seen, for picking. */
export interface Sight {
  /** From homogeneous coordinates in m to the picture in px: x and y after division by w. 16 numbers, column by column. */
  readonly toPicture: ArrayLike<number>;
  /** px a metre at depth w = `depth`. */
  readonly scale: number;
  readonly depth: number;
  /** How many times too thick limbs are drawn. */
  readonly girth: number;
}

/**
 * The place whose limb is nearest to a point of the picture, if it is within `reach` px of the limb's surface; of limbs that
 * lie over each other, the nearest to the eye.
 */
export function pick(
  { polylines, segments }: Axes,
  sight: Sight,
  x: number,
  y: number,
  reach: number,
): Pick | null {
  const { points, radii } = polylines;
  const seen = project(points, sight.toPicture);
  const m = sight.toPicture;
  /** By how much w falls a metre towards the eye. */
  const deepening = Math.hypot(m[3] ?? 0, m[7] ?? 0, m[11] ?? 0);
  let best: { segment: number; share: number; beside: number; away: number; depth: number } | null = null;
  for (let segment = 0; segment < segments.point.length; segment++) {
    const end = segments.point[segment] ?? 0;
    const at = 3 * end;
    const [x0, y0, w0] = [seen[at - 3] ?? 0, seen[at - 2] ?? 0, seen[at - 1] ?? 0];
    const [x1, y1, w1] = [seen[at] ?? 0, seen[at + 1] ?? 0, seen[at + 2] ?? 0];
    if (w0 <= 0 || w1 <= 0) continue;
    const squared = (x1 - x0) ** 2 + (y1 - y0) ** 2;
    const along = squared > 0 ? ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / squared : 0;
    const part = Math.min(1, Math.max(0, along));
    // What is half way in the picture is nearer than half way in the world, if the far end is farther away.
    const share = part / w1 / ((1 - part) / w0 + part / w1);
    const depth = w0 + share * (w1 - w0);
    const radius = mix(radii[end - 1] ?? 0, radii[end] ?? 0, share) * sight.girth;
    const away = Math.hypot(x0 + part * (x1 - x0) - x, y0 + part * (y1 - y0) - y);
    const beside = Math.max(0, away - (radius * sight.scale * sight.depth) / depth);
    const before = best ? best.depth - depth : 0;
    // Of limbs under the pointer the one in front; along one limb, the place whose middle is nearest.
    const isOther = beside === 0 && best?.beside === 0 && Math.abs(before) > 2 * radius * deepening;
    const isBetter = best === null ? beside < reach : isOther ? before > 0 : nearer(best, beside, away);
    if (isBetter) best = { segment, share, beside, away, depth };
  }
  if (!best) return null;
  const end = segments.point[best.segment] ?? 0;
  const { share } = best;
  const at = (k: number) => mix(points[3 * end - 3 + k] ?? 0, points[3 * end + k] ?? 0, share);
  return { segment: best.segment, point: [at(0), at(1), at(2)] };
}

/**
 * The horizontal direction of the vertical plane in which the axis of a segment grew; null where it stands upright and has none.
 */
export function headingOf(
  { polylines: { points, offsets }, segments }: Axes,
  segment: number,
): Vector | null {
  const axis = segments.axis[segment] ?? 0;
  const first = 3 * (offsets[axis] ?? 0);
  const end = 3 * (offsets[axis + 1] ?? 0);
  let farthest: Vector | null = null;
  let most = 0;
  let length = 0;
  for (let at = first; at < end; at += 3) {
    const [x, y, z] = [0, 1, 2].map((k) => (points[at + k] ?? 0) - (points[first + k] ?? 0)) as [
      number,
      number,
      number,
    ];
    const size = Math.hypot(x, z);
    length = Math.max(length, size, Math.abs(y));
    if (size <= most) continue;
    most = size;
    farthest = [x / size, 0, z / size];
  }
  return most > 1e-6 * length ? farthest : null;
}

/** x and y in px and the depth w of every point. */
function project(points: Float64Array, m: ArrayLike<number>): Float64Array {
  const seen = new Float64Array(points.length);
  const row = (k: number, x: number, y: number, z: number) =>
    (m[k] ?? 0) * x + (m[k + 4] ?? 0) * y + (m[k + 8] ?? 0) * z + (m[k + 12] ?? 0);
  for (let at = 0; at < points.length; at += 3) {
    const [x, y, z] = [points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0];
    const w = row(3, x, y, z);
    seen[at] = row(0, x, y, z) / w;
    seen[at + 1] = row(1, x, y, z) / w;
    seen[at + 2] = w;
  }
  return seen;
}

/** Whether a place is nearer to the pointer than another: by its surface, then by its middle. */
function nearer(than: { beside: number; away: number }, beside: number, away: number): boolean {
  return beside < than.beside || (beside === than.beside && away < than.away);
}

function mix(a: number, b: number, share: number): number {
  return a + share * (b - a);
}
