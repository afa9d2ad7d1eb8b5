/** What client and session say to each other, through a worker's message port or within one thread. */
import type { Vector } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import type { Held, Shape } from "./core.ts";

/** From the client. Params are in flat form; `id` names the request in the replies to it. */
export type Request =
  | { kind: "check"; id: number; flat: Float64Array<ArrayBuffer> }
  /** Ends every earlier "plant", which is not replied to any more. A step of null is the last one; a deadline is in ms. */
  | {
      kind: "plant";
      id: number;
      flat: Float64Array<ArrayBuffer>;
      step: number | null;
      grip?: Grip;
      deadline?: number;
    }
  /** Ends the "plant" of this id. */
  | { kind: "cancel"; id: number };

/** What holds a plant: the distal end of a segment, and the place where it is held; x, y, z in m. */
export interface Grip {
  segment: number;
  place: Vector;
}

/** The first message to a worker that shall not look for the wasm itself. */
export interface Wasm {
  kind: "wasm";
  module: WebAssembly.Module;
}

/** From the session. */
export type Reply =
  /** All that is wrong; for a "plant" only if anything is. */
  | { kind: "issues"; id: number; issues: Issue[] }
  /** The share of the work that is done, 0 to 1. */
  | { kind: "progress"; id: number; share: number }
  | { kind: "shape"; id: number; shape: Shape }
  /** A plant that is held, and the force that does it, N; without a shape if it cannot be held there. */
  | { kind: "held"; id: number; held: Held | null }
  | { kind: "cancelled"; id: number }
  | { kind: "failed"; id: number; name: string; message: string };

/** Sends a reply; the buffers change hands instead of being copied. */
export type Answer = (reply: Reply, buffers: ArrayBuffer[]) => void;

/** The buffers of a shape's arrays. */
export function buffersOf({ polylines, segments }: Shape): ArrayBuffer[] {
  const arrays = [...Object.values(polylines), ...Object.values(segments)] as { buffer: ArrayBuffer }[];
  return arrays.map(({ buffer }) => buffer);
}
