/** What is measured on a plant: at one axis, which stands for all. */
import type { Plant } from "../plant/plant.ts";
import type { Vector } from "./bounds.ts";

/** Measures of an axis. */
export interface Measures {
  /** Its number. */
  readonly axis: number;
  /** Where it is attached, m. */
  readonly base: Vector;
  /** From there to its tip, m. */
  readonly tip: Vector;
  /** Along the axis, m. */
  readonly length: number;
  /** Where its tip points, degrees above the horizontal. */
  readonly tipElevation: number;
  /** Unit vector, horizontal: the axis's elevation is counted from here. */
  readonly heading: Vector;
}

/** Measures the main axis; of axes around a stem the lowest one, which is the oldest. */
export function measure({ polylines, segments, params }: Plant): Measures {
  const { points, offsets } = polylines;
  const bornes = offsets.length > 2 && params.arrangement.pattern === "stem";
  const axis = bornes ? 1 : 0;
  const at = (point: number): Vector => [
    points[3 * point] ?? 0,
    points[3 * point + 1] ?? 0,
    points[3 * point + 2] ?? 0,
  ];
  const first = offsets[axis] ?? 0;
  const last = Math.max(first, (offsets[axis + 1] ?? 0) - 1);
  const base = at(first);
  const step = minus(at(last), at(Math.max(first, last - 1)));
  return {
    axis,
    base,
    tip: minus(at(last), base),
    length: segments.length.reduce(
      (sum, own, segment) => sum + (segments.axis[segment] === axis ? own : 0),
      0,
    ),
    tipElevation: (Math.atan2(step[1], Math.hypot(step[0], step[2])) * 180) / Math.PI,
    heading: headingOf(minus(at(Math.min(last, first + 1)), base), params.axis.elevation),
  };
}

/** Along the wood from the base to where a segment begins, m; around a stem from there. */
export function pathTo({ segments, params }: Plant, segment: number): number {
  let path = 0;
  let bearer = segments.parent[segment] ?? -1;
  while (bearer >= 0 && !(params.arrangement.pattern === "stem" && segments.axis[bearer] === 0)) {
    path += segments.length[bearer] ?? 0;
    bearer = segments.parent[bearer] ?? -1;
  }
  return path;
}

/** The horizontal part of a direction; an axis that leans over backwards (beyond 90 degrees) heads the other way. */
function headingOf([x, , z]: Vector, elevation: number): Vector {
  const size = Math.hypot(x, z);
  const sign = Math.abs(elevation) > 90 ? -1 : 1;
  return size > 0 ? [(sign * x) / size, 0, (sign * z) / size] : [1, 0, 0];
}

function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}
