/** Starts an engine where this code runs: in a worker if one can start, else in this thread. */
import type { Engine, EngineOptions } from "./engine.ts";
import { LostError } from "./failure.ts";
import { type CompiledModule, compiled, type Source } from "./wasm.ts";

/** What the two kinds of engine are made from. */
export interface Parts {
  /** Address of the worker's script, if it is not the one beside the code. */
  script?: string | URL | undefined;
  /** The compiled wasm, if it is not to be loaded from beside the code. */
  module?: CompiledModule | undefined;
  /** Why an engine in this thread is not a worker. */
  reason?: string;
}

/** What differs between browsers and Node. */
export interface Host {
  workerEngine(parts: Parts): Engine;
  threadEngine(parts: Parts): Engine;
  /** Reads what only this host can read. */
  read(source: Source): Source | PromiseLike<Source>;
  /** How many processors there are. */
  cores(): number;
}

/** Starts an engine. */
export async function startOn(host: Host, options: EngineOptions): Promise<Engine> {
  return startFrom(host, await partsOf(host, options), options.worker !== false);
}

/** What is given is loaded once, here, for all engines made of it. */
export async function partsOf(host: Host, { wasm, worker }: EngineOptions): Promise<Parts> {
  const module = wasm === undefined ? undefined : await compiled(await host.read(await wasm));
  return { module, script: worker || undefined };
}

/** The worker engine if it can be had. */
export async function startFrom(host: Host, parts: Parts, mayBeWorker: boolean): Promise<Engine> {
  const engine = mayBeWorker ? host.workerEngine(parts) : host.threadEngine(parts);
  try {
    await engine.check({});
    return engine;
  } catch (error) {
    engine.dispose();
    // Anything else, say a wasm that is not there, would be no better in this thread.
    if (!(error instanceof LostError)) throw error;
    return host.threadEngine({ ...parts, reason: error.message });
  }
}
