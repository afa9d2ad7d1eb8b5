// Where the kernels of bench/native run: as a program, in this Node's wasm, in Chromium's wasm.

import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";

/** Numbers of the kernels, as in bench/native/src/kernel.rs. */
export const kernels = {
  floor: 0,
  iteration: 1,
  solve: 2,
  call: 3,
  growth: 4,
  pipes: 5,
  treeCall: 6,
  relaxation: 7,
  paper: 8,
  treeSolve: 9,
  iterationInSpace: 10,
};

/**
 * @typedef {object} Run
 * @property {number} seconds
 * @property {number} iterations of the last round
 *
 * @typedef {object} Host one kernel at a time
 * @property {string} name
 * @property {(kernel: number, size: number) => Promise<number>} prepare how many segments a round works on
 * @property {(rounds: number) => Promise<Run>} run
 * @property {() => Promise<[number, number]>} tip where the rod ends that was solved
 * @property {() => Promise<void>} close
 */

/**
 * A program that answers each line with a line.
 * @param {string} command
 * @param {readonly string[]} args
 */
export function dialogue(command, args) {
  const child = spawn(command, args, { stdio: ["pipe", "pipe", "pipe"] });
  let complaint = "";
  child.stderr.setEncoding("utf8").on("data", (text) => {
    complaint = text.trim().split("\n").at(-1) ?? "";
  });
  child.on("error", ({ message }) => {
    complaint = message;
  });
  // A program that has ended cannot be told so; the next line that does not come says it.
  child.stdin.on("error", () => {});
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  return {
    /** @param {string} line */
    async ask(line) {
      child.stdin.write(`${line}\n`);
      const { value, done } = await lines.next();
      if (done) throw new Error(complaint || `${command} has ended`);
      return /** @type {string} */ (value);
    },
    close() {
      child.stdin.end();
      child.kill();
    },
  };
}

/**
 * @param {string} program
 * @returns {Host}
 */
export function nativeHost(program) {
  const { ask, close } = dialogue(program, []);
  const numbers = async (/** @type {string} */ line) => (await ask(line)).split(" ").map(Number);
  return {
    name: "native",
    prepare: async (kernel, size) => (await numbers(`prepare ${kernel} ${size}`))[0] ?? 0,
    run: async (rounds) => {
      const [seconds = 0, iterations = 0] = await numbers(`run ${rounds}`);
      return { seconds, iterations };
    },
    tip: async () => {
      const [x = 0, y = 0] = await numbers("tip");
      return [x, y];
    },
    close: async () => close(),
  };
}

/** @param {string} wasm its path @returns {Promise<Host>} */
export async function nodeHost(wasm) {
  const { instance } = await WebAssembly.instantiate(readFileSync(wasm));
  const { prepare, run, tip } =
    /** @type {Record<"prepare" | "run" | "tip", (...numbers: number[]) => number>} */ (
      /** @type {unknown} */ (instance.exports)
    );
  return {
    name: "wasm, Node",
    prepare: async (kernel, size) => prepare(kernel, size),
    run: async (rounds) => {
      const start = performance.now();
      const iterations = run(rounds);
      return { seconds: (performance.now() - start) / 1000, iterations };
    },
    tip: async () => [tip(0), tip(1)],
    close: async () => {},
  };
}

/**
 * @param {string} wasm its path
 * @param {import("playwright").Browser} browser
 * @returns {Promise<Host>}
 */
export async function chromiumHost(wasm, browser) {
  const page = await browser.newPage();
  const exports = await page.evaluateHandle(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const { instance } = await WebAssembly.instantiate(bytes);
    return /** @type {Record<string, (...numbers: number[]) => number>} */ (
      /** @type {unknown} */ (instance.exports)
    );
  }, readFileSync(wasm).toString("base64"));
  return {
    name: "wasm, Chromium",
    prepare: (kernel, size) =>
      exports.evaluate(({ prepare }, numbers) => prepare?.(...numbers) ?? 0, [kernel, size]),
    run: (rounds) =>
      exports.evaluate(({ run }, count) => {
        const start = performance.now();
        const iterations = run?.(count) ?? 0;
        return { seconds: (performance.now() - start) / 1000, iterations };
      }, rounds),
    tip: () => exports.evaluate(({ tip }) => [tip?.(0) ?? 0, tip?.(1) ?? 0]),
    close: () => page.close(),
  };
}
