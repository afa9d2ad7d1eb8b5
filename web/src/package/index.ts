/** Bough for browsers and bundlers: `await init()` fetches the wasm that lies beside the code. */
import { wasmAddress } from "../engine/address.ts";
import { load, type Source } from "../engine/wasm.ts";

export * from "./api.ts";

/**
 * Makes Bough ready; every other function needs it. Only the first call loads; after a failure the next one tries
 * again.
 * @param source the wasm's address, a response, its bytes, or the compiled module; left out, it is the file beside the code
 * @throws {LoadError} saying what came instead of the wasm
 */
export function init(source: Source | PromiseLike<Source> = wasmAddress): Promise<void> {
  return load(() => source);
}
