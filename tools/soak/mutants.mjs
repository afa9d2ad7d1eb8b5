// Mutation testing of the core's mechanics and growth: a change of the code that no test notices is a missing test.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";

/** How many shards: each takes about an hour on a quiet machine with two cores. */
export const mutantShards = 40;

/**
 * Tries every so manieth mutant. rust-core/.cargo/mutants.toml says of which files.
 * @param {number} shard from 0 on
 * @returns {Promise<string>} how many were caught, and each that survived
 */
export async function tryMutants(shard) {
  const out = join(root, "dist", "mutants", String(shard));
  const shards = ["--shard", `${shard}/${mutantShards}`, "--sharding", "round-robin", "--output", out];
  const tests = ["--cargo-test-arg=--locked", "--", "--lib", "--tests"];
  const command = ["cargo", "mutants", "--package", "bough-plant", ...shards, ...tests];
  const remedy = "cargo install cargo-mutants --locked";
  // Survivors are a finding, not a failure of the run: exit code 2.
  await runCommand(
    `mutants, shard ${shard}`,
    ["sh", "-c", `${command.map(quoted).join(" ")}; [ $? -le 3 ]`],
    {
      cwd: rustCore,
      limit: 36_000,
      remedy,
    },
  );
  const listed = (/** @type {string} */ name) => {
    const file = join(out, "mutants.out", `${name}.txt`);
    return existsSync(file) ? readFileSync(file, "utf8").split("\n").filter(Boolean) : [];
  };
  const [caught, missed, timedOut] = [listed("caught"), listed("missed"), listed("timeout")];
  const all = caught.length + missed.length + timedOut.length;
  const share = (100 * (caught.length + timedOut.length)) / Math.max(all, 1);
  return [
    `${all} mutants, ${share.toFixed(1)} % caught`,
    ...missed.map((mutant) => `survived: ${mutant}`),
  ].join("\n");
}

/** @param {string} text */
function quoted(text) {
  return `'${text.replaceAll("'", "'\\''")}'`;
}
