// Short lines of what a soak found, for people to read: docs/evidence/<job>.txt.

import { appendFileSync, mkdirSync, readFileSync } from "node:fs";
import { arch, availableParallelism, platform } from "node:os";
import { join } from "node:path";
import { root } from "../paths.mjs";

const folder = join(root, "docs", "evidence");

/**
 * @param {string} job
 * @param {readonly string[]} lines
 */
export function note(job, lines) {
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const day = new Date().toISOString().slice(0, 10);
  const where = `Node ${process.version}, ${platform()} ${arch()}, ${availableParallelism()} cores`;
  mkdirSync(folder, { recursive: true });
  appendFileSync(join(folder, `${job}.txt`), `${day}, Bough ${version}, ${where}\n${lines.join("\n")}\n\n`);
}
