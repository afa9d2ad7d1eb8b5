/** What the colour of limbs means: values of the segments, their range, and their place on a colour scale. */
import type { Axes } from "./tube.ts";

/** What colour can stand for; `"bark"` is the plant's own. */
export type Color = "bark" | "moment" | "stress" | "curvature" | "age";
/** A value that every segment has. */
export type Measured = Exclude<Color, "bark">;

/** From the least to the largest value on a colour scale. */
export interface Range {
  readonly min: number;
  readonly max: number;
}

/** Places on a colour scale, 0 to 1. */
export interface Shades {
  /** At the base joint of each segment. */
  readonly values: Float64Array;
  /** At a free tip; null is as in the last segment. */
  readonly free: number | null;
}

/** Values that have a sign: their scale has its middle at zero. */
const signed: ReadonlySet<Measured> = new Set(["moment", "curvature"]);

/** Whether a value has a sign. */
export function isSigned(color: Measured): boolean {
  return signed.has(color);
}

/** The range of a value over plants; signed values reach equally far to both sides, and no range is empty. */
export function rangeOf(color: Measured, plants: readonly Axes[]): Range {
  let most = 0;
  for (const plant of plants) {
    for (let segment = 0; segment < plant.segments.point.length; segment++) {
      const size = Math.abs(measuredAt(color, plant, segment));
      if (size > most && Number.isFinite(size)) most = size;
    }
  }
  if (most === 0) most = 1;
  return { min: isSigned(color) ? -most : 0, max: most };
}

/** Where the segments' values are in the range. */
export function shadesOf(color: Measured, plant: Axes, { min, max }: Range): Shades {
  const place = (value: number) => Math.min(1, Math.max(0, (value - min) / (max - min) || 0));
  const values = Float64Array.from(plant.segments.point, (_, segment) =>
    place(measuredAt(color, plant, segment)),
  );
  // Nothing beyond a free tip bends it.
  const isLoad = color === "moment" || color === "stress";
  return { values, free: isLoad ? place(0) : null };
}

/** What colours a picture: which value, its colours from 0 to 1, and the range they stand for. */
export interface Paint {
  readonly color: Measured;
  readonly colors: readonly string[];
  readonly range: Range;
}

function measuredAt(color: Measured, { segments, report }: Axes, segment: number): number {
  if (color === "age") return Math.max(0, report.steps - (segments.birth[segment] ?? 0));
  return segments[color][segment] ?? 0;
}
