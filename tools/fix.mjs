// npm run fix: puts right what a machine can: format, simple lint, docs/parameters.md and docs/api.md.

import { nodeCommand, rustfmt, xtask } from "./commands.mjs";
import { orExplain } from "./obstacle.mjs";
import { runCommand } from "./run-command.mjs";
import { setUp } from "./setup.mjs";

await orExplain(async () => {
  await setUp();
  await runCommand("formatting the Rust", rustfmt());
  await runCommand("formatting everything else", [
    ...nodeCommand("@biomejs/biome", "biome"),
    "check",
    "--write",
  ]);
  await runCommand("printing docs/parameters.md", xtask("reference", "docs/parameters.md"));
  // Only now there is a compiler to read the types with.
  const { writeApiReference } = await import("./api-reference.mjs");
  writeApiReference();
});
