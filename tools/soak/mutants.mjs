// Mutation testing of the core's mechanics and growth: a change of the code that no test notices is a missing test.

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fatesFolder, prepare } from "../mutants/prepared.mjs";
import { tryMutants } from "../mutants/trials.mjs";

/** How many shards: each takes some minutes on a quiet machine with two cores, the first one a minute more for the build. */
export const mutantShards = 8;

/**
 * Tries every so manieth mutant of all that rust-core/.cargo/mutants.toml names the files of.
 * @param {number} shard from 0 on
 * @returns {Promise<string>} how many were caught, and each that survived; of the last shard also how many of all
 */
export async function tryShard(shard) {
  const { mutants, unviable, unswitchable, tests } = await prepare();
  const mine = mutants.filter((_, index) => index % mutantShards === shard);
  /** @type {Map<number, { fate: string, by: string }>} */
  const fates = new Map();
  await tryMutants(mine, tests, (id, fate, by) => {
    fates.set(id, { fate, by });
    if (fates.size % 20 === 0) console.log(`  … ${fates.size} of ${mine.length} mutants`);
  });
  const told = mine.map(({ id, name }) => ({ name, ...fates.get(id) }));
  mkdirSync(fatesFolder, { recursive: true });
  writeFileSync(join(fatesFolder, `${shard}.json`), JSON.stringify(told));
  return [
    `${mine.length} of ${mutants.length} mutants that compile: ${caught(told)}`,
    `${unviable.length} do not compile; ${unswitchable.length} are in constants or iterators, and not tried`,
    ...told
      .filter(({ fate }) => fate === "survived" || fate === "never reached")
      .map(({ name, fate }) => `${fate}: ${name}`),
    ...allTold(mutants.length),
  ].join("\n");
}

/** @param {readonly { fate?: string }[]} told */
function caught(told) {
  const count = (/** @type {string} */ fate) => told.filter((mutant) => mutant.fate === fate).length;
  const noticed = count("caught") + count("timed out");
  const share = ((100 * noticed) / told.length).toFixed(1);
  return `${noticed} caught, ${count("timed out")} of them as they do not end: ${share} %`;
}

/**
 * Once all shards have been tried: the share that the soak is for.
 * @param {number} mutants how many there are
 */
function allTold(mutants) {
  const told = readdirSync(fatesFolder).flatMap((file) =>
    JSON.parse(readFileSync(join(fatesFolder, file), "utf8")),
  );
  return told.length === mutants ? [`all ${mutants} mutants: ${caught(told)}`] : [];
}
