/** The wasm that lies in the code itself, for places that cannot load a second file. */
import { wasmText } from "../../generated/bough-base64.ts";

/** Unpacks it. */
export async function wasmInside(): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(wasmText), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
