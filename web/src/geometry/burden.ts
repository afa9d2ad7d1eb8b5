/** What a plant carries, so that it is seen as what it weighs: leaves of the area that meets the wind, fruit of its volume. */
import type { Plant } from "../plant/plant.ts";
import { boundsOf } from "./bounds.ts";
import { type Foliage, foliageOf, habitFor, type LeafHabit } from "./foliage.ts";
import type { Axes } from "./tube.ts";

/** How the leaves of a plant stand, and how broad they are for their length. */
export interface Clothing {
  readonly habit: LeafHabit;
  /** Width of a leaf over that of a broad one of its length: needles are slender. */
  readonly slenderness: number;
}

/** Fruit or flowers; F of them. */
export interface Fruits {
  /** Where each hangs: the middle, x, y, z in m; shape 3F. */
  readonly centers: Float32Array;
  /** m */
  readonly radius: number;
  /** Whether they are flowers: what weighs a few grams is. */
  readonly areFlowers: boolean;
}

/** Area of a leaf with a length of 1, as it is drawn. */
const bladeArea = 0.31;
/** Leaves, or needles, that are drawn at most: beyond, they are fewer and larger ones of the same area together. */
const most = { leaves: 2600, needles: 6000 };
/** Length of a leaf where there is room for all: so much of the plant's extent, and not above, m. */
const longest = { share: { leaves: 1 / 15, needles: 1 / 32 }, length: 0.1 };
/** Up to this area per mass leaves are needles, m2/kg. */
const needles = 2;
/** Fresh fruit, kg/m3. */
const fruitDensity = 850;
/** Up to this mass it is a flower, kg. */
const flower = 0.005;

/** How the leaves of a plant stand when it is grown; null where it bears none. */
export function clothingOf(grown: Plant): Clothing | null {
  const { foliage, foliageAge, foliageArea } = grown.params.loads;
  if (!(foliage > 0) || !(foliageArea > 0)) return null;
  const { length, birth, axis } = grown.segments;
  const bare = grown.params.arrangement.pattern === "single" ? 0 : 1;
  const young = length.reduce((sum, own, segment) => {
    const bears = (axis[segment] ?? 0) >= bare && grown.report.steps - (birth[segment] ?? 0) < foliageAge;
    return sum + (bears ? own : 0);
  }, 0);
  if (young === 0) return null;
  const areNeedles = foliageArea < needles;
  const slenderness = areNeedles ? 0.22 : 1;
  const { min, max } = boundsOf(grown.polylines, 0);
  const extent = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const area = bladeArea * slenderness;
  const perMeter = foliage * foliageArea;
  const kind = areNeedles ? "needles" : "leaves";
  const wished = Math.min(longest.share[kind] * extent, longest.length);
  const spacing = Math.max((area * wished ** 2) / perMeter, young / most[kind]);
  const size = Math.sqrt((perMeter * spacing) / area);
  const wishes = { youth: foliageAge, spacing, size, bare, angle: areNeedles ? 40 : 55 };
  return { habit: habitFor(grown, wishes), slenderness };
}

/** The leaves of a plant at any age. */
export function leavesOf(axes: Axes, { habit, slenderness }: Clothing, girth: number): Foliage {
  const foliage = foliageOf(axes, habit, girth);
  for (let leaf = 0; leaf < foliage.count; leaf++) {
    for (let k = 0; k < 3; k++)
      foliage.matrices[16 * leaf + k] = slenderness * (foliage.matrices[16 * leaf + k] ?? 0);
  }
  return foliage;
}

/** The fruit at all free tips; null where there is none. */
export function fruitsOf({ polylines, segments }: Axes, tipMass: number): Fruits | null {
  if (!(tipMass > 0)) return null;
  const { points, offsets } = polylines;
  // Where something stands on an axis's last point, it has ended in a fork.
  const bearing = new Set<number>();
  for (const parent of segments.parent) bearing.add(segments.point[parent] ?? -1);
  const radius = Math.cbrt((3 * tipMass) / (4 * Math.PI * fruitDensity));
  const centers: number[] = [];
  for (let axis = 0; axis + 1 < offsets.length; axis++) {
    const last = (offsets[axis + 1] ?? 0) - 1;
    if (bearing.has(last)) continue;
    const at = 3 * last;
    centers.push(points[at] ?? 0, (points[at + 1] ?? 0) - radius, points[at + 2] ?? 0);
  }
  return { centers: Float32Array.from(centers), radius, areFlowers: tipMass < flower };
}
