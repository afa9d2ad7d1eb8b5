// npm run consumers: the packed package in the hands of every kind of consumer, or those whose names have a word in
// them: npm run consumers -- --only Vite

import { parseArgs } from "node:util";
import { buildPackage } from "./build-package.mjs";
import { orExplain } from "./obstacle.mjs";
import { setUpForTests } from "./setup.mjs";

await orExplain(async () => {
  const { only = "" } = parseArgs({ options: { only: { type: "string" } } }).values;
  await setUpForTests();
  await buildPackage();
  // Imported only now: they need the node packages.
  const { matrix } = await import("./consumers/matrix.mjs");
  const { runMatrix } = await import("./consumers/run-matrix.mjs");
  const chosen = matrix.filter(({ name }) => name.toLowerCase().includes(only.toLowerCase()));
  await runMatrix(chosen);
});
