/** The growth between two steps, so that a replay runs smoothly. For the eye only: nothing is computed from it. */
import type { Axes } from "./tube.ts";

/**
 * The shape between an age (`share` 0) and the next one (1): points move on straight lines, and what is new grows out of
 * where it is borne. Null where the axes of the two cannot be told to be the same.
 */
export function blend(from: Axes, to: Axes, share: number): Axes | null {
  const older = from.polylines;
  const { points, radii, offsets } = to.polylines;
  const starts = bearings(to);
  const blended = new Float64Array(points.length);
  const thickness = new Float64Array(radii.length);
  /** Where each point was, or where it comes from. */
  const origin = new Float64Array(points.length);
  for (let axis = 0; axis + 1 < offsets.length; axis++) {
    const first = offsets[axis] ?? 0;
    const end = offsets[axis + 1] ?? 0;
    const known = older.offsets[axis] ?? 0;
    const knownEnd = older.offsets[axis + 1] ?? 0;
    if (knownEnd - known > end - first) return null;
    for (let point = first; point < end; point++) {
      const at = known + point - first;
      const isKnown = at < knownEnd;
      // A new axis begins where its bearer ends; a new point where the one before it is.
      const bearer = point === first ? (starts[axis] ?? -1) : point - 1;
      const before = bearer >= 0 ? bearer : point;
      for (let k = 0; k < 3; k++) {
        const was = isKnown
          ? older.points[3 * at + k]
          : bearer >= 0
            ? origin[3 * before + k]
            : points[3 * point + k];
        origin[3 * point + k] = was ?? 0;
        blended[3 * point + k] = mix(was ?? 0, points[3 * point + k] ?? 0, share);
      }
      const radius = radii[point] ?? 0;
      thickness[point] = mix(isKnown ? (older.radii[at] ?? radius) : radius, radius, share);
    }
  }
  return {
    polylines: { points: blended, radii: thickness, offsets },
    segments: to.segments,
    report: { steps: mix(from.report.steps, to.report.steps, share) },
  };
}

/** For each axis the point of the segment that bears it; -1 on the ground. */
function bearings({ polylines: { offsets }, segments: { parent, point, axis } }: Axes): Int32Array {
  const starts = new Int32Array(Math.max(0, offsets.length - 1)).fill(-1);
  for (let segment = 0; segment < parent.length; segment++) {
    const own = axis[segment] ?? 0;
    const bearer = parent[segment] ?? -1;
    if (bearer >= 0 && axis[bearer] !== own) starts[own] = point[bearer] ?? -1;
  }
  return starts;
}

function mix(a: number, b: number, share: number): number {
  return a + share * (b - a);
}
