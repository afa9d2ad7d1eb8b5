/** Where the widget's wasm comes from: the file beside the code. The build of the one-file widget puts `inside.ts` here. */
import { wasmAddress } from "../engine/address.ts";
import type { Source } from "../engine/wasm.ts";

export function wasmSource(): Source | PromiseLike<Source> {
  return wasmAddress;
}
