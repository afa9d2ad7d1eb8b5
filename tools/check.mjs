// npm run check: set-up, then every step, or the ones named: npm run check -- --only rust,types

import { parseArgs } from "node:util";
import { Obstacle, orExplain } from "./obstacle.mjs";
import { runSteps } from "./run-steps.mjs";
import { setUpForTests } from "./setup.mjs";
import { steps } from "./steps.mjs";

await orExplain(async () => {
  const { only } = parseArgs({ options: { only: { type: "string" } } }).values;
  const chosen = only === undefined ? steps : only.split(",").map(stepNamed);
  await setUpForTests();
  await runSteps(chosen);
});

/** @param {string} name */
function stepNamed(name) {
  const found = steps.find((step) => step.name === name);
  if (found) return found;
  throw new Obstacle(`There is no step “${name}”: ${steps.map((step) => step.name).join(", ")}.`);
}
