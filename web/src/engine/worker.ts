/** The worker: a session behind a message port. */
import { wasmAddress } from "./address.ts";
import type { Request, Wasm } from "./protocol.ts";
import { Session } from "./session.ts";
import { load, type Source } from "./wasm.ts";

let source: Source = wasmAddress;

const session = new Session(
  () => load(() => source),
  (reply, buffers) => self.postMessage(reply, { transfer: buffers }),
);

self.addEventListener("message", ({ data }: MessageEvent<Request | Wasm>) => {
  if (data.kind === "wasm") source = data.module;
  else void session.receive(data);
});
