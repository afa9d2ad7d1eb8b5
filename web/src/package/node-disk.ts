/** Files by their address, which Node's `fetch` refuses. */
import { readFile } from "node:fs/promises";
import { LoadError } from "../engine/failure.ts";
import type { Source } from "../engine/wasm.ts";

/** The source; if it is the address of a file, the file's bytes. */
export async function fromDisk(source: Source | PromiseLike<Source>): Promise<Source> {
  const given = await source;
  const isFile = String(given).startsWith("file:");
  if (!isFile) return given;
  try {
    return await readFile(new URL(String(given)));
  } catch (error) {
    throw new LoadError(`The WebAssembly at ${given} could not be read. ${error}`, { cause: error });
  }
}
