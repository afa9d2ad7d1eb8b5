// The build with all mutants in it, and what each test comes by: made once for the sources as they are, for all shards.

import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root, rustCore } from "../paths.mjs";
import { fingerprintOf } from "../setup/fingerprint.mjs";
import { buildSchemata } from "./schemata.mjs";
import { learnTests } from "./trials.mjs";

/** @typedef {import("./schemata.mjs").Schemata & { tests: readonly import("./trials.mjs").Test[] }} Prepared */

const folder = join(root, "dist", "mutants");
const file = join(folder, "prepared.json");

/** What became of the mutants of each shard that was tried of this build. */
export const fatesFolder = join(folder, "fates");

/** @returns {Promise<Prepared>} */
export async function prepare() {
  const sources = fingerprintOf([rustCore, join(root, "tools", "mutants")], { tests: true });
  const saved = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
  if (saved.sources === sources) return saved;
  rmSync(fatesFolder, { recursive: true, force: true });
  const schemata = await buildSchemata();
  const tests = await learnTests(schemata.binaries);
  writeFileSync(file, JSON.stringify({ sources, ...schemata, tests }));
  return { ...schemata, tests };
}
