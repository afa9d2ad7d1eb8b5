/** Keeps the plant in step with what is wanted: the newest wish counts, and no wishes queue up. */

import { BoughError, type Issue } from "../params/issue.ts";
import { type Params, sameParams } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import type { Engine } from "./engine.ts";
import { LostError } from "./failure.ts";

/** Who is told what came of a wish. */
export interface Listener {
  /** A plant at the wanted age, and the same full grown. */
  onPlant(plant: Plant, grown: Plant): void;
  /** No plant can be grown from the wanted params. */
  onIssues(issues: readonly Issue[]): void;
  /** The engine broke. */
  onFailure(error: Error): void;
  /** The engine was lost in the midst of the work, and begins it anew. */
  onRestart?(): void;
  /** It takes long: the share that is done; null when it is over. */
  onProgress(share: number | null): void;
  /** Nothing is wanted any more. */
  onRest(): void;
}

/** After this time a wish counts as long: it is shown to go on, and gives way to a newer one. ms */
const long = 150;

interface Wish {
  readonly params: Params;
  readonly step: number | null;
  /** Whether the engine was lost over it already: what kills two engines would kill a third. */
  readonly again?: boolean;
}

export class Grower {
  readonly #engine: Engine;
  readonly #listener: Listener;
  #wish: Wish | null = null;
  #running: { abort: AbortController; isLong: boolean } | null = null;
  /** The last full-grown plant, and the params it was wanted with. */
  #grown: { params: Params; plant: Plant } | null = null;

  constructor(engine: Engine, listener: Listener) {
    this.#engine = engine;
    this.#listener = listener;
  }

  /** Whether a wish is being fulfilled. */
  get busy(): boolean {
    return this.#running !== null;
  }

  /** Wants a plant at a growth step (null: full grown), instead of anything wanted before. */
  want(params: Params, step: number | null): void {
    this.#wish = { params, step };
    if (this.#running?.isLong) this.#running.abort.abort();
    if (!this.#running) void this.#run();
  }

  /** Wants nothing any more. */
  cancel(): void {
    this.#wish = null;
    this.#running?.abort.abort();
  }

  async #run(): Promise<void> {
    while (this.#wish) {
      const wish = this.#wish;
      this.#wish = null;
      const running = { abort: new AbortController(), isLong: false };
      this.#running = running;
      const timer = setTimeout(() => {
        running.isLong = true;
        if (this.#wish) running.abort.abort();
        else this.#listener.onProgress(0);
      }, long);
      const failure = await this.#fulfil(wish, running).then(
        () => null,
        (error: unknown) => ({ error }),
      );
      clearTimeout(timer);
      // Before a failure is told: the end of the work takes back what was said of it.
      if (running.isLong) this.#listener.onProgress(null);
      if (failure && !running.abort.signal.aborted) this.#recover(wish, failure.error);
    }
    this.#running = null;
    this.#listener.onRest();
  }

  /** Age first, then full age: the one is wanted, the other is the frame that it is seen in. */
  async #fulfil({ params, step }: Wish, running: { abort: AbortController; isLong: boolean }): Promise<void> {
    const { signal } = running.abort;
    const onProgress = (share: number) => {
      if (running.isLong) this.#listener.onProgress(share);
    };
    const grow = (at: number | null) => this.#engine.plant(params, at, { signal, onProgress });
    const known = this.#grown && sameParams(this.#grown.params, params) ? this.#grown.plant : null;
    const isYoung = step !== null && step < (known?.report.steps ?? Number.POSITIVE_INFINITY);
    const young = isYoung ? await grow(step) : null;
    if (young && running.isLong && !known) this.#listener.onPlant(young, young);
    const grown = known ?? (await grow(null));
    this.#grown = { params, plant: grown };
    this.#listener.onPlant(young ?? grown, grown);
  }

  /** After a loss the wish is made once more: the next request starts a new engine. Everything else is told. */
  #recover(wish: Wish, error: unknown): void {
    if (error instanceof LostError && !wish.again) {
      this.#wish ??= { ...wish, again: true };
      this.#listener.onRestart?.();
    } else if (error instanceof BoughError) this.#listener.onIssues(error.issues);
    else this.#listener.onFailure(error instanceof Error ? error : new Error(String(error)));
  }
}
