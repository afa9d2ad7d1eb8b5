// What every part of the bench gets.

/**
 * @typedef {object} Bench
 * @property {import("./table.mjs").Table} table
 * @property {import("./samples.mjs").Effort} effort
 * @property {boolean} quick
 * @property {boolean} fresh whether slow peers are timed again
 * @property {readonly [import("./hosts.mjs").Host, import("./hosts.mjs").Host, import("./hosts.mjs").Host]} hosts native,
 *   Node, Chromium
 * @property {import("playwright").Browser} browser
 */
