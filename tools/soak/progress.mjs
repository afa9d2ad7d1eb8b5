// Which shards have passed for the sources as they are: an interrupted run goes on where it was, and what only other jobs
// depend on may change meanwhile.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { root } from "../paths.mjs";
import { fingerprintOf } from "../setup/fingerprint.mjs";

const file = join(root, "dist", "soak.json");

const everything = ["rust-core", "web", "python", "tests", "tools", "package-lock.json"];

/** What jobs depend on where that is not everything. @type {Readonly<Record<string, readonly string[]>>} */
const sources = {
  mutants: ["rust-core", "tools/mutants", "tools/soak/mutants.mjs"],
  fuzz: ["rust-core", "tools/soak/fuzz.mjs"],
};

export class Progress {
  /** Of each shard that has passed, for which sources. @type {Record<string, string>} */
  #passed;
  /** @type {Map<string, string>} */
  #fingerprints = new Map();

  /** @param {boolean} fresh forget what has passed */
  constructor(fresh) {
    if (fresh) rmSync(file, { force: true });
    this.#passed = saved();
  }

  /** @param {import("./shards.mjs").Shard} shard */
  has({ job, name }) {
    return this.#passed[name] === this.#fingerprint(job);
  }

  /** @param {import("./shards.mjs").Shard} shard */
  add({ job, name }) {
    // Others may have passed meanwhile: shards can be run side by side.
    this.#passed = { ...this.#passed, ...saved(), [name]: this.#fingerprint(job) };
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, JSON.stringify(this.#passed));
  }

  /** @param {string} job */
  #fingerprint(job) {
    const known = this.#fingerprints.get(job);
    if (known) return known;
    const paths = (sources[job] ?? everything).map((path) => join(root, path));
    const fingerprint = fingerprintOf(paths, { tests: true });
    this.#fingerprints.set(job, fingerprint);
    return fingerprint;
  }
}

/** @returns {Record<string, string>} */
function saved() {
  return existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
}
