/** How finely limbs are cut into triangles. */
import type { Polylines } from "../plant/plant.ts";

/** How finely limbs are cut. */
export interface Detail {
  /** Rings a segment. */
  readonly rings: number;
  /** Corners of a ring of the thickest limb, and of thin ones. */
  readonly sides: number;
  readonly leastSides: number;
  /** Rings of a rounded end, and extra ones where a limb leaves another. */
  readonly cap: number;
  /** Only each so manieth point of an axis is followed. */
  readonly stride: number;
}

/** From fine to coarse. */
const tiers: readonly [Detail, ...Detail[]] = [
  { rings: 5, sides: 32, leastSides: 11, cap: 8, stride: 1 },
  { rings: 3, sides: 16, leastSides: 6, cap: 5, stride: 1 },
  { rings: 2, sides: 12, leastSides: 4, cap: 3, stride: 1 },
  { rings: 1, sides: 12, leastSides: 3, cap: 2, stride: 1 },
  { rings: 1, sides: 10, leastSides: 3, cap: 1, stride: 2 },
  { rings: 1, sides: 8, leastSides: 3, cap: 1, stride: 5 },
  { rings: 1, sides: 3, leastSides: 3, cap: 1, stride: 5 },
];

/** Drawn at once without effort. */
const mostVertices = 260_000;

/**
 * The finest detail with at most so many vertices, or as is drawn without effort. The coarsest has 8 vertices for an axis of
 * up to five segments: a plant of very many axes may have more than is asked for.
 */
export function detailFor(polylines: Polylines, most: number = mostVertices): Detail {
  const { offsets, radii } = polylines;
  const thickest = thickestOf(polylines);
  const fits = (detail: Detail) => {
    let vertices = 0;
    for (let axis = 0; axis + 1 < offsets.length; axis++) {
      const first = offsets[axis] ?? 0;
      const spans = (offsets[axis + 1] ?? 0) - first - 1;
      const sides = sidesFor((radii[first] ?? 0) / thickest, detail);
      vertices += ringsOf(spans, detail, axis > 0) * sides + 2;
    }
    return vertices <= most;
  };
  return tiers.find(fits) ?? tiers[tiers.length - 1] ?? tiers[0];
}

/** The largest radius, m; 1 if there is none. */
export function thickestOf({ radii }: Polylines): number {
  return radii.reduce((most, radius) => Math.max(most, radius), 0) || 1;
}

/** Fewer corners for a limb that is a `share` as thick as the thickest. */
export function sidesFor(share: number, { sides, leastSides }: Detail): number {
  return Math.max(leastSides, Math.ceil(sides * Math.sqrt(Math.min(1, share))));
}

/** Rings of an axis: those along it, and both ends without their poles; `leaves` says whether it leaves another limb. */
export function ringsOf(spans: number, { rings, cap, stride }: Detail, leaves: boolean): number {
  if (spans <= 0) return 0;
  const along = stride > 1 ? Math.ceil(spans / stride) : spans * rings;
  return along + 1 + (leaves && stride === 1 ? cap : 0) + 2 * (cap - 1);
}
