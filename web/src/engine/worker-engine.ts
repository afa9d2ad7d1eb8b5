/** The engine in a worker: the page never waits for it. */
import { Client, type Connect } from "./client.ts";
import type { Engine } from "./engine.ts";
import type { Parts } from "./start.ts";

/** An engine in a worker, which starts with the first request. */
export function workerEngine(parts: Parts = {}): Engine {
  return new Client("worker", connection(parts));
}

function connection({ script, module }: Parts): Connect {
  return (onReply, onLoss) => {
    const worker =
      script === undefined ? workerBeside() : new Worker(script, { type: "module", name: "bough" });
    worker.addEventListener("message", ({ data }) => onReply(data));
    worker.addEventListener("messageerror", () => onLoss("A message from the worker could not be read."));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      onLoss(
        event.message ? `The worker failed: ${event.message}` : "The browser would not start the worker.",
      );
    });
    if (module) worker.postMessage({ kind: "wasm", module });
    return {
      send: (request) => worker.postMessage(request),
      close: () => worker.terminate(),
    };
  };
}

/** Written as bundlers look for it. ".js" is what the package ships; Vite finds the source behind it. */
function workerBeside(): Worker {
  return new Worker(new URL("./worker.js", import.meta.url), { type: "module", name: "bough" });
}
