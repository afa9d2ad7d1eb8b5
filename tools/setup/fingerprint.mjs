// One hash of the contents of files and folders, to tell whether what was made from them is up to date. Contents, not
// times: a fresh checkout or a switched branch changes times only.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { root } from "../paths.mjs";

/** What changes nothing in the build: outputs, what is installed, and code that only tests run. */
const ignored = new Set(["target", "tests", "benches", "examples", "docs", "fuzz", "node_modules", ".venv"]);

/** @param {readonly string[]} paths */
export function fingerprintOf(paths) {
  const hash = createHash("sha256");
  for (const file of paths.flatMap(filesUnder)) {
    hash
      .update(`${relative(root, file)}\0`)
      .update(readFileSync(file))
      .update("\0");
  }
  return hash.digest("hex");
}

/**
 * @param {string} path
 * @returns {string[]}
 */
function filesUnder(path) {
  if (!statSync(path).isDirectory()) return [path];
  const names = readdirSync(path).filter((name) => !ignored.has(name));
  return names.sort().flatMap((name) => filesUnder(join(path, name)));
}
