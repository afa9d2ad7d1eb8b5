/** The engine: params in, plant out, without blocking the page. */
import type { Vector } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import type { ParamsInput } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import { wasmAddress } from "./address.ts";
import { type Pool, type PoolOptions, startPoolOn } from "./pool.ts";
import { type Host, type Parts, startOn } from "./start.ts";
import { engineInThread } from "./thread.ts";
import { load, type Source } from "./wasm.ts";
import { workerEngine } from "./worker-engine.ts";

/** What one request for a plant may be given. */
export interface PlantOptions {
  /** Ends the request: it rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Is told the share of the work that is done, 0 to 1; not called for plants that take but a moment. */
  onProgress?: (share: number) => void;
  /**
   * Time that growing may take, ms, from when the request's turn comes. A plant that is not finished then is that of the last
   * finished step, and its report says `"budget"`. Does not bear on `hold`.
   */
  deadline?: number;
}

/** Computes plants. The worker and the in-thread engine behave alike. */
export interface Engine {
  /** Where it computes. */
  readonly transport: "worker" | "thread";
  /** Why it is not a worker, if it was meant to be one. */
  readonly reason: string | null;
  /** Every problem with any value given as params. */
  check(params: unknown): Promise<Issue[]>;
  /**
   * The plant at a growth step (null: full grown; a step past the last is the last). The newest request wins: an
   * older one that is not finished rejects with an error named `"AbortError"`. Bad params reject with a
   * `BoughError`. If the worker dies, what is pending rejects with an error named `"LostError"`, and the next request
   * starts a new one. Another step of the same plant continues from the present one.
   */
  plant(params: ParamsInput, step?: number | null, options?: PlantOptions): Promise<Plant>;
  /**
   * The plant at a growth step with the distal end of a segment held at a place (x, y, z in m), as a pointer does: its
   * `params.loads.forces` name the force that holds it. Out of reach, the point comes as near as it can; null when there
   * is no such segment or no equilibrium. Requests for plants and these take each other's place. Letting go is
   * asking for the plant again, which is the same to the last bit.
   */
  hold(
    params: ParamsInput,
    step: number | null,
    segment: number,
    place: Vector,
    options?: PlantOptions,
  ): Promise<Plant | null>;
  /** Ends it: what is pending rejects with an `"AbortError"`. */
  dispose(): void;
}

/** How an engine may be started. */
export interface EngineOptions {
  /** What the wasm comes from, as for `init`. Left out, it is the file beside the code. */
  wasm?: Source | PromiseLike<Source>;
  /**
   * Address of the worker's script, for bundlers that do not see the one beside the code: a file of your own that
   * imports `"bough/worker-script"`. False: no worker, the engine computes in this thread.
   */
  worker?: string | URL | false;
}

const browser: Host = {
  workerEngine,
  threadEngine,
  read: (source) => source,
  cores: () => navigator.hardwareConcurrency,
};

/**
 * An engine in a worker; where no worker can start (a page from a file, a strict host), one in this thread that computes
 * in slices of some milliseconds.
 * @throws {LoadError} if the wasm cannot be loaded
 */
export function startEngine(options: EngineOptions = {}): Promise<Engine> {
  return startOn(browser, options);
}

/**
 * Several workers behind one queue, for many plants at once; where no worker can start, one engine in this thread.
 * @throws {LoadError} if the wasm cannot be loaded
 */
export function startPool(options: PoolOptions = {}): Promise<Pool> {
  return startPoolOn(browser, options);
}

/** An engine in this thread. */
export function threadEngine({ module, reason }: Parts = {}): Engine {
  return engineInThread(() => load(() => module ?? wasmAddress), reason);
}

export { workerEngine };
