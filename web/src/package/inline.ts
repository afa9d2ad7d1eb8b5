/** Bough with the wasm inside the JavaScript, for places that cannot load a second file. */
import { wasmText } from "../../generated/bough-base64.ts";
import { load, type Source } from "../engine/wasm.ts";

export * from "./api.ts";

/** Makes Bough ready; every other function needs it. Only the first call does anything. */
export function init(source?: Source | PromiseLike<Source>): Promise<void> {
  return load(() => source ?? unpacked());
}

async function unpacked(): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(wasmText), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
