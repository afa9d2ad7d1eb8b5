/** Bough for Node: as in browsers, but the wasm is read from the disk. */
import { wasmAddress } from "../engine/address.ts";
import { load, type Source } from "../engine/wasm.ts";
import { fromDisk } from "./node-disk.ts";

export * from "./api.ts";

/**
 * Makes Bough ready; every other function needs it. Only the first call loads; after a failure the next one tries
 * again. Addresses may be of files (`file:`).
 */
export function init(source: Source | PromiseLike<Source> = wasmAddress): Promise<void> {
  return load(() => fromDisk(source));
}
