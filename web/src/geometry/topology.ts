/** How the axes of a plant hang together. */
import type { Axes } from "./tube.ts";

export interface Topology {
  /** The segment that ends at each point. */
  readonly segmentAt: Uint32Array;
  /** For each axis the segment that bears it; -1 is the ground. */
  readonly bearer: Int32Array;
  /** For each axis, whether it begins where its bearer's axis ends. */
  readonly continues: Uint8Array;
  /** For each axis, whether others begin at its end. */
  readonly bears: Uint8Array;
}

export function topologyOf({
  polylines: { offsets, radii },
  segments: { parent, point, axis },
}: Axes): Topology {
  const axes = Math.max(0, offsets.length - 1);
  const segmentAt = new Uint32Array(radii.length);
  const bearer = new Int32Array(axes).fill(-1);
  const continues = new Uint8Array(axes);
  const bears = new Uint8Array(axes);
  for (let segment = 0; segment < point.length; segment++) {
    segmentAt[point[segment] ?? 0] = segment;
    const own = axis[segment] ?? 0;
    const before = parent[segment] ?? -1;
    const beforeAxis = axis[before] ?? -1;
    if (before < 0 || beforeAxis === own) continue;
    bearer[own] = before;
    if ((point[before] ?? -1) + 1 !== offsets[beforeAxis + 1]) continue;
    continues[own] = 1;
    bears[beforeAxis] = 1;
  }
  return { segmentAt, bearer, continues, bears };
}
