// A reader in real Chromium who finds a live plant in somebody's page, and moves it.

import { Obstacle } from "../obstacle.mjs";

/**
 * Opens a page and lets work be done there; what went wrong on the page is an obstacle.
 * @param {import("playwright").Browser} browser
 * @param {string} address
 * @param {(page: import("playwright").Page) => Promise<string>} work
 * @param {RegExp} [expected] of what a host itself complains
 */
export async function visit(browser, address, work, expected = /favicon/) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  /** @type {string[]} */
  const problems = [];
  try {
    const page = await context.newPage();
    page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
    page.on("console", (message) => {
      if (message.type() === "error") problems.push(`${message.text()} ${message.location().url}`);
    });
    await page.goto(address);
    const words = await work(page);
    const unexpected = problems.filter((problem) => !expected.test(problem));
    if (unexpected.length > 0) throw new Obstacle(unexpected.join("\n"));
    return words;
  } catch (error) {
    if (error instanceof Obstacle) throw error;
    throw new Obstacle(`The page failed: ${error}`, { output: problems.join("\n") });
  } finally {
    await context.close();
  }
}

/**
 * Waits until a plant is drawn, moves its gravity to 2 m/s², and waits until that is drawn as well.
 * @param {import("playwright").Locator} plant
 * @returns {Promise<string>} what it then shows
 */
export async function move(plant) {
  await plant.evaluate(async (element) => {
    const plant = /** @type {HTMLElementTagNameMap["bough-plant"]} */ (element);
    await customElements.whenDefined("bough-plant");
    await plant.settled();
    await plant.toBlob();
  });
  await plant.getByRole("slider", { name: "Gravity" }).fill("2");
  return plant.evaluate(async (element) => {
    const plant = /** @type {HTMLElementTagNameMap["bough-plant"]} */ (element);
    await plant.settled();
    const { size } = await plant.toBlob();
    if (!/[?&]g=2(&|$)/.test(plant.link)) throw new Error(`It shows ${plant.link}.`);
    if (size < 1000) throw new Error("Its picture is empty.");
    return plant.link;
  });
}
