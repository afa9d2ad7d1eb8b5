// Which shards have passed for the sources as they are: an interrupted run goes on where it was.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
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
    const saved = existsSync(file) && !fresh ? JSON.parse(readFileSync(file, "utf8")) : {};
    this.#passed = new Set(saved.sources === this.#sources ? saved.passed : []);
  }

  /** @param {string} name */
  has(name) {
    return this.#passed.has(name);
  }

  /** @param {string} name */
  add(name) {
    this.#passed.add(name);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, JSON.stringify({ sources: this.#sources, passed: [...this.#passed] }));
  }
}
