/** Limbs: every axis of a plant as a smooth, closed tube, all in one mesh. */
import type { Plant } from "../plant/plant.ts";
import { type Detail, ringsOf, sidesFor, thickestOf } from "./detail.ts";
import { Junction } from "./junction.ts";
import type { Shades } from "./shade.ts";
import { Spline } from "./spline.ts";
import { type Topology, topologyOf } from "./topology.ts";
import { Transport } from "./transport.ts";

/** What of a plant the limbs are made of. */
export type Axes = Pick<Plant, "polylines" | "segments"> & { report: Pick<Plant["report"], "steps"> };

/** One ring of a tube. */
interface Ring {
  readonly radius: number;
  /** Parts of the normal along the axis and away from it; together a unit vector. */
  readonly tilt: number;
  readonly away: number;
}

/**
 * A mesh of V vertices and T triangles. Arrays may be longer than what is in use, so that a growing plant seldom needs new ones.
 *
 * Each axis is closed: every edge belongs to exactly two triangles. A limb that ends free narrows to its tip, which is
 * exactly the axis's last point. At a fork each limb leaves in the direction and with the girth of the one that bears it,
 * so that they run into each other smoothly; what leaves a stem from its side has a collar.
 */
export class Tubes {
  /** x, y, z, m; shape 3V. */
  positions = new Float32Array(0);
  /** Unit vectors outwards; shape 3V. */
  normals = new Float32Array(0);
  /** Place on the surface: cosine and sine of the angle around the axis, arc length from the axis's start in m; shape 3V. No seam. */
  grain = new Float32Array(0);
  /** Index of the segment, for colouring by its values; shape V. */
  segments = new Uint32Array(0);
  /** Growth steps since the segment's birth, blended between neighbours; shape V. */
  ages = new Float32Array(0);
  /** Place on the colour scale, 0 to 1, if there are shades; shape V. */
  shades = new Float32Array(0);
  /** Three vertices a triangle, counter-clockwise from outside; shape 3T. */
  index = new Uint32Array(0);
  /** V */
  vertexCount = 0;
  /** 3T */
  indexCount = 0;

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
    const limbs: Limb[] = [];
    const thickest = thickestOf(axes.polylines);
    let vertices = 0;
    let indices = 0;
    for (let axis = 0; axis + 1 < offsets.length; axis++) {
      const first = offsets[axis] ?? 0;
      const end = offsets[axis + 1] ?? 0;
      const leaves = (topology.bearer[axis] ?? -1) >= 0;
      const rings = ringsOf(end - first - 1, detail, leaves);
      if (rings === 0) continue;
      const sides = sidesFor((radii[first] ?? 0) / thickest, detail);
      limbs.push({ axes, axis, first, end, topology, detail, sides, rings, girth, shades });
      vertices += rings * sides + 2;
      indices += rings * sides * 6;
    }
    const renewed = vertices > this.ages.length || indices > this.index.length;
    if (renewed) this.#allocate(vertices, indices);
    if (this.#ends.length < 5 * offsets.length) this.#ends = new Float64Array(5 * offsets.length);
    this.vertexCount = 0;
    this.indexCount = 0;
    for (const limb of limbs) {
      this.#connect(limb.rings, limb.sides);
      this.#limb(limb);
    }
    return renewed;
  }

