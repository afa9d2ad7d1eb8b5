/** Limbs: every axis of a plant as a smooth, closed tube, all in one mesh. */
import type { Plant } from "../plant/plant.ts";
import { type Detail, ringsOf, sidesFor, thickestOf } from "./detail.ts";
import { Junction } from "./junction.ts";
import type { Shades } from "./shade.ts";
import { Spline } from "./spline.ts";
import { circleOf, Surface } from "./surface.ts";
import { type Topology, topologyOf } from "./topology.ts";
import { Transport } from "./transport.ts";

/** What of a plant the limbs are made of. */
export type Axes = Pick<Plant, "polylines" | "segments"> & { report: Pick<Plant["report"], "steps"> };

/**
 * The mesh of a plant's limbs.
 *
 * Each axis is closed: every edge belongs to exactly two triangles. A limb that ends free narrows to its tip, which is
 * exactly the axis's last point. At a fork each limb leaves in the direction and with the girth of the one that bears it,
 * so that they run into each other smoothly; what leaves a stem from its side has a collar.
 *
 * What is needed on the way is kept between rings and between updates: a slider moves a plant many times a second.
 */
export class Tubes extends Surface {
  #spline = new Spline();
  #frame = new Transport();
  #junction = new Junction();
  #position = new Float64Array(3);
  #direction = new Float64Array(3);
  /** Of each axis: direction (3) and radius at its end, and how far the grain has come there. */
  #ends = new Float64Array(0);
  #along = 0;
  /** `#along` at the start of the axis. */
  #start = 0;

  /**
   * Makes the tubes of a plant, with all radii times `girth`. Returns whether the arrays are new ones (the old were too short).
   */
  update(axes: Axes, detail: Detail, girth = 1, shades: Shades | null = null): boolean {
    const { offsets, radii } = axes.polylines;
    const topology = topologyOf(axes);
    const thickest = thickestOf(axes.polylines);
    const limbs: Limb[] = [];
    for (let axis = 0; axis + 1 < offsets.length; axis++) {
      const first = offsets[axis] ?? 0;
      const end = offsets[axis + 1] ?? 0;
      const leaves = (topology.bearer[axis] ?? -1) >= 0;
      const rings = ringsOf(end - first - 1, detail, leaves);
      if (rings === 0) continue;
      const sides = sidesFor((radii[first] ?? 0) / thickest, detail);
      const circle = circleOf(this.seam ? sides + 1 : sides, sides);
      const bears = topology.bears[axis] === 1;
      limbs.push({
        axes,
        axis,
        first,
        end,
        topology,
        detail,
        sides,
        rings,
        circle,
        leaves,
        bears,
        girth,
        shades,
      });
    }
    if (this.#ends.length < 5 * offsets.length) this.#ends = new Float64Array(5 * offsets.length);
    const renewed = this.prepare(limbs);
    for (const limb of limbs) this.#limb(limb);
    return renewed;
  }

  #limb(limb: Limb): void {
    const { axes, axis, first, end, detail, leaves, bears } = limb;
    const spline = this.#spline;
    spline.use(axes.polylines, first, end);
    const last = spline.spans - 1;
    this.#direction.fill(0);
    this.#leave(limb);
    this.#go(0, 0, true);
    this.#dome(limb, 0, -1, radiusAt(limb, 0, 0) + this.#junction.swelling(0), leaves ? flat : 1);

    // The free tip takes up the end of the last segment.
    const length = spline.lengths[last] ?? 0;
    const tip = bears || length === 0 ? 0 : Math.min(1.5 * radiusAt(limb, last, 1), 0.5 * length);
    const shoulder = length > 0 ? 1 - tip / length : 1;
    this.#body(limb, 0, 0);
    if (detail.stride > 1) {
      for (let span = detail.stride; span <= last; span += detail.stride) this.#body(limb, span, 0);
      this.#body(limb, last, shoulder);
    } else {
      for (let span = 0; span <= last; span++) {
        const reach = span === last ? shoulder : 1;
        const near = span === 0 && leaves ? this.#close(limb, reach) : 0;
        for (let i = 1; i <= detail.rings; i++) {
          this.#body(limb, span, near + ((reach - near) * i) / detail.rings);
        }
      }
    }
    const radius = radiusAt(limb, last, 1);
    this.#ends.set(this.#frame.tangent, 5 * axis);
    this.#ends[5 * axis + 3] = radius;
    this.#ends[5 * axis + 4] = this.#along;
    if (tip > 0) this.#tip(limb, last, shoulder, tip);
    else this.#dome(limb, last, 1, radius, bears ? flat : 1);
  }

  /** Prepares how the limb leaves its bearer; of a continuation the grain goes on. */
  #leave(limb: Limb): void {
    const { axes, axis, topology, girth, leaves } = limb;
    const bearer = topology.bearer[axis] ?? -1;
    const continues = topology.continues[axis] === 1;
    const at = 5 * (axes.segments.axis[bearer] ?? 0);
    this.#along = continues ? (this.#ends[at + 4] ?? 0) : 0;
    this.#start = this.#along;
    if (!leaves) {
      this.#junction.clear();
      return;
    }
    const bearing = continues
      ? (this.#ends[at + 3] ?? 0)
      : girth * (axes.polylines.radii[axes.segments.point[bearer] ?? 0] ?? 0);
    this.#junction.join(radiusAt(limb, 0, 0), bearing, continues, this.#spline.length);
    if (continues) this.#spline.leave(this.#ends.subarray(at, at + 3), this.#junction.length);
  }

