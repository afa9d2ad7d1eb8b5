/** Quantities along a path through the plant, from the ground to a tip. */
import { headingOf } from "../geometry/pick.ts";
import type { Plant } from "../plant/plant.ts";

/** What is plotted along the axis. */
export const quantities = ["angle", "curvature", "moment", "stress"] as const;
export type Quantity = (typeof quantities)[number];

/** The plain unit of each. */
export const units: Readonly<Record<Quantity, string>> = {
  angle: "deg",
  curvature: "1/m",
  moment: "N m",
  stress: "Pa",
};

/** One entry a segment of the path, from the base on. */
export interface Profile {
  /** The segments' numbers in the plant. */
  readonly segments: readonly number[];
  /** How far along the path each base joint is, m; and where the path ends. */
  readonly distance: readonly number[];
  readonly length: number;
  /** Direction of the segment above the horizontal in degrees; the others are those of its base joint. */
  readonly values: Readonly<Record<Quantity, readonly number[]>>;
}

/**
 * Along the path through a segment, or without one through the first axis that stands on the ground: beyond it, at every
 * fork, the thicker child.
 */
export function profileOf(plant: Plant, through: number | null): Profile {
  const { segments, polylines } = plant;
  const path = pathThrough(plant, through);
  const distance: number[] = [];
  let length = 0;
  for (const segment of path) {
    distance.push(length);
    length += segments.length[segment] ?? 0;
  }
  // In the plane of the picture x is the horizontal direction, also for what leans over backwards.
  const own = path[path.length - 1];
  const isPlanar = plant.params.arrangement.pattern === "single";
  const heading = (isPlanar || own === undefined ? null : headingOf(plant, own)) ?? [1, 0, 0];
  const angle = path.map((segment) => {
    const end = 3 * (segments.point[segment] ?? 0);
    const [x, y, z] = [0, 1, 2].map(
      (k) => (polylines.points[end + k] ?? 0) - (polylines.points[end - 3 + k] ?? 0),
    ) as [number, number, number];
    return (Math.atan2(y, x * heading[0] + z * heading[2]) * 180) / Math.PI;
  });
  const of = (array: Float64Array) => path.map((segment) => array[segment] ?? 0);
  const values = {
    angle: unwrapped(angle),
    curvature: of(segments.curvature),
    moment: of(segments.moment),
    stress: of(segments.stress),
  };
  return { segments: path, distance, length, values };
}

function pathThrough({ segments, params }: Plant, through: number | null): number[] {
  const count = segments.parent.length;
  if (count === 0) return [];
  // Around a stem the first axis is the stem, which is rigid.
  const first = params.arrangement.pattern === "stem" ? Math.max(0, segments.axis.indexOf(1)) : 0;
  const start = through !== null && through < count ? through : first;
  const path: number[] = [];
  for (let segment = start; segment >= 0; segment = segments.parent[segment] ?? -1) {
    if (segment < first) break;
    path.push(segment);
  }
  path.reverse();
  const thickest = new Map<number, number>();
  for (let segment = 0; segment < count; segment++) {
    const parent = segments.parent[segment] ?? -1;
    const other = thickest.get(parent);
    const radius = (one: number) => segments.radius[one] ?? 0;
    if (other === undefined || radius(segment) > radius(other)) thickest.set(parent, segment);
  }
  for (let next = thickest.get(start); next !== undefined; next = thickest.get(next)) path.push(next);
  return path;
}

/** Without jumps of a whole turn. */
function unwrapped(angles: readonly number[]): number[] {
  const smooth: number[] = [];
  for (const angle of angles) {
    const last = smooth[smooth.length - 1] ?? angle;
    smooth.push(angle - 360 * Math.round((angle - last) / 360));
  }
  return smooth;
}

/** The entry of the path that is nearest to a distance along it. */
export function indexAt({ distance, length }: Profile, place: number): number {
  let [low, high] = [0, distance.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((distance[middle] ?? length) <= place) low = middle;
    else high = middle - 1;
  }
  return Math.max(0, low);
}
