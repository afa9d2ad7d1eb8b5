// The build with all mutants in it, and what each test comes by: made once for the sources as they are, for all shards.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root, rustCore } from "../paths.mjs";
import { fingerprintOf } from "../setup/fingerprint.mjs";
import { buildSchemata } from "./schemata.mjs";
import { learnTests } from "./trials.mjs";

/** @typedef {import("./schemata.mjs").Schemata & { tests: readonly import("./trials.mjs").Test[] }} Prepared */

const file = join(root, "dist", "mutants", "prepared.json");

/** @returns {Promise<Prepared>} */
export async function prepare() {
  const sources = fingerprintOf([rustCore, join(root, "tools", "mutants")], { tests: true });
  const saved = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
  if (saved.sources === sources) return saved;
  const schemata = await buildSchemata();
  const tests = await learnTests(schemata.binaries);
  writeFileSync(file, JSON.stringify({ sources, ...schemata, tests }));
  return { ...schemata, tests };
}
