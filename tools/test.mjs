// npm test: set-up with a browser, then every test of the check.

import { orExplain } from "./obstacle.mjs";
import { runSteps } from "./run-steps.mjs";
import { setUpForTests } from "./setup.mjs";
import { steps } from "./steps.mjs";

await orExplain(async () => {
  await setUpForTests();
  await runSteps(steps.filter((step) => step.isTest));
});
