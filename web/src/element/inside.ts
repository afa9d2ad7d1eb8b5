/** Where the one-file widget's wasm comes from: its own code. */
export { wasmInside as wasmSource } from "../engine/inline.ts";
