/** The worker thread in Node: a session behind its port. */
import { parentPort } from "node:worker_threads";
import { wasmAddress } from "../engine/address.ts";
import type { Request, Wasm } from "../engine/protocol.ts";
import { Session } from "../engine/session.ts";
import { load, type Source } from "../engine/wasm.ts";
import { fromDisk } from "./node-disk.ts";

let source: Source = wasmAddress;

const session = new Session(
  () => load(() => fromDisk(source)),
  (reply, buffers) => parentPort?.postMessage(reply, buffers),
);

parentPort?.on("message", (message: Request | Wasm) => {
  if (message.kind === "wasm") source = message.module;
  else void session.receive(message);
});
