// What took minutes is kept, by peer and size, as long as its script is the same: a bench that was stopped goes on.

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { root } from "../tools/paths.mjs";

const folder = join(root, "bench", ".cache");

/**
 * @template T
 * @param {string} script of the peer
 * @param {string} what is done with it
 * @param {boolean} fresh
 * @param {() => Promise<T>} work
 * @returns {Promise<{ result: T, day: string | undefined }>} `day` says when, if it is from an earlier run
 */
export async function kept(script, what, fresh, work) {
  const source = createHash("sha256").update(readFileSync(script)).digest("hex").slice(0, 12);
  const file = join(folder, `${what.replace(/\W+/g, "-")}-${source}.json`);
  if (!fresh && existsSync(file)) return JSON.parse(readFileSync(file, "utf8"));
  const result = await work();
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, JSON.stringify({ result, day: new Date().toISOString().slice(0, 10) }));
  return { result, day: undefined };
}
