/** Loads the core's WebAssembly, once, from wherever it comes. */
import * as glue from "../../generated/bough.js";
import { LoadError } from "./failure.ts";

/** Something that the wasm's bytes come from. */
type Origin = URL | string | Response | ArrayBuffer | ArrayBufferView<ArrayBuffer>;

/** A `WebAssembly.Module`: TypeScript's own type of it takes anything, and is not known without the DOM's types. */
export type CompiledModule = object;

/** What the wasm can be loaded from: its address, a response, its bytes, or the compiled module. */
export type Source = URL | string | Response | ArrayBuffer | ArrayBufferView<ArrayBuffer> | CompiledModule;

let loading: Promise<void> | undefined;
let loaded = false;

/** Makes the core ready. Only the first call asks for the source; after a failure the next one does so again. */
export function load(source: () => Source | PromiseLike<Source>): Promise<void> {
  loading ??= instantiate(source).catch((error: unknown) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

/** Whether the core is ready. */
export function isLoaded(): boolean {
  return loaded;
}

async function instantiate(source: () => Source | PromiseLike<Source>): Promise<void> {
  const module = await compiled(await source());
  await glue.default({ module_or_path: module as WebAssembly.Module });
  loaded = true;
}

/** The module, from wherever it comes; workers take it as it is. */
export async function compiled(source: Source): Promise<CompiledModule> {
  if (typeof WebAssembly === "undefined") {
    throw new LoadError("This browser has no WebAssembly; in a lockdown mode it may be switched off.");
  }
  if (source instanceof WebAssembly.Module) return source;
  const { bytes, origin } = await received(source as Origin);
  requireWasm(bytes, origin);
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    const isForbidden = /content.security.policy|unsafe-eval/i.test(reason(error));
    const why = isForbidden
      ? "the page's Content-Security-Policy forbids it; its script-src needs 'wasm-unsafe-eval'"
      : "it is cut off, or this browser is too old (it must know SIMD)";
    throw new LoadError(`${origin} is WebAssembly that cannot be compiled here: ${why}. ${reason(error)}`, {
      cause: error,
    });
  }
}

/** The bytes are looked at rather than streamed: then a wrong MIME type is no error, and a wrong file a clear one. */
async function received(source: Origin): Promise<{ bytes: BufferSource; origin: string }> {
  if (isBytes(source)) return { bytes: source, origin: "What was given as bytes" };
  const isAddress = typeof source === "string" || source instanceof URL;
  const response = isAddress ? await fetched(source) : source;
  const origin = `What came from ${response.url || "the given response"}`;
  if (!response.ok) {
    throw new LoadError(
      `${origin} is not WebAssembly: the server answered ${response.status} ${response.statusText}.`,
    );
  }
  try {
    return { bytes: await response.arrayBuffer(), origin };
  } catch (error) {
    throw new LoadError(`${origin} could not be read to its end. ${reason(error)}`, { cause: error });
  }
}

/** By its tag: bytes may come from another realm, a test's sandbox say. */
function isBytes(source: Origin): source is BufferSource {
  return ArrayBuffer.isView(source) || Object.prototype.toString.call(source) === "[object ArrayBuffer]";
}

async function fetched(address: URL | string): Promise<Response> {
  try {
    return await fetch(address);
  } catch (error) {
    throw new LoadError(`The WebAssembly at ${address} could not be fetched. ${reason(error)}`, {
      cause: error,
    });
  }
}

/** Every wasm begins with a zero byte and "asm". */
function requireWasm(source: BufferSource, origin: string): void {
  const bytes = ArrayBuffer.isView(source)
    ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
    : new Uint8Array(source);
  const beginning = String.fromCharCode(...bytes.subarray(0, 60));
  if (beginning.startsWith("\0asm")) return;
  const what = bytes.length === 0 ? "it is empty" : `it begins with “${printable(beginning)}”`;
  const hint = /^\s*</.test(beginning) ? ": a web page, as servers send it for files they do not have" : "";
  throw new LoadError(`${origin} is not WebAssembly; ${what}${hint}.`);
}

function printable(text: string): string {
  return text.replace(/[^ -~]+/g, " ").trim();
}

function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
