/** What part of the world a picture shows, so that a plant fits with margins. */
import { type Bounds, union, type Vector } from "./bounds.ts";

/** A window on the world: what lies in the plane of `center` is seen `height` high. */
export interface Frame {
  readonly center: Vector;
  /** m */
  readonly height: number;
  /** Where the ground is, m: at the base, or below all that hangs. */
  readonly ground: number;
}

/** The size of a picture, CSS px. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Kept free: shares of the picture, but at least so many px. Above are controls, below the ground and the scale bar. */
const margins = {
  top: { share: 0.09, least: 52 },
  side: { share: 0.08, least: 28 },
  bottom: { share: 0.15, least: 76 },
};

/**
 * The frame that shows a box whole. The base of the plant, at the origin, and the ground are always in the picture. `foot` is
 * the radius of the base: so far the plant may reach into the soil. If it `turns`, its depth needs room as well. What else is
 * to be seen `beside` it leaves the ground where it is.
 */
export function frameOf(
  bounds: Bounds,
  picture: Size,
  foot: number,
  turns = false,
  beside: Bounds | null = null,
): Frame {
  const own = union(bounds, { min: [0, 0, 0], max: [0, 0, 0] });
  const size = Math.max(...own.max.map((most, k) => most - (own.min[k] ?? 0)));
  const hangs = own.min[1] < -1.1 * foot;
  const ground = hangs ? own.min[1] - 0.05 * size : 0;
  const { min, max } = beside ? union(own, beside) : own;
  const lowest = beside ? Math.min(ground, beside.min[1]) : ground;
  const top = kept(margins.top, picture.height);
  const bottom = kept(margins.bottom, picture.height);
  const side = kept(margins.side, picture.width);
  const tall = (max[1] - lowest) / (1 - top - bottom);
  const across = turns ? Math.hypot(max[0] - min[0], max[2] - min[2]) : max[0] - min[0];
  const wide = (across / (1 - 2 * side)) * (picture.height / picture.width);
  const height = Math.max(tall, wide, Number.MIN_VALUE);
  const spare = height - tall;
  return {
    center: [
      (min[0] + max[0]) / 2,
      // Some of the spare air goes below the ground, so that a low plant does not lie at the bottom edge.
      lowest - bottom * height + height / 2 - 0.3 * spare,
      (min[2] + max[2]) / 2,
    ],
    height,
    ground,
  };
}

/** A margin as a share of the picture; in tiny pictures something is left for the plant. */
function kept({ share, least }: { share: number; least: number }, size: number): number {
  return Math.min(Math.max(share, least / size), 0.3);
}

/** The frame between two others: `share` 0 is the first, 1 the second. Heights blend by ratio, as a zoom looks even. */
export function between(from: Frame, to: Frame, share: number): Frame {
  const mix = (a: number, b: number) => a + share * (b - a);
  return {
    center: [
      mix(from.center[0], to.center[0]),
      mix(from.center[1], to.center[1]),
      mix(from.center[2], to.center[2]),
    ],
    height: from.height * (to.height / from.height) ** share,
    ground: mix(from.ground, to.ground),
  };
}

const factors = [1, 2, 3, 5];

/**
 * How many times too thick limbs are drawn, so that thin ones are seen as bodies: 1 where they are thick enough, else a
 * round number, which the picture states.
 */
export function girthFor(thickest: number, extent: number): number {
  const wanted = (0.011 * extent) / thickest;
  if (!(wanted > 1)) return 1;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const factor = factors.find((digit) => digit * decade >= wanted * 0.8) ?? 10;
  return Math.min(factor * decade, 1e4);
}
