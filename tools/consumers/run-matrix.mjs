// Packs the package, lets consumers install and use it, and prints a table of passes.

import { Obstacle } from "../obstacle.mjs";
import { runSteps } from "../run-steps.mjs";
import { Visitor } from "./visitor.mjs";
import { Workshop } from "./workshop.mjs";

/**
 * @param {readonly import("./matrix.mjs").Consumer[]} consumers
 * @returns {Promise<string>} the table
 */
export async function runMatrix(consumers) {
  const place = { workshop: new Workshop(), visitor: new Visitor() };
  try {
    await place.workshop.open();
    return await runSteps(consumers.map(({ name, run }) => ({ name, run: () => orFail(() => run(place)) })));
  } finally {
    await place.visitor.close();
    place.workshop.close();
  }
}

/**
 * Whatever goes wrong in one consumer, the others are tried.
 * @param {() => Promise<void>} run
 */
async function orFail(run) {
  try {
    await run();
  } catch (error) {
    throw error instanceof Obstacle ? error : new Obstacle(String(error));
  }
}
