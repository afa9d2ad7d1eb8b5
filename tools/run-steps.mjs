// Runs steps one after the other, all of them even when one fails, and ends with a table.

import { Obstacle } from "./obstacle.mjs";
import { inSeconds, secondsSince } from "./run-command.mjs";

/**
 * @typedef {object} Runnable
 * @property {string} name
 * @property {() => Promise<void>} run
 */

/**
 * @param {readonly Runnable[]} steps
 * @returns {Promise<string>} the table
 */
export async function runSteps(steps) {
  const results = [];
  for (const { name, run } of steps) {
    const started = performance.now();
    const passed = await passes(run);
    results.push({ name, passed, seconds: secondsSince(started) });
  }
  const width = Math.max(12, ...results.map(({ name }) => name.length + 2));
  const row = (/** @type {string} */ sign, /** @type {string} */ name, /** @type {number} */ seconds) =>
    `${sign} ${name.padEnd(width)}${inSeconds(seconds).padStart(8)}`;
  const inAll = results.reduce((sum, { seconds }) => sum + seconds, 0);
  const rows = results.map(({ name, passed, seconds }) => row(passed ? "✓" : "✗", name, seconds));
  const table = [...rows, row(" ", "in all", inAll)].join("\n");
  console.log(`\n${table}`);
  const failed = results.filter(({ passed }) => !passed).map(({ name }) => name);
  if (failed.length > 0) throw new Obstacle(`Failed: ${failed.join(", ")}.`);
  return table;
}

/** @param {() => Promise<void>} run */
async function passes(run) {
  try {
    await run();
    return true;
  } catch (error) {
    if (!(error instanceof Obstacle)) throw error;
    if (error.output) console.error(error.output.trimEnd());
    console.error(error.message);
    return false;
  }
}