  /** Rings where the limb is swollen; where they end in the first span. */
  #close(limb: Limb, reach: number): number {
    const { cap, rings } = limb.detail;
    const length = this.#spline.lengths[0] ?? 0;
    const near = reach * Math.min(cap / (cap + rings), this.#junction.length / (length || 1));
    for (let i = 1; i <= cap; i++) this.#body(limb, 0, (near * i) / cap);
    return near;
  }

  /** Moves the frame to a place on the centre line. */
  #go(span: number, u: number, starts: boolean): void {
    const frame = this.#frame;
    const position = this.#position;
    this.#spline.follow(span, u, position, this.#direction);
    if (starts) frame.start(position, this.#direction);
    else this.#along += frame.advance(position, this.#direction);
  }

  /** Goes on to a place and writes the ring there. */
  #body(limb: Limb, span: number, u: number): void {
    this.#go(span, u, false);
    const distance = this.#along - this.#start;
    const near = radiusAt(limb, span, 0);
    const rise = radiusAt(limb, span, 1) - near;
    const slope = rise / (this.#spline.lengths[span] || Infinity) + this.#junction.slope(distance);
    const away = 1 / Math.sqrt(1 + slope * slope);
    const radius = near + u * rise + this.#junction.swelling(distance);
    this.#ring(limb, span, u, radius, -slope * away, away, 0);
  }

  /** Half a sphere, flattened by `height`, around the frame's place: before the tube (`side` -1: pole first) or after it (`side` 1). */
  #dome(limb: Limb, span: number, side: -1 | 1, radius: number, height: number): void {
    const { cap } = limb.detail;
    const u = side < 0 ? 0 : 1;
    if (side < 0) this.#pole(limb, span, u, -1, -radius * height);
    for (let i = 1; i < cap; i++) {
      const angle = ((side < 0 ? i - cap : i) * Math.PI) / (2 * cap);
      const tilt = Math.sin(angle);
      const away = Math.cos(angle);
      this.#ring(limb, span, u, radius * away, tilt, away, radius * tilt * height);
    }
    if (side > 0) this.#pole(limb, span, u, 1, radius * height);
  }

  /** Half an ellipse over the last stretch, that ends in the axis's last point. */
  #tip(limb: Limb, span: number, shoulder: number, length: number): void {
    const { cap } = limb.detail;
    for (let i = 1; i < cap; i++) {
      const angle = (i * Math.PI) / (2 * cap);
      const u = shoulder + (1 - shoulder) * Math.sin(angle);
      const full = radiusAt(limb, span, u);
      this.#go(span, u, false);
      const tilt = Math.sin(angle) * full;
      const away = Math.cos(angle) * length;
      const size = Math.sqrt(tilt * tilt + away * away);
      this.#ring(limb, span, u, full * Math.cos(angle), tilt / size, away / size, 0);
    }
    this.#go(span, 1, false);
    this.#pole(limb, span, 1, 1, 0);
  }

  #pole(limb: Limb, span: number, u: number, tilt: -1 | 1, shift: number): void {
    this.#wood(limb, span, u);
    this.write(this.#frame, centre, 0, tilt, 0, shift, this.#along);
  }

  #ring(
    limb: Limb,
    span: number,
    u: number,
    radius: number,
    tilt: number,
    away: number,
    shift: number,
  ): void {
    this.#wood(limb, span, u);
    this.write(this.#frame, limb.circle, radius, tilt, away, shift, this.#along);
  }

  /** Of what wood the next ring is. */
  #wood({ axes, topology, first, end, axis, bears, shades }: Limb, span: number, u: number): void {
    const { segmentAt, bearer, continues } = topology;
    const { birth } = axes.segments;
    const { wood } = this;
    const point = first + span + 1;
    const own = segmentAt[point] ?? 0;
    const borne = continues[axis] === 1 ? (bearer[axis] ?? own) : own;
    const before = span > 0 ? (segmentAt[point - 1] ?? own) : borne;
    const born = birth[own] ?? 0;
    const bornBefore = birth[before] ?? born;
    wood.segment = own;
    wood.share = u;
    wood.age = axes.report.steps - (bornBefore + u * (born - bornBefore));
    if (!shades) return;
    // A segment's value is that of its base joint.
    const { values, free } = shades;
    const near = values[own] ?? 0;
    const atEnd = bears ? near : (free ?? near);
    const far = point + 1 >= end ? atEnd : (values[segmentAt[point + 1] ?? own] ?? near);
    wood.shade = near + u * (far - near);
  }
}

/** Ends that are hidden in other limbs. */
const flat = 0.2;

/** A pole is a ring of one corner, in its middle. */
const centre = new Float64Array(2);

/** One axis while its tube is made. */
interface Limb {
  readonly axes: Axes;
  readonly axis: number;
  readonly first: number;
  readonly end: number;
  readonly topology: Topology;
  readonly detail: Detail;
  readonly sides: number;
  readonly rings: number;
  /** Cosine and sine of each corner of a ring. */
  readonly circle: Float64Array;
  /** Whether another limb bears it, and whether others begin at its end. */
  readonly leaves: boolean;
  readonly bears: boolean;
  readonly girth: number;
  readonly shades: Shades | null;
}

function radiusAt({ axes, first, girth }: Limb, span: number, u: number): number {
  const { radii } = axes.polylines;
  const near = radii[first + span] ?? 0;
  const far = radii[first + span + 1] ?? 0;
  return girth * (near + u * (far - near));
}
