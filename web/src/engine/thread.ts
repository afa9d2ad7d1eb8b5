/** The engine in this thread: where workers are refused. The page stays responsive between its slices. */
import { Client, type Connect } from "./client.ts";
import type { Engine } from "./engine.ts";
import { Session } from "./session.ts";

/** An engine in this thread. `ready` makes the core ready; `reason` is why it is not in a worker, if it was to be. */
export function engineInThread(ready: () => Promise<void>, reason: string | null = null): Engine {
  const openSession: Connect = (onReply) => {
    const session = new Session(ready, onReply);
    return {
      send: (request) => void session.receive(request),
      close: () => session.close(),
    };
  };
  return new Client("thread", openSession, reason);
}
