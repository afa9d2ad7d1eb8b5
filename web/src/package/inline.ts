/** Bough with the wasm inside the JavaScript, for places that cannot load a second file. */
import { wasmInside } from "../engine/inline.ts";
import { load, type Source } from "../engine/wasm.ts";

export * from "./api.ts";

/** Makes Bough ready; every other function needs it. Only the first call does anything. */
export function init(source?: Source | PromiseLike<Source>): Promise<void> {
  return load(() => source ?? wasmInside());
}
