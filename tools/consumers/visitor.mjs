// Chromium visits a consumer's page and brings back its report.

import { launchChromium } from "../chromium.mjs";
import { Obstacle } from "../obstacle.mjs";

export class Visitor {
  /** @type {Promise<import("playwright").Browser> | undefined} */
  #browser;

  /**
   * @param {string} address
   * @param {object} [options]
   * @param {RegExp} [options.expected] errors on the console that are part of the case
   * @param {string} [options.text] selector of an element whose text comes back as well
   * @returns {Promise<{ report: string, text: string }>} what the page put into `globalThis.report`
   */
  visit(address, { expected = /^$/, text } = {}) {
    return this.#on(address, expected, async (page) => {
      await page.waitForFunction(() => "report" in globalThis, undefined, { timeout: 30_000 });
      const report = await page.evaluate(() => Reflect.get(globalThis, "report"));
      return { report, text: text ? await page.locator(text).innerText() : "" };
    });
  }

  /**
   * Waits until a page shows a text, as a person does, and goes on from there.
   * @param {string} address
   * @param {RegExp} text
   * @param {object} [options]
   * @param {import("playwright").ViewportSize} [options.viewport] if another one than usual
   * @param {(page: import("playwright").Page) => Promise<void>} [options.more]
   */
  watch(address, text, { viewport, more } = {}) {
    const look = async (/** @type {import("playwright").Page} */ page) => {
      await page.locator("body").getByText(text).first().waitFor({ timeout: 60_000 });
      await more?.(page);
    };
    return this.#on(address, /^$/, look, viewport);
  }

  /**
   * @template Result
   * @param {string} address
   * @param {RegExp} expected
   * @param {(page: import("playwright").Page) => Promise<Result>} look
   * @param {import("playwright").ViewportSize} [viewport]
   */
  async #on(address, expected, look, viewport) {
    this.#browser ??= launchChromium();
    const context = await (await this.#browser).newContext(viewport ? { viewport } : {});
    const page = await context.newPage();
    /** @type {string[]} */
    const problems = [];
    page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
    page.on("console", (message) => {
      if (message.type() === "error") problems.push(`${message.text()} ${message.location().url}`);
    });
    try {
      await page.goto(address);
      const found = await look(page);
      const unexpected = problems.filter((problem) => !expected.test(problem));
      if (unexpected.length > 0) throw new Obstacle(unexpected.join("\n"));
      return found;
    } catch (error) {
      throw new Obstacle(`The page failed: ${error}`, { output: problems.join("\n") });
    } finally {
      await context.close();
    }
  }

  async close() {
    await (await this.#browser)?.close();
  }
}
