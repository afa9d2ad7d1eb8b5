/** Where the page begins as a single file: everything is in it, and no worker can start from one. */
import { wasmInside } from "../engine/inline.ts";
import { engineInThread } from "../engine/thread.ts";
import { load } from "../engine/wasm.ts";
import { begin } from "./begin.ts";

void begin(async () =>
  engineInThread(() => load(wasmInside), "A page that is a file cannot start a worker."),
);
