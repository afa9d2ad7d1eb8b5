/** The plant as the paper's figures draw it: rigid segments, springs that join them, and masses. */
import type { Vector } from "./bounds.ts";
import type { Axes } from "./tube.ts";

/** Up to this many segments can be told apart as a model. */
export const mostModelled = 4000;

/** Diagram of n segments, m. All coordinates x, y, z. */
export interface Model {
  /** Half the thickness of a segment's rod. */
  readonly rod: number;
  /** Start and end of each rod; shape 6n. */
  readonly rods: Float64Array;
  /** Radius of the springs. */
  readonly spring: number;
  /** Centre of the spring at each segment's base joint; shape 3n. */
  readonly joints: Float64Array;
  /** Unit vector about which each spring turns; shape 3n. */
  readonly pivots: Float64Array;
  /** Where masses are: the points of all axes; shape 3P. */
  readonly masses: Float64Array;
  /** Radius of each mass's dot: its cube is as the mass; 0 where there is none; shape P. */
  readonly dots: Float64Array;
}

/** Where the mass of a segment is thought to be: at its far end, or half at each. */
export type Lumping = "distal" | "ends";

/** The diagram of a plant about as large as `extent`, m. */
export function modelOf({ polylines, segments }: Axes, extent: number, lumping: Lumping): Model {
  const { points, radii } = polylines;
  const count = segments.point.length;
  const rods = new Float64Array(6 * count);
  const joints = new Float64Array(3 * count);
  const pivots = new Float64Array(3 * count);
  const lumps = new Float64Array(radii.length);
  const lengths = new Float64Array(count);
  for (let segment = 0; segment < count; segment++) {
    const end = segments.point[segment] ?? 0;
    rods.set(points.subarray(3 * end - 3, 3 * end + 3), 6 * segment);
    joints.set(points.subarray(3 * end - 3, 3 * end), 3 * segment);
    const step = [0, 1, 2].map((k) => (points[3 * end + k] ?? 0) - (points[3 * end - 3 + k] ?? 0));
    pivots.set(pivotOf(step as [number, number, number]), 3 * segment);
    lengths[segment] = Math.hypot(...step);
    const mass = segments.mass[segment] ?? 0;
    const near = lumping === "ends" ? mass / 2 : 0;
    lumps[end - 1] = (lumps[end - 1] ?? 0) + near;
    lumps[end] = (lumps[end] ?? 0) + mass - near;
  }
  // The typical segment has room for its spring and its mass.
  const typical = lengths.sort()[Math.floor(count / 2)] ?? 0;
  const size = Math.max(Math.min(0.28 * typical, 0.016 * extent), 0.003 * extent);
  const heaviest = lumps.reduce((most, mass) => Math.max(most, mass), 0);
  return {
    rod: 0.25 * size,
    rods,
    spring: size,
    joints,
    pivots,
    masses: points,
    dots: lumps.map((mass) => (mass > 0 ? 0.62 * size * Math.cbrt(mass / heaviest) : 0)),
  };
}

/** The horizontal direction across a segment, about which weights bend it; an upright one is bent in the plane of the picture. */
function pivotOf([x, y, z]: Vector): Vector {
  const size = Math.hypot(x, z);
  return size > 1e-9 * Math.abs(y) && size > 0 ? [-z / size, 0, x / size] : [0, 0, 1];
}
