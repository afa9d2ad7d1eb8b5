/** Thirty widgets on one page, and two dozen frames: every plant is seen, and few graphics contexts are held. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "../browser/chromium.ts";
import { choose, heldBy, scrollThrough, thirty, twoDozen } from "./crowd.ts";
import { contextsOf, type Host, open, openHost } from "./host.ts";

let browser: Browser;
let host: Host;
let frames: Host;

beforeAll(async () => {
  browser = await launchChromium();
  [host, frames] = [await openHost(), await openHost()];
});
afterAll(async () => {
  await browser.close();
  host.close();
  frames.close();
});

const page30 = `<html lang="en"><title>Thirty</title><style>
  body { display: grid; grid-template-columns: repeat(3, 1fr); gap: 1rem; }
</style><script src="bough-widget.js" defer></script>${thirty}</html>`;

describe("thirty widgets on a page", () => {
  it("all show their plant, scrolled through twice, with one context at most", {
    timeout: 240_000,
  }, async () => {
    const { page, problems } = await open(browser, host.page(page30));
    const elements = page.locator("bough-plant");
    const few = async () => expect((await contextsOf(page)).alive).toBeLessThanOrEqual(1);
    const seen = await scrollThrough(page, elements, few);
    await scrollThrough(page, elements, few);
    expect(seen.size).toBe(30);
    // At rest nobody holds one, and with the next change there is one again.
    await expect.poll(async () => (await contextsOf(page)).alive, { timeout: 30_000 }).toBe(0);
    const changed = await elements.last().evaluate(async (plant: HTMLElementTagNameMap["bough-plant"]) => {
      const before = await (await plant.toBlob()).text();
      plant.params = { loads: { gravity: 30 } };
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
      return (await (await plant.toBlob()).text()) !== before;
    });
    expect(changed).toBe(true);
    expect((await contextsOf(page)).alive).toBe(1);
    expect(problems).toEqual([]);
    await page.evaluate(() => document.body.replaceChildren());
    await expect.poll(async () => (await contextsOf(page)).alive).toBe(0);
    await page.context().close();
  });
});

describe("two dozen frames", () => {
  const page24 = () => `<html lang="en"><title>Frames</title>${twoDozen(frames.address)}</html>`;

  it("all show their plant, scrolled through twice, each holding a context only in view", {
    timeout: 240_000,
  }, async () => {
    const { page, problems } = await open(browser, host.page(page24()));
    const elements = page.locator("iframe");
    let most = 0;
    const count = async () => {
      const inView = await elements.evaluateAll((all) => {
        const boxes = all.map((element) => element.getBoundingClientRect());
        return boxes.filter(({ top, bottom }) => bottom > 0 && top < innerHeight).length;
      });
      const { alive } = await contextsOf(page);
      expect(alive).toBeLessThanOrEqual(inView);
      most = Math.max(most, alive);
    };
    const seen = await scrollThrough(page, elements, count);
    const { made } = await contextsOf(page);
    await scrollThrough(page, elements, count);
    expect(seen.size).toBe(24);
    expect((await contextsOf(page)).made, "what was drawn once stays").toBe(made);
    // Browsers keep sixteen.
    expect(most).toBeLessThan(16);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("when all is taken away again", () => {
  it("the nodes, the listeners and the heap return", { timeout: 240_000 }, async () => {
    const { page } = await open(
      browser,
      host.page(`<html lang="en"><title>Empty</title>
      <script src="bough-widget.js" defer></script><main></main></html>`),
    );
    const session = await page.context().newCDPSession(page);
    const round = async () => {
      await page.evaluate(async (ids) => {
        const main = document.querySelector("main");
        const plants = ids.map((id) => {
          const plant = document.createElement("bough-plant") as HTMLElementTagNameMap["bough-plant"];
          plant.preset = id;
          plant.controls = "full";
          return plant;
        });
        main?.append(...plants);
        for (const plant of plants) await plant.toBlob();
        main?.replaceChildren();
      }, choose(6));
      await expect.poll(async () => (await contextsOf(page)).alive).toBe(0);
      // What is about to be collected may still be held by the frame that is going on.
      await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 100)));
    };
    await round();
    const before = await heldBy(session);
    for (let k = 0; k < 2; k++) await round();
    const after = await heldBy(session);
    console.log(`six widgets, three rounds: ${JSON.stringify(before)} → ${JSON.stringify(after)}`);
    // Within what one widget alone would leave behind: some 250 nodes, 60 listeners, and a plant of 1 MB with its mesh.
    expect(after.nodes - before.nodes).toBeLessThan(100);
    expect(after.listeners - before.listeners).toBeLessThan(20);
    expect(after.heap - before.heap).toBeLessThan(1);
    await page.context().close();
  });
});
