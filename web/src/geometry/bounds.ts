/** Axis-aligned boxes around plants. */
import type { Polylines } from "../plant/plant.ts";

/** A point or a vector: x to the right, y up, z towards the viewer, m. */
export type Vector = readonly [x: number, y: number, z: number];

/** An axis-aligned box, m. */
export interface Bounds {
  readonly min: Vector;
  readonly max: Vector;
}

/** The smallest box around all points of all axes, each thickened by its radius times `girth`. */
export function boundsOf({ points, radii }: Polylines, girth = 1): Bounds {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let point = 0; point < radii.length; point++) {
    const radius = (radii[point] ?? 0) * girth;
    for (const k of [0, 1, 2] as const) {
      const value = points[3 * point + k] ?? 0;
      min[k] = Math.min(min[k], value - radius);
      max[k] = Math.max(max[k], value + radius);
    }
  }
  return { min, max };
}

/** The smallest box around both. */
export function union(a: Bounds, b: Bounds): Bounds {
  return { min: each(Math.min, a.min, b.min), max: each(Math.max, a.max, b.max) };
}

function each(choose: (a: number, b: number) => number, a: Vector, b: Vector): Vector {
  return [choose(a[0], b[0]), choose(a[1], b[1]), choose(a[2], b[2])];
}
