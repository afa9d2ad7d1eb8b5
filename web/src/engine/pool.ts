/** Several engines behind one queue: every request is answered, in the order in which they came. */
import type { Vector } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import type { ParamsInput } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import type { Engine, EngineOptions, PlantOptions } from "./engine.ts";
import { type Host, partsOf, startFrom } from "./start.ts";

/** How a pool may be started. */
export interface PoolOptions extends EngineOptions {
  /** How many workers at most: one less than there are processors, if it is left out. They start when they are needed. */
  size?: number;
}

/**
 * Many plants at once. It is asked like an engine, but no request takes the place of another: each waits in a queue until
 * a worker is free. An aborted request leaves the queue, or frees its worker. A worker that dies rejects the one request
 * it was at, and starts anew with the next.
 */
export interface Pool extends Engine {
  /** How many plants can grow at the same time. */
  readonly size: number;
}

/** A request that waits for an engine. */
interface Turn {
  take(engine: Engine): void;
  leave(reason: unknown): void;
}

/** The pool over given engines, which nobody else may ask. */
export class EnginePool implements Pool {
  readonly transport: Engine["transport"];
  readonly reason: string | null;
  readonly size: number;
  readonly #engines: readonly Engine[];
  /** The engine that was busy last is taken first: those that were never needed never start. */
  readonly #idle: Engine[];
  readonly #queue = new Set<Turn>();
  #isDisposed = false;

  constructor(first: Engine, ...others: Engine[]) {
    this.transport = first.transport;
    this.reason = first.reason;
    this.size = 1 + others.length;
    this.#engines = [first, ...others];
    this.#idle = [...others, first];
  }

  check(params: unknown): Promise<Issue[]> {
    // Quick, and none competes with a plant: any engine will do, and the first one runs.
    return (this.#engines[0] as Engine).check(params);
  }

  plant(params: ParamsInput, step: number | null = null, options: PlantOptions = {}): Promise<Plant> {
    return this.#inTurn(options, (engine) => engine.plant(params, step, options));
  }

  hold(
    params: ParamsInput,
    step: number | null,
    segment: number,
    place: Vector,
    options: PlantOptions = {},
  ): Promise<Plant | null> {
    return this.#inTurn(options, (engine) => engine.hold(params, step, segment, place, options));
  }

  dispose(): void {
    this.#isDisposed = true;
    for (const turn of this.#queue) turn.leave(disposed());
    for (const engine of this.#engines) engine.dispose();
  }

  /** Asks an engine, once it is this request's turn. */
  async #inTurn<Result>({ signal }: PlantOptions, ask: (engine: Engine) => Promise<Result>): Promise<Result> {
    const engine = await this.#turn(signal);
    try {
      return await ask(engine);
    } finally {
      this.#pass(engine);
    }
  }

  /** An engine of one's own, until it is passed on. */
  #turn(signal: AbortSignal | undefined): Promise<Engine> {
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      if (this.#isDisposed) throw disposed();
      const idle = this.#idle.pop();
      if (idle) return resolve(idle);
      const abort = () => turn.leave(signal?.reason);
      const end = () => {
        this.#queue.delete(turn);
        signal?.removeEventListener("abort", abort);
      };
      const turn: Turn = {
        take: (engine) => {
          end();
          resolve(engine);
        },
        leave: (reason) => {
          end();
          reject(reason);
        },
      };
      this.#queue.add(turn);
      signal?.addEventListener("abort", abort);
    });
  }

  #pass(engine: Engine): void {
    const [next] = this.#queue;
    if (next) next.take(engine);
    else this.#idle.push(engine);
  }
}

function disposed(): DOMException {
  return new DOMException("The pool was disposed of.", "AbortError");
}

/** Starts a pool. */
export async function startPoolOn(host: Host, options: PoolOptions): Promise<Pool> {
  const { size = Math.max(host.cores() - 1, 1), worker } = options;
  if (!Number.isInteger(size) || size < 1) {
    throw new RangeError(`The size of a pool must be a whole number from 1 on; it is ${size}.`);
  }
  const parts = await partsOf(host, options);
  const first = await startFrom(host, parts, worker !== false);
  // Several engines in one thread would only get in each other's way.
  const others = first.transport === "thread" ? 0 : size - 1;
  return new EnginePool(first, ...Array.from({ length: others }, () => host.workerEngine(parts)));
}
