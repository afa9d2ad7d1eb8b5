/** The wasm that lies in the code itself, for places that cannot load a second file. */
import { wasmText } from "../../generated/bough-base64.ts";

/** Unpacks the core's. */
export function wasmInside(): Promise<ArrayBuffer> {
  return unpacked(wasmText);
}

/** Unpacks what was compressed by gzip and written in base64. */
export async function unpacked(text: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