  #allocate(vertices: number, indices: number): void {
    const room = Math.ceil(1.5 * vertices);
    this.positions = new Float32Array(3 * room);
    this.normals = new Float32Array(3 * room);
    this.grain = new Float32Array(3 * room);
    this.segments = new Uint32Array(room);
    this.ages = new Float32Array(room);
    this.shades = new Float32Array(room);
    this.index = new Uint32Array(Math.ceil(1.5 * indices));
  }

  /** Triangles between `rings` rings that follow, between a pole before the first and a pole after the last. */
  #connect(rings: number, sides: number): void {
    const { index } = this;
    const start = this.vertexCount;
    const end = start + 1 + rings * sides;
    let at = this.indexCount;
    const triangle = (a: number, b: number, c: number) => {
      index[at++] = a;
      index[at++] = b;
      index[at++] = c;
    };
    for (let side = 0; side < sides; side++) {
      const next = (side + 1) % sides;
      triangle(start, start + 1 + next, start + 1 + side);
      for (let ring = 0; ring + 1 < rings; ring++) {
        const below = start + 1 + ring * sides;
        const above = below + sides;
        triangle(below + side, below + next, above + side);
        triangle(below + next, above + next, above + side);
      }
      triangle(end, end - sides + side, end - sides + next);
    }
    this.indexCount = at;
  }

  #limb(limb: Limb): void {
    const { axes, first, topology, detail, girth, axis } = limb;
    const { radii } = axes.polylines;
    const spline = this.#spline;
    spline.use(axes.polylines, first, limb.end);
    const last = spline.spans - 1;
    const radiusAt = (span: number, u: number) => {
      const near = radii[first + span] ?? 0;
      const far = radii[first + span + 1] ?? 0;
      return girth * (near + u * (far - near));
    };
    this.#direction.fill(0);
    this.#leave(limb, radiusAt(0, 0));
    this.#go(0, 0, true);
    const leaves = (topology.bearer[axis] ?? -1) >= 0;
    this.#dome(limb, 0, -1, radiusAt(0, 0) + this.#junction.swelling(0), leaves ? flat : 1);

    // The free tip takes up the end of the last segment.
    const bears = topology.bears[axis] === 1;
    const length = spline.lengths[last] ?? 0;
    const tip = bears || length === 0 ? 0 : Math.min(1.5 * radiusAt(last, 1), 0.5 * length);
    const shoulder = length > 0 ? 1 - tip / length : 1;
    const ring = (span: number, u: number) => {
      this.#go(span, u, false);
      const distance = this.#along - this.#start;
      const taper = (radiusAt(span, 1) - radiusAt(span, 0)) / (spline.lengths[span] || Infinity);
      const slope = taper + this.#junction.slope(distance);
      const away = 1 / Math.hypot(1, slope);
      const radius = radiusAt(span, u) + this.#junction.swelling(distance);
      this.#ring(limb, span, u, { radius, tilt: -slope * away, away });
    };
    ring(0, 0);
    if (detail.stride > 1) {
      for (let span = detail.stride; span <= last; span += detail.stride) ring(span, 0);
      ring(last, shoulder);
    } else {
      for (let span = 0; span <= last; span++) {
        const reach = span === last ? shoulder : 1;
        const near = span === 0 && leaves ? this.#close(limb, reach, ring) : 0;
        for (let i = 1; i <= detail.rings; i++) ring(span, near + ((reach - near) * i) / detail.rings);
      }
    }
    this.#ends.set(this.#frame.tangent, 5 * axis);
    this.#ends[5 * axis + 3] = radiusAt(last, 1);
    this.#ends[5 * axis + 4] = this.#along;
    if (tip > 0) this.#tip(limb, last, shoulder, tip, radiusAt);
    else this.#dome(limb, last, 1, radiusAt(last, 1), bears ? flat : 1);
  }

  /** Prepares how the limb leaves its bearer; of a continuation the grain goes on. */
  #leave({ axes, axis, topology, girth }: Limb, radius: number): void {
    const bearer = topology.bearer[axis] ?? -1;
    const continues = topology.continues[axis] === 1;
    const at = 5 * (axes.segments.axis[bearer] ?? 0);
    this.#along = continues ? (this.#ends[at + 4] ?? 0) : 0;
    this.#start = this.#along;
    if (bearer < 0) {
      this.#junction.clear();
      return;
    }
    const bearing = continues
      ? (this.#ends[at + 3] ?? 0)
      : girth * (axes.polylines.radii[axes.segments.point[bearer] ?? 0] ?? 0);
    this.#junction.join(radius, bearing, continues, this.#spline.length);
    if (continues) this.#spline.leave(this.#ends.subarray(at, at + 3), this.#junction.length);
  }

  /** Rings where the limb is swollen; where they end in the first span. */
  #close({ detail }: Limb, reach: number, ring: (span: number, u: number) => void): number {
    const length = this.#spline.lengths[0] ?? 0;
    const near =
      reach * Math.min(detail.cap / (detail.cap + detail.rings), this.#junction.length / (length || 1));
    for (let i = 1; i <= detail.cap; i++) ring(0, (near * i) / detail.cap);
    return near;
  }

  /** Moves the frame to a place on the centre line. */
  #go(span: number, u: number, starts: boolean): void {
    const spline = this.#spline;
    const frame = this.#frame;
    const station = { span, u };
    spline.position(station, this.#position);
    spline.direction(station, this.#direction);
    if (starts) frame.start(this.#position, this.#direction);
    else {
      this.#along += Math.hypot(
        (this.#position[0] ?? 0) - (frame.position[0] ?? 0),
        (this.#position[1] ?? 0) - (frame.position[1] ?? 0),
        (this.#position[2] ?? 0) - (frame.position[2] ?? 0),
      );
      frame.advance(this.#position, this.#direction);
    }
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
      this.#ring(limb, span, u, { radius: radius * away, tilt, away }, radius * tilt * height);
    }
    if (side > 0) this.#pole(limb, span, u, 1, radius * height);
  }

  /** Half an ellipse over the last stretch, that ends in the axis's last point. */
  #tip(
    limb: Limb,
    span: number,
    shoulder: number,
    length: number,
    radiusAt: (span: number, u: number) => number,
  ) {
    const { cap } = limb.detail;
    for (let i = 1; i < cap; i++) {
      const angle = (i * Math.PI) / (2 * cap);
      const u = shoulder + (1 - shoulder) * Math.sin(angle);
      const full = radiusAt(span, u);
      this.#go(span, u, false);
      const tilt = Math.sin(angle) * full;
      const away = Math.cos(angle) * length;
      const size = Math.hypot(tilt, away);
      this.#ring(limb, span, u, { radius: full * Math.cos(angle), tilt: tilt / size, away: away / size });
    }
    this.#go(span, 1, false);
    this.#pole(limb, span, 1, 1, 0);
  }

  #ring(limb: Limb, span: number, u: number, { radius, tilt, away }: Ring, shift = 0): void {
    const { sides } = limb;
    for (let side = 0; side < sides; side++) {
      const angle = (2 * Math.PI * side) / sides;
      this.#vertex(limb, span, u, Math.cos(angle), Math.sin(angle), radius, tilt, away, shift);
    }
  }

  #pole(limb: Limb, span: number, u: number, tilt: -1 | 1, shift: number): void {
    this.#vertex(limb, span, u, 0, 0, 0, tilt, 0, shift);
  }

  #vertex(
    limb: Limb,
    span: number,
    u: number,
    cosine: number,
    sine: number,
    radius: number,
    tilt: number,
    away: number,
    shift: number,
  ): void {
    const { position, tangent, normal, binormal } = this.#frame;
    const vertex = this.vertexCount++;
    for (let k = 0; k < 3; k++) {
      const outwards = cosine * (normal[k] ?? 0) + sine * (binormal[k] ?? 0);
      const along = tangent[k] ?? 0;
      this.positions[3 * vertex + k] = (position[k] ?? 0) + shift * along + radius * outwards;
      this.normals[3 * vertex + k] = tilt * along + away * outwards;
    }
    this.grain[3 * vertex] = cosine;
    this.grain[3 * vertex + 1] = sine;
    this.grain[3 * vertex + 2] = this.#along + shift;
    const { segments, report } = limb.axes;
    const { segmentAt, bearer, continues } = limb.topology;
    const point = limb.first + span + 1;
    const own = segmentAt[point] ?? 0;
    const borne = continues[limb.axis] === 1 ? (bearer[limb.axis] ?? own) : own;
    const before = span > 0 ? (segmentAt[point - 1] ?? own) : borne;
    const birth = segments.birth[own] ?? 0;
    const birthBefore = segments.birth[before] ?? birth;
    this.segments[vertex] = own;
    this.ages[vertex] = report.steps - (birthBefore + u * (birth - birthBefore));
    if (!limb.shades) return;
    // A segment's value is that of its base joint.
    const { values, free } = limb.shades;
    const near = values[own] ?? 0;
    const isLast = point + 1 >= limb.end;
    const atEnd = limb.topology.bears[limb.axis] === 1 ? near : (free ?? near);
    const far = isLast ? atEnd : (values[segmentAt[point + 1] ?? own] ?? near);
    this.shades[vertex] = near + u * (far - near);
  }
}

/** Ends that are hidden in other limbs. */
const flat = 0.2;

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
  readonly girth: number;
  readonly shades: Shades | null;
}
