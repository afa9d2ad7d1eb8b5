// What the measurements of the page have in common.

/**
 * @typedef {object} Figure
 * @property {string} name
 * @property {number[]} values all that was measured
 * @property {string} unit
 */

/**
 * @callback Measurement
 * @param {string} site the address of the built page
 * @param {() => Promise<import("playwright").Browser>} launch starts a browser
 * @returns {AsyncGenerator<Figure>}
 */

/**
 * Waits until all is drawn and at rest.
 * @param {import("playwright").Page} page
 */
export async function settled(page) {
  await page.waitForFunction(() => document.documentElement.dataset.settled === "true");
}
