// Whether tests notice mutants: each is switched on for the tests that come by it, the quickest first, until one fails.

import { spawn, spawnSync } from "node:child_process";
import { existsSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { testFolder } from "./schemata.mjs";

/**
 * @typedef {object} Test
 * @property {string} binary
 * @property {string} name
 * @property {number} time s
 * @property {readonly number[]} reached which mutants it comes by
 *
 * @typedef {"caught" | "timed out" | "survived" | "never reached"} Fate
 */

/** Tests that take longer are left out, s: a mutant that survives all others would take minutes. */
const longest = 3;

/**
 * The tests, each run once alone as the core is: the quickest first.
 * @param {readonly string[]} binaries
 * @returns {Promise<readonly Test[]>}
 */
export async function learnTests(binaries) {
  const named = binaries.flatMap((binary) => {
    const listed = spawnSync(binary, ["--list", "--format", "terse"], { encoding: "utf8" }).stdout;
    return [...listed.matchAll(/^(.+): test$/gm)].map(([, name = ""]) => ({ binary, name }));
  });
  /** @type {Test[]} */
  const tests = [];
  await inParallel(named, async ({ binary, name }, worker) => {
    const file = join(tmpdir(), `bough-reached-${process.pid}-${worker}`);
    const started = performance.now();
    const fate = await run(binary, name, { BOUGH_REACHED: file }, longest);
    if (fate === "caught") throw new Error(`${name} fails without any mutant.`);
    const time = (performance.now() - started) / 1000;
    const lines = existsSync(file) ? readFileSync(file, "utf8").split("\n").filter(Boolean) : [];
    const reached = [...new Set(lines.map(Number))];
    rmSync(file, { force: true });
    if (fate === "survived") tests.push({ binary, name, time, reached });
  });
  return tests.sort((one, other) => one.time - other.time);
}

/**
 * @param {readonly { id: number }[]} mutants
 * @param {readonly Test[]} tests
 * @param {(id: number, fate: Fate, by: string) => void} tell
 */
export async function tryMutants(mutants, tests, tell) {
  /** @type {Map<number, Test[]>} */
  const comingBy = new Map();
  for (const test of tests) {
    for (const id of test.reached) {
      const coming = comingBy.get(id);
      if (coming) coming.push(test);
      else comingBy.set(id, [test]);
    }
  }
  await inParallel(mutants, async ({ id }) => {
    const coming = comingBy.get(id) ?? [];
    for (const { binary, name, time } of coming) {
      const fate = await run(binary, name, { BOUGH_MUTANT: String(id) }, 3 + 5 * time);
      if (fate !== "survived") return tell(id, fate, name);
    }
    tell(id, coming.length > 0 ? "survived" : "never reached", "");
  });
}

/**
 * @param {string} binary
 * @param {string} name
 * @param {Record<string, string>} env
 * @param {number} limit s
 * @returns {Promise<Fate>}
 */
function run(binary, name, env, limit) {
  const options = {
    cwd: testFolder,
    env: { ...process.env, ...env },
    stdio: /** @type {const} */ ("ignore"),
  };
  return new Promise((resolve) => {
    const child = spawn(binary, ["--exact", name, "--test-threads", "1"], options);
    const timer = setTimeout(() => {
      child.kill("SIGKILL");
      resolve("timed out");
    }, limit * 1000);
    child.on("exit", (code) => {
      clearTimeout(timer);
      resolve(code === 0 ? "survived" : "caught");
    });
  });
}

/**
 * @template Item
 * @param {readonly Item[]} items
 * @param {(item: Item, worker: number) => Promise<void>} handle
 */
async function inParallel(items, handle) {
  const left = items.values();
  const work = async (/** @type {number} */ worker) => {
    for (const item of left) await handle(item, worker);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, (_, worker) => work(worker)));
}
