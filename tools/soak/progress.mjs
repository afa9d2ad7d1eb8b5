// Which shards have passed for the sources as they are: an interrupted run goes on where it was.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { root } from "../paths.mjs";
import { fingerprintOf } from "../setup/fingerprint.mjs";

const file = join(root, "dist", "soak.json");

export class Progress {
  #sources = fingerprintOf(
    ["rust-core", "web", "python", "tests", "tools", "package-lock.json"].map((path) => join(root, path)),
  );
  /** @type {Set<string>} */
  #passed;

  /** @param {boolean} fresh forget what has passed */
  constructor(fresh) {
    if (fresh) rmSync(file, { force: true });
    this.#passed = new Set(this.#saved());
  }

  /** @returns {string[]} */
  #saved() {
    const saved = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
    return saved.sources === this.#sources ? saved.passed : [];
  }

  /** @param {string} name */
  has(name) {
    return this.#passed.has(name);
  }

  /** @param {string} name */
  add(name) {
    // Others may have passed meanwhile: shards can be run side by side.
    this.#passed = new Set([...this.#saved(), ...this.#passed, name]);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, JSON.stringify({ sources: this.#sources, passed: [...this.#passed] }));
  }
}
