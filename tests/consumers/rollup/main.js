import * as bough from "bough";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { consume } from "./program.js";

const source = new URL("./bough.wasm", import.meta.url);
const options = { wasm: source, worker: new URL("./bough-worker.js", import.meta.url) };

globalThis.report = await consume({ bough, inline, worker, source, options });
