/** Small plants made by hand, for tests that need no solver. */
import type { Axes } from "../../web/src/geometry/tube.ts";

/** Points and radii of one axis; `on` is the segment that bears it (-1: the ground). */
export interface HandMadeAxis {
  points: [number, number, number][];
  radii: number[];
  on?: number;
}

/** A plant of the given axes, in which segment i was born in growth step i + 1. */
export function handMade(...axes: HandMadeAxis[]): Axes {
  const points = axes.flatMap((axis) => axis.points.flat());
  const radii = axes.flatMap((axis) => axis.radii);
  const offsets = [0];
  const parent: number[] = [];
  const point: number[] = [];
  const owner: number[] = [];
  for (const [index, { points, on = -1 }] of axes.entries()) {
    const first = offsets[index] ?? 0;
    for (let k = 1; k < points.length; k++) {
      parent.push(k === 1 ? on : parent.length - 1);
      point.push(first + k);
      owner.push(index);
    }
    offsets.push(first + points.length);
  }
  const count = parent.length;
  const zeros = () => new Float64Array(count);
  return {
    polylines: {
      points: Float64Array.from(points),
      radii: Float64Array.from(radii),
      offsets: Uint32Array.from(offsets),
    },
    segments: {
      parent: Int32Array.from(parent),
      point: Uint32Array.from(point),
      axis: Uint32Array.from(owner),
      order: new Uint32Array(count),
      birth: Uint32Array.from(parent, (_, segment) => segment + 1),
      length: zeros(),
      radius: zeros(),
      mass: zeros(),
      rotation: new Float64Array(4 * count),
      moment: zeros(),
      twistMoment: zeros(),
      curvature: zeros(),
      restCurvature: zeros(),
      stress: zeros(),
    },
    report: { steps: count },
  };
}
