/** Thirty widgets, and two dozen frames, put up, looked at and taken away again, five times over. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launchChromium } from "../browser/chromium.ts";
import { heldBy, scrollThrough, thirty, twoDozen } from "./crowd.ts";
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

const rounds = 5;

it.each([
  ["thirty widgets", "bough-plant", () => thirty, 1],
  // Of 320 px in height, in two columns, no more than these are in view.
  ["two dozen frames", "iframe", () => twoDozen(frames.address), 8],
])("%s", async (name, selector, content, most) => {
  const { page, problems } = await open(
    browser,
    host.page(`<html lang="en"><title>Rounds</title><script src="bough-widget.js" defer></script><style>
      main { display: grid; grid-template-columns: repeat(${selector === "iframe" ? 2 : 3}, 1fr); gap: 1rem; }
    </style><main></main></html>`),
  );
  const session = await page.context().newCDPSession(page);
  const held: Awaited<ReturnType<typeof heldBy>>[] = [];
  let alive = 0;
  for (let round = 0; round <= rounds; round++) {
    await page.evaluate((html) => {
      const main = document.querySelector("main");
      if (main) main.innerHTML = html;
    }, content());
    for (let time = 0; time < 2; time++) {
      await scrollThrough(page, page.locator(selector), async () => {
        const now = await contextsOf(page);
        alive = Math.max(alive, now.alive);
      });
    }
    await page.evaluate(() => document.querySelector("main")?.replaceChildren());
    await expect.poll(async () => (await contextsOf(page)).alive).toBe(0);
    held.push(await heldBy(session));
  }
  const shown = held.map(
    ({ nodes, listeners, heap }) => `${nodes} nodes, ${listeners} listeners, ${heap.toFixed(2)} MB`,
  );
  console.log([`${name}, at most ${alive} contexts at once; after each round:`, ...shown].join("\n  "));
  expect(alive).toBeLessThanOrEqual(most);
  const [first, last] = [held[0], held.at(-1)];
  if (!first || !last) throw new Error("There was no round.");
  // The first round loads the code and fills what is kept; five more must leave less than one widget would. What little is
  // added is the browser's: code that it compiles, and timings that it notes.
  expect(last.nodes - first.nodes).toBeLessThan(100);
  expect(last.listeners - first.listeners).toBeLessThan(20);
  expect(last.heap - first.heap).toBeLessThan(1);
  expect(problems).toEqual([]);
  await page.context().close();
});
