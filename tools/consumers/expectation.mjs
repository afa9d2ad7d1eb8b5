// What every consumer must report: the fingerprints that the native core and Node's wasm are compared with as well.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Obstacle } from "../obstacle.mjs";
import { root } from "../paths.mjs";

/** What `consume` of tests/consumers/program.js returns. */
function expectedReport() {
  const recorded = readFileSync(join(root, "tests", "contract", "fingerprints.txt"), "utf8");
  const presets = recorded.split("\n").filter((line) => /^\S+ \w{16}$/.test(line) && !line.includes("/"));
  const [, sample] = (presets[0] ?? "").split(" ");
  return [
    ...presets,
    `inline ${sample}`,
    `engine in worker ${sample}`,
    `pool in worker ${sample} ${sample} ${sample}`,
    "refused true axis.segments",
  ].join("\n");
}

/** @param {string} report */
export function requireReport(report) {
  requireEqual(report, expectedReport());
}

/**
 * @param {string} found
 * @param {string} expected
 */
export function requireEqual(found, expected) {
  if (found.trim() === expected.trim()) return;
  const lines = expected.trim().split("\n");
  const differing = found
    .trim()
    .split("\n")
    .filter((line, index) => line !== lines[index]);
  const missing = lines.slice(found.trim().split("\n").length);
  const output = [
    ...differing.map((line) => `found    ${line}`),
    ...missing.map((line) => `missing  ${line}`),
  ];
  throw new Obstacle("It reports something else than it should.", { output: output.join("\n") });
}
