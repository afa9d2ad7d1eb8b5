// One hash of the contents of files and folders, to tell whether what was made from them is up to date. Contents, not
// times: a fresh checkout or a switched branch changes times only.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { root } from "../paths.mjs";

/** Outputs, and what is installed. */
const made = ["target", "node_modules", ".venv"];

/** What only tests run, and what is only read. */
const beside = ["tests", "benches", "examples", "docs", "fuzz"];

/**
 * @param {readonly string[]} paths
 * @param {{ tests?: boolean }} [options] whether the code that only tests run is of it: it changes nothing in the build
 */
export function fingerprintOf(paths, { tests = false } = {}) {
  const ignored = new Set(tests ? made : [...made, ...beside]);
  const hash = createHash("sha256");
  for (const file of paths.flatMap((path) => filesUnder(path, ignored))) {
    hash
      .update(`${relative(root, file)}\0`)
      .update(readFileSync(file))
      .update("\0");
  }
  return hash.digest("hex");
}

/**
 * @param {string} path
 * @param {ReadonlySet<string>} ignored
 * @returns {string[]}
 */
function filesUnder(path, ignored) {
  if (!statSync(path).isDirectory()) return [path];
  const names = readdirSync(path).filter((name) => !ignored.has(name));
  return names.sort().flatMap((name) => filesUnder(join(path, name), ignored));
}
