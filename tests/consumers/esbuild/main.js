import * as bough from "bough";
import wasm from "bough/bough.wasm";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { consume } from "./program.js";

// esbuild follows neither `new URL(…, import.meta.url)` nor `new Worker(…)`: it is told where both files are.
const source = new URL(wasm, import.meta.url);
const options = { wasm: source, worker: new URL("./bough-worker.js", import.meta.url) };

globalThis.report = await consume({ bough, inline, worker, source, options });
