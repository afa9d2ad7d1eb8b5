/** Values at the vertices of limbs that shaders of one's own want. What nobody asks for is not computed. */
import { swayOf } from "./sway.ts";
import { topologyOf } from "./topology.ts";
import type { Axes } from "./tube.ts";

/** What is known of V vertices. */
export interface Vertices {
  readonly vertexCount: number;
  /** Index of the segment; shape V. */
  readonly segments: Uint32Array;
  /** How far along the segment, from 0 at its base to 1 at its end; shape V. */
  readonly shares: Float32Array;
  /** Cosine and sine of the angle around the axis (0 and 0 in the middle of an end), arc length from the axis's start in m; shape 3V. */
  readonly grain: Float32Array;
}

/** A value at every vertex. */
export interface VertexAttribute {
  /** Its name in shaders. */
  readonly name: string;
  /** Numbers a vertex. */
  readonly itemSize: number;
  /** Whether it needs rings that end with their first corner once more. */
  readonly seam?: boolean;
  /** Writes the values of all vertices. */
  fill(axes: Axes, vertices: Vertices, values: Float32Array): void;
}

/** Place on the surface: turns around the axis from 0 to 1, and arc length from the axis's start in m; 0.5 turns at the ends. */
export const uv: VertexAttribute = {
  name: "uv",
  itemSize: 2,
  seam: true,
  fill(_, { grain, vertexCount }, values) {
    let before = 0;
    for (let vertex = 0; vertex < vertexCount; vertex++) {
      const cosine = grain[3 * vertex] ?? 0;
      const sine = grain[3 * vertex + 1] ?? 0;
      const isEnd = cosine === 0 && sine === 0;
      const turn = Math.atan2(sine, cosine) / (2 * Math.PI);
      // The first corner once more comes after one below the axis.
      const closes = sine === 0 && cosine > 0 && before < 0;
      values[2 * vertex] = isEnd ? 0.5 : closes ? 1 : turn < 0 ? turn + 1 : turn;
      values[2 * vertex + 1] = grain[3 * vertex + 2] ?? 0;
      before = sine;
    }
  },
};

/** Branching order of the limb: 0 for the main axis. */
export const order: VertexAttribute = {
  name: "order",
  itemSize: 1,
  fill({ segments }, vertices, values) {
    along(vertices, values, segments.order, segments.order);
  },
};

/** Bending moment, N m, as `segments.moment` has it; 0 at free tips. */
export const moment: VertexAttribute = {
  name: "moment",
  itemSize: 1,
  fill(axes, vertices, values) {
    const { parent, axis, moment: joints } = axes.segments;
    const { bears } = topologyOf(axes);
    // At the end of a segment is the next joint of its axis; at the end of an axis that bears others, its own last.
    const ends = joints.map((own, segment) => (bears[axis[segment] ?? 0] === 1 ? own : 0));
    for (let segment = 0; segment < parent.length; segment++) {
      const before = parent[segment] ?? -1;
      if (before >= 0 && axis[before] === axis[segment]) ends[before] = joints[segment] ?? 0;
    }
    along(vertices, values, joints, ends);
  },
};

/** How far the wood gives way to wind, from 0 at the ground to 1 where it moves most: the weight for a shader. */
export const sway: VertexAttribute = {
  name: "sway",
  itemSize: 1,
  fill(axes, vertices, values) {
    const ends = swayOf(axes);
    const bases = ends.map((_, segment) => ends[axes.segments.parent[segment] ?? -1] ?? 0);
    along(vertices, values, bases, ends);
  },
};

/** Writes values that each segment has at its base and at its end, and that change evenly between them. */
function along(
  { segments, shares, vertexCount }: Vertices,
  values: Float32Array,
  bases: ArrayLike<number>,
  ends: ArrayLike<number>,
): void {
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    const segment = segments[vertex] ?? 0;
    const base = bases[segment] ?? 0;
    values[vertex] = base + (shares[vertex] ?? 0) * ((ends[segment] ?? 0) - base);
  }
}
