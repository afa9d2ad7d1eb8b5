/** Bough off the main thread in Node: as in browsers, over Node's own worker threads. */
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { wasmAddress } from "../engine/address.ts";
import { Client, type Connect } from "../engine/client.ts";
import type { Engine, EngineOptions } from "../engine/engine.ts";
import { type Pool, type PoolOptions, startPoolOn } from "../engine/pool.ts";
import type { Reply } from "../engine/protocol.ts";
import { type Host, type Parts, startOn } from "../engine/start.ts";
import { type Sweep, type SweepAxes, type SweepOptions, sweepOver } from "../engine/sweep.ts";
import { engineInThread } from "../engine/thread.ts";
import { load } from "../engine/wasm.ts";
import type { ParamsInput } from "../params/params.ts";
import { fromDisk } from "./node-disk.ts";

export * from "./worker-api.ts";

const node: Host = {
  workerEngine: (parts) => new Client("worker", connection(parts)),
  threadEngine: ({ module, reason }) =>
    engineInThread(() => load(() => fromDisk(module ?? wasmAddress)), reason),
  read: fromDisk,
  cores: availableParallelism,
};

/** An engine in a worker thread. */
export function startEngine(options: EngineOptions = {}): Promise<Engine> {
  return startOn(node, options);
}

/** Several worker threads behind one queue, for many plants at once. */
export function startPool(options: PoolOptions = {}): Promise<Pool> {
  return startPoolOn(node, options);
}

/**
 * Grows many plants at once and tells of them in columns: of one set of params or of a list of them, with every combination of
 * the axes' values. Bad params spoil their own row only.
 * @throws {BoughError} if an axis is no parameter
 */
export function sweep(
  params: ParamsInput | readonly ParamsInput[],
  axes: SweepAxes = {},
  options: SweepOptions = {},
): Promise<Sweep> {
  return sweepOver(startPool, params, axes, options);
}

function connection({ script, module }: Parts): Connect {
  return (onReply, onLoss) => {
    const worker = new Worker(script ?? new URL("./node-worker-script.js", import.meta.url), {
      name: "bough",
    });
    worker.on("message", (reply: Reply) => onReply(reply));
    worker.on("messageerror", () => onLoss("A message from the worker could not be read."));
    worker.on("error", (error) => onLoss(`The worker failed: ${error.message}`));
    worker.on("exit", (code) => onLoss(`The worker ended with exit code ${code}.`));
    if (module) worker.postMessage({ kind: "wasm", module });
    return {
      send: (request) => worker.postMessage(request),
      close: () => void worker.terminate(),
      // A program that waits for nothing any more may end, dispose or not.
      keepAlive: (isAwaited) => (isAwaited ? worker.ref() : worker.unref()),
    };
  };
}
