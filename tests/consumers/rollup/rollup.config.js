import { readFileSync } from "node:fs";
import resolve from "@rollup/plugin-node-resolve";

/** Rollup follows no `new URL(…, import.meta.url)`: the wasm is laid beside the code. */
const wasm = {
  name: "bough-wasm",
  generateBundle() {
    const source = readFileSync(new URL(import.meta.resolve("bough/bough.wasm")));
    this.emitFile({ type: "asset", fileName: "bough.wasm", source });
  },
};

export default [
  { input: ["main.js", "bough-worker.js"], output: { dir: "dist" }, plugins: [resolve(), wasm] },
  { input: "error.js", output: { dir: "dist" }, plugins: [resolve()] },
  { input: "presets.js", output: { dir: "dist" }, plugins: [resolve()] },
];
