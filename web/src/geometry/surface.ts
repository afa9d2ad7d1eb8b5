/** A mesh as it is written, ring by ring, over the last one. */
import type { Transport } from "./transport.ts";

/** How many rings a tube has, and corners a ring. */
export interface Cut {
  readonly rings: number;
  readonly sides: number;
}

/**
 * A mesh of V vertices and T triangles. Arrays may be longer than what is in use, so that a growing plant seldom needs
 * new ones.
 */
export class Surface {
  /** x, y, z, m; shape 3V. */
  positions = new Float32Array(0);
  /** Unit vectors outwards; shape 3V. */
  normals = new Float32Array(0);
  /** Place on the surface: cosine and sine of the angle around the axis, arc length from the axis's start in m; shape 3V. No seam. */
  grain = new Float32Array(0);
  /** Index of the segment, for its values; shape V. */
  segments = new Uint32Array(0);
  /** How far along the segment, from 0 at its base to 1 at its end; shape V. */
  shares = new Float32Array(0);
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
  /** Whether the last update changed `index`: it says how the limbs are cut, not where they are. */
  recut = true;

  /** What the vertices of the next ring share: their segment, age and shade. */
  protected readonly wood = { segment: 0, share: 0, age: 0, shade: 0 };
  /** Whether each ring ends with its first corner once more: a texture around the limb needs that, and nothing else does. */
  protected readonly seam: boolean;
  /** Rings and sides of the tubes that `index` connects. */
  #cuts = new Uint32Array(0);

  constructor(seam = false) {
    this.seam = seam;
  }

  /** Makes room for these tubes and connects them. Returns whether the arrays are new ones (the old were too short). */
  protected prepare(tubes: readonly Cut[]): boolean {
    const cuts = new Uint32Array(2 * tubes.length);
    let corners = 0;
    let quads = 0;
    this.recut = cuts.length !== this.#cuts.length;
    for (const [i, { rings, sides }] of tubes.entries()) {
      if (this.#cuts[2 * i] !== rings || this.#cuts[2 * i + 1] !== sides) this.recut = true;
      cuts[2 * i] = rings;
      cuts[2 * i + 1] = sides;
      quads += rings * sides;
      corners += rings * this.#around(sides);
    }
    const renewed = this.#reserve(corners + cuts.length, 6 * quads);
    this.recut ||= renewed;
    this.#cuts = cuts;
    if (this.recut) this.#connect();
    this.vertexCount = 0;
    return renewed;
  }

  /** Corners of a ring with so many sides. */
  #around(sides: number): number {
    return this.seam ? sides + 1 : sides;
  }

  /** Exact for the first plant, which mostly stays the only one. */
  #reserve(vertices: number, indices: number): boolean {
    if (vertices <= this.ages.length && indices <= this.index.length) return false;
    const reserve = this.ages.length > 0 ? 1.5 : 1;
    const room = Math.ceil(reserve * vertices);
    this.positions = new Float32Array(3 * room);
    this.normals = new Float32Array(3 * room);
    this.grain = new Float32Array(3 * room);
    this.segments = new Uint32Array(room);
    this.shares = new Float32Array(room);
    this.ages = new Float32Array(room);
    this.shades = new Float32Array(room);
    this.index = new Uint32Array(Math.ceil(reserve * indices));
    return true;
  }

  /** Triangles between the rings of each tube, between a pole before the first and a pole after the last. */
  #connect(): void {
    const { index } = this;
    const cuts = this.#cuts;
    let at = 0;
    let start = 0;
    const triangle = (a: number, b: number, c: number) => {
      index[at++] = a;
      index[at++] = b;
      index[at++] = c;
    };
    for (let i = 0; i < cuts.length; i += 2) {
      const sides = cuts[i + 1] ?? 0;
      const around = this.#around(sides);
      const end = start + 1 + (cuts[i] ?? 0) * around;
      for (let side = 0; side < sides; side++) {
        const next = (side + 1) % around;
        triangle(start, start + 1 + next, start + 1 + side);
        for (let below = start + 1; below + around < end; below += around) {
          const above = below + around;
          triangle(below + side, below + next, above + side);
          triangle(below + next, above + next, above + side);
        }
        triangle(end, end - around + side, end - around + next);
      }
      start = end + 1;
    }
    this.indexCount = at;
  }

  /**
   * Writes a ring of the present wood around the frame's place, which is `along` the axis, but shifted by `shift`.
   * `circle` holds cosine and sine of each corner, `tilt` and `away` are the parts of the normals along the axis and away
   * from it: together a unit vector.
   */
  protected write(
    frame: Transport,
    circle: Float64Array,
    radius: number,
    tilt: number,
    away: number,
    shift: number,
    along: number,
  ): void {
    const { positions, normals, grain, segments, shares, ages, shades } = this;
    const { segment, share, age, shade } = this.wood;
    const { position, tangent, normal, binormal } = frame;
    // Numbers, not array elements: nothing is read again for each corner.
    const [tx, ty, tz] = [tangent[0] ?? 0, tangent[1] ?? 0, tangent[2] ?? 0];
    const [nx, ny, nz] = [normal[0] ?? 0, normal[1] ?? 0, normal[2] ?? 0];
    const [bx, by, bz] = [binormal[0] ?? 0, binormal[1] ?? 0, binormal[2] ?? 0];
    const x = (position[0] ?? 0) + shift * tx;
    const y = (position[1] ?? 0) + shift * ty;
    const z = (position[2] ?? 0) + shift * tz;
    let vertex = this.vertexCount;
    for (let corner = 0; corner < circle.length; corner += 2) {
      const cosine = circle[corner] ?? 0;
      const sine = circle[corner + 1] ?? 0;
      const outX = cosine * nx + sine * bx;
      const outY = cosine * ny + sine * by;
      const outZ = cosine * nz + sine * bz;
      const at = 3 * vertex;
      positions[at] = x + radius * outX;
      positions[at + 1] = y + radius * outY;
      positions[at + 2] = z + radius * outZ;
      normals[at] = tilt * tx + away * outX;
      normals[at + 1] = tilt * ty + away * outY;
      normals[at + 2] = tilt * tz + away * outZ;
      grain[at] = cosine;
      grain[at + 1] = sine;
      grain[at + 2] = along + shift;
      segments[vertex] = segment;
      shares[vertex] = share;
      ages[vertex] = age;
      shades[vertex] = shade;
      vertex++;
    }
    this.vertexCount = vertex;
  }
}

const circles = new Map<number, Float64Array>();

/** Cosine and sine of the angle of each corner of a ring with so many sides, of which one starts over where the last ends. */
export function circleOf(corners: number, sides = corners): Float64Array {
  const key = corners === sides ? sides : -sides;
  let circle = circles.get(key);
  if (!circle) {
    circle = new Float64Array(2 * corners);
    for (let side = 0; side < corners; side++) {
      // The last corner of a seam has the very numbers of the first.
      const angle = (2 * Math.PI * (side % sides)) / sides;
      circle[2 * side] = Math.cos(angle);
      circle[2 * side + 1] = Math.sin(angle);
    }
    circles.set(key, circle);
  }
  return circle;
}
