/** Loading the wasm: from wherever it comes, and what is said when something else comes instead. */
import { readFile } from "node:fs/promises";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";

const address = new URL("../../web/generated/bough.wasm", import.meta.url);
const bytes = await readFile(address);

// Each test needs a package that has not been loaded yet.
beforeEach(() => {
  vi.resetModules();
});
afterEach(() => {
  vi.unstubAllGlobals();
});

const fresh = () => import("../../web/src/package/node.ts");

function expectGrown({ grow }: Awaited<ReturnType<typeof fresh>>): void {
  expect(grow({}).report.status).toBe("converged");
}

test("before init every function says what is missing", async () => {
  const { grow, history, check } = await fresh();
  const sentence = "Bough is not ready yet: call init() and wait for it first.";
  for (const call of [() => grow({}), () => history({}), () => check({})]) expect(call).toThrow(sentence);
});

describe("init takes", () => {
  test.each<[string, () => unknown]>([
    ["nothing", () => undefined],
    ["a file's URL", () => address],
    ["a file's address as text", () => address.href],
    ["bytes", () => bytes],
    ["an ArrayBuffer", () => new Uint8Array(bytes).buffer],
    ["a compiled module", () => WebAssembly.compile(bytes)],
    ["a promise of bytes", () => Promise.resolve(bytes)],
    [
      "a response, whatever its type",
      () => new Response(bytes, { headers: { "content-type": "text/plain" } }),
    ],
  ])("%s", async (_, source) => {
    const bough = await fresh();
    await bough.init((await source()) as Parameters<typeof bough.init>[0]);
    expectGrown(bough);
  });

  test("an address, which it fetches", async () => {
    const fetched = vi.fn(async () => new Response(bytes));
    vi.stubGlobal("fetch", fetched);
    const bough = await fresh();
    await bough.init("https://example.org/bough.wasm");
    expect(fetched).toHaveBeenCalledExactlyOnceWith("https://example.org/bough.wasm");
    expectGrown(bough);
  });
});

test("init loads once, however often and how soon it is called again", async () => {
  const fetched = vi.fn(async () => new Response(bytes));
  vi.stubGlobal("fetch", fetched);
  const bough = await fresh();
  await Promise.all([bough.init("https://example.org/a"), bough.init("https://example.org/b")]);
  await bough.init();
  expect(fetched).toHaveBeenCalledOnce();
  expectGrown(bough);
});

test("the browser's entry fetches the wasm beside the code; the inline entry needs no file", async () => {
  const fetched = vi.fn(async () => new Response(bytes));
  vi.stubGlobal("fetch", fetched);
  const bough = await import("../../web/src/package/index.ts");
  await bough.init();
  expect(fetched).toHaveBeenCalledExactlyOnceWith(address);
  expectGrown(bough);
  vi.resetModules();
  const inline = await import("../../web/src/package/inline.ts");
  await inline.init();
  expect(fetched).toHaveBeenCalledOnce();
  expectGrown(inline);
});

describe("what comes instead of the wasm is said", () => {
  const at = "What came from https://example.org/bough.wasm is";
  const page = "<!doctype html><title>Not here</title>";

  test.each<[string, () => Response | Promise<Response>, string]>([
    ["a 404", () => answer(page, 404), `${at} not WebAssembly: the server answered 404 Not Found.`],
    [
      "a page",
      () => answer(page, 200),
      `${at} not WebAssembly; it begins with “${page}”: a web page, as servers send it for files they do not have.`,
    ],
    ["nothing", () => answer("", 200), `${at} not WebAssembly; it is empty.`],
    [
      "half of it",
      () => answer(bytes.subarray(0, 1000), 200),
      `${at} WebAssembly that cannot be compiled here: it is cut off, or this browser is too old (it must know SIMD).`,
    ],
    [
      "no network",
      () => Promise.reject(new TypeError("fetch failed")),
      "The WebAssembly at https://example.org/bough.wasm could not be fetched. fetch failed",
    ],
  ])("%s", async (_, respond, sentence) => {
    vi.stubGlobal("fetch", async () => respond());
    const bough = await fresh();
    await expect(bough.init("https://example.org/bough.wasm")).rejects.toThrow(sentence);
    // The next call tries again.
    await bough.init();
    expectGrown(bough);
  });

  test("bytes that are something else", async () => {
    const { init } = await fresh();
    await expect(init(new TextEncoder().encode("hello"))).rejects.toThrow(
      "What was given as bytes is not WebAssembly; it begins with “hello”.",
    );
  });

  function answer(body: string | Uint8Array<ArrayBuffer>, status: number): Response {
    const response = new Response(body, { status, statusText: status === 404 ? "Not Found" : "" });
    return Object.defineProperty(response, "url", { value: "https://example.org/bough.wasm" });
  }
});
