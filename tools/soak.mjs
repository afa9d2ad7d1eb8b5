// npm run soak: what takes too long for every check. It can be stopped and started again: what has passed for these
// sources is not run twice. Options: --only <job>, --shard 2/3 (every third shard, from the second on), --fresh.

import { parseArgs } from "node:util";
import { buildPackage } from "./build-package.mjs";
import { Obstacle, orExplain } from "./obstacle.mjs";
import { inSeconds, secondsSince } from "./run-command.mjs";
import { runSteps } from "./run-steps.mjs";
import { setUpForTests } from "./setup.mjs";

await orExplain(async () => {
  const { only, shard, fresh } = options();
  await setUpForTests();
  await buildPackage();
  // Imported only now: they need the node packages.
  const { shards } = await import("./soak/shards.mjs");
  const { Progress } = await import("./soak/progress.mjs");
  const { note } = await import("./soak/evidence.mjs");
  const progress = new Progress(fresh);
  const mine = shards.filter(
    ({ job }, index) => (only ?? job) === job && index % shard.of === shard.number - 1,
  );
  const due = mine.filter((shard) => !progress.has(shard));
  console.log(`${mine.length - due.length} of ${mine.length} shards have passed before.`);
  /** @type {Map<string, string[]>} */
  const found = new Map();
  const steps = due.map((shard) => ({
    name: shard.name,
    run: async () => {
      const { job, name, run } = shard;
      const started = performance.now();
      const words = (await run())
        .trim()
        .split("\n")
        .map((line) => `    ${line}`);
      const time = inSeconds(secondsSince(started));
      found.set(job, [
        ...(found.get(job) ?? []),
        `✓ ${name}, ${time}`,
        ...words.filter((line) => line.trim()),
      ]);
      progress.add(shard);
    },
  }));
  try {
    await runSteps(steps);
  } finally {
    for (const [job, lines] of found) note(job, lines);
  }
});

function options() {
  const string = /** @type {const} */ ({ type: "string" });
  const given = parseArgs({ options: { only: string, shard: string, fresh: { type: "boolean" } } }).values;
  const [, number = 1, of = 1] = (/^(\d+)\/(\d+)$/.exec(given.shard ?? "1/1") ?? []).map(Number);
  if (number < 1 || number > of) throw new Obstacle(`There is no shard ${given.shard}.`);
  return { only: given.only, fresh: given.fresh ?? false, shard: { number, of } };
}
