/** The engine in this thread: where workers are refused. The page stays responsive between its slices. */
import { wasmAddress } from "./address.ts";
import { Client, type Connect } from "./client.ts";
import type { Engine } from "./engine.ts";
import { Session } from "./session.ts";
import type { Parts } from "./start.ts";
import { load } from "./wasm.ts";

/** An engine in this thread; `ready` makes the core ready, if the wasm is not the one beside the code. */
export function threadEngine(
  { module, reason }: Parts = {},
  ready = () => load(() => module ?? wasmAddress),
): Engine {
  const openSession: Connect = (onReply) => {
    const session = new Session(ready, onReply);
    return {
      send: (request) => void session.receive(request),
      close: () => session.close(),
    };
  };
  return new Client("thread", openSession, reason ?? null);
}
