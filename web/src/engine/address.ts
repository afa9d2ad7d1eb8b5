/** Where the wasm is, for bundlers to see: a file beside the code, in the site as in the package. */
export const wasmAddress = new URL("../../generated/bough.wasm", import.meta.url);
