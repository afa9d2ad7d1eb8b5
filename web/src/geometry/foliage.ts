/** Leaves along young wood: where each is, and how it is turned. */
import { boundsOf } from "./bounds.ts";
import { Spline } from "./spline.ts";
import { swayOf } from "./sway.ts";
import { topologyOf } from "./topology.ts";
import { Transport } from "./transport.ts";
import type { Axes } from "./tube.ts";

/** How leaves stand. */
export interface LeafHabit {
  /** Up to this age the wood bears leaves, growth steps. */
  readonly youth: number;
  /** Length of wood between a leaf and the next, m. */
  readonly spacing: number;
  /** Length of a full-grown leaf, m. */
  readonly size: number;
  /** Turn about the wood from a leaf to the next, degrees; 137.5 is the golden angle of spiral phyllotaxis. */
  readonly divergence: number;
  /** Between the leaf and the wood towards the tip, degrees. */
  readonly angle: number;
  /** How much leaves turn their faces up, from 0 (as the wood has them) to 1. */
  readonly light: number;
  /** How many of the first axes bear none: 1 for a plant around a stem, which is its first axis. */
  readonly bare: number;
}

/** Leaves of one plant; L leaves. */
export interface Foliage {
  readonly count: number;
  /**
   * From a leaf's own coordinates (base in the origin, tip at y = 1, upper face to +z) to the plant's, m: column by column,
   * as three.js has them; shape 16 L.
   */
  readonly matrices: Float32Array;
  /** Age of the wood that bears the leaf, as a share of `youth`, 0 to 1; shape L. */
  readonly ages: Float32Array;
  /** How far the wood there gives way to wind, as of `swayOf`; shape L. */
  readonly sways: Float32Array;
}

/**
 * Leaves that suit a plant: for all its ages, give the one of full age, so that they stay where they are while it grows. What
 * is wished for goes before.
 */
export function habitFor(grown: Axes, wishes: Partial<LeafHabit> = {}): LeafHabit {
  const { min, max } = boundsOf(grown.polylines, 0);
  const extent = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const { length } = grown.segments;
  const mean = length.reduce((sum, own) => sum + own, 0) / Math.max(1, length.length);
  const spacing = Math.max(mean, extent / 50) || 1;
  const youth = Math.max(1, 0.3 * grown.report.steps);
  return {
    youth,
    spacing,
    size: 1.7 * spacing,
    divergence: 137.5,
    angle: 55,
    light: 0.6,
    bare: 0,
    ...wishes,
  };
}

/** The leaves of a plant, whose limbs are drawn `girth` times as thick. */
export function foliageOf(axes: Axes, habit: LeafHabit, girth: number = 1): Foliage {
  const { offsets, radii } = axes.polylines;
  const { segmentAt, continues, bearer } = topologyOf(axes);
  const sway = swayOf(axes);
  const nodes: Node[] = [];
  const frame = new Transport();
  const spline = new Spline();
  const position = new Float64Array(3);
  const direction = new Float64Array(3);
  for (let axis = habit.bare; axis + 1 < offsets.length; axis++) {
    const first = offsets[axis] ?? 0;
    spline.use(axes.polylines, first, offsets[axis + 1] ?? 0);
    direction.fill(0);
    let along = 0;
    let next = 1;
    for (let span = 0; span < spline.spans; span++) {
      const length = spline.lengths[span] ?? 0;
      const segment = segmentAt[first + span + 1] ?? 0;
      const borne = span === 0 && continues[axis] === 1 ? (bearer[axis] ?? segment) : segment;
      const before = span === 0 ? borne : (segmentAt[first + span] ?? segment);
      for (; next * habit.spacing <= along + length * (1 + 1e-9); next++) {
        const share = Math.min(1, (next * habit.spacing - along) / length);
        const age = ageAt(axes, before, segment, share) / habit.youth;
        spline.follow(span, share, position, direction);
        if (next === 1) frame.start(position, direction);
        else frame.advance(position, direction);
        if (!(age >= 0 && age <= 1)) continue;
        const thickness = radii[first + span] ?? 0;
        const radius = girth * (thickness + share * ((radii[first + span + 1] ?? 0) - thickness));
        const bend = sway[axes.segments.parent[segment] ?? -1] ?? 0;
        nodes.push({
          matrix: leafAt(frame, radius, next, unfolded(age) * habit.size, habit),
          age,
          sway: bend + share * ((sway[segment] ?? 0) - bend),
        });
      }
      along += length;
    }
  }
  const matrices = new Float32Array(16 * nodes.length);
  for (const [leaf, { matrix }] of nodes.entries()) matrices.set(matrix, 16 * leaf);
  return {
    count: nodes.length,
    matrices,
    ages: Float32Array.from(nodes, ({ age }) => age),
    sways: Float32Array.from(nodes, ({ sway: weight }) => weight),
  };
}

/** Where a leaf is borne, and the leaf. */
interface Node {
  readonly matrix: readonly number[];
  readonly age: number;
  readonly sway: number;
}

/** Growth steps since the wood was formed that lies a `share` along a segment, blended as in the limbs. */
function ageAt({ segments, report }: Axes, before: number, segment: number, share: number): number {
  const born = segments.birth[segment] ?? 0;
  const bornBefore = segments.birth[before] ?? born;
  return report.steps - (bornBefore + share * (born - bornBefore));
}

/** Size of a leaf on wood of an age (0 to 1) over that of a full-grown one: leaves unfold at the tip, and wither before they fall. */
function unfolded(age: number): number {
  const opening = Math.min(1, age / 0.3);
  const withering = Math.min(1, (1 - age) / 0.15);
  return (0.35 + 0.65 * opening) * Math.sqrt(withering);
}

/** The matrix of the leaf with this number on its axis, at the frame's place. */
function leafAt(frame: Transport, radius: number, number: number, size: number, habit: LeafHabit): number[] {
  const around = (number * habit.divergence * Math.PI) / 180;
  const lean = (habit.angle * Math.PI) / 180;
  const { position, tangent, normal, binormal } = frame;
  const out = mix(normal, Math.cos(around), binormal, Math.sin(around));
  const blade = mix(tangent, Math.cos(lean), out, Math.sin(lean));
  // The upper face is the one towards the tip of the wood, before it turns to the light.
  const face = mix(tangent, Math.sin(lean), out, -Math.cos(lean));
  const lit = mix(face, 1 - habit.light, [0, 1, 0], habit.light);
  const upper = across(lit, blade) ?? face;
  const [bx = 0, by = 0, bz = 0] = blade;
  const [ux = 0, uy = 0, uz = 0] = upper;
  const side = [by * uz - bz * uy, bz * ux - bx * uz, bx * uy - by * ux];
  const base = mix(position, 1, out, radius);
  return [
    ...side.map((k) => k * size),
    0,
    ...blade.map((k) => k * size),
    0,
    ...upper.map((k) => k * size),
    0,
    ...base,
    1,
  ];
}

/** The part of a vector across a unit vector, of unit length; null where there is none. */
function across(vector: readonly number[], unit: readonly number[]): number[] | null {
  const along = vector.reduce((sum, k, i) => sum + k * (unit[i] ?? 0), 0);
  const rest = vector.map((k, i) => k - along * (unit[i] ?? 0));
  const size = Math.hypot(...rest);
  return size > 1e-6 ? rest.map((k) => k / size) : null;
}

function mix(a: ArrayLike<number>, share: number, b: ArrayLike<number>, other: number): number[] {
  return [0, 1, 2].map((k) => share * (a[k] ?? 0) + other * (b[k] ?? 0));
}
