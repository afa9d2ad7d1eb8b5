// npm run evidence: prints every figure that the docs quote, as the tests measure it. Words on the command line choose
// tests by name, as cargo has it: `npm run evidence -- order`.

import { cargo } from "./commands.mjs";
import { orExplain } from "./obstacle.mjs";
import { runCommand } from "./run-command.mjs";
import { requireRust } from "./setup/rust.mjs";

const core = ["--package", "bough-plant"];

await orExplain(async () => {
  requireRust();
  const names = process.argv.slice(2);
  const printing = ["--", "--nocapture", "--test-threads=1", ...names];
  await runCommand("figures of the tests", cargo("test", [...core, "--tests", ...printing]), {
    show: true,
  });
  if (names.length > 0) return;
  const largeTree = cargo("run", [...core, "--release", "--quiet", "--example", "large_tree"]);
  await runCommand("a tree of 100,000 segments", largeTree, { show: true });
});
