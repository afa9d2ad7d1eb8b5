/** The outline of a pinned plant, where it is far larger than what is looked at. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { settled, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** How far lines go on beyond the picture. px */
const beyond = 60;

describe("a large plant that is pinned beside a small one", () => {
  it("is drawn as far as it is seen: its dashes beyond took the browser many seconds a picture", async () => {
    const pin = encodeURIComponent("v=1&preset=weeping-willow&view=space");
    const { page, problems } = await visit(browser, `?preset=figure-2a&view=space&pin=${pin}`, {
      viewport: { width: 700, height: 420 },
    });
    const ghosts = page.locator(".overlay .ghost");
    await ghosts.first().waitFor({ state: "attached" });
    await settled(page);
    const box = await page.locator("canvas.picture").boundingBox();
    const lines = await ghosts.evaluateAll((all) => all.map((one) => one.getAttribute("d") ?? ""));
    const places = lines.flatMap((line) =>
      [...line.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)] as const),
    );
    expect(places.length).toBeGreaterThan(1);
    for (const [x, y] of places) {
      expect(x).toBeGreaterThan(-beyond);
      expect(x).toBeLessThan((box?.width ?? 0) + beyond);
      expect(y).toBeGreaterThan(-beyond);
      expect(y).toBeLessThan((box?.height ?? 0) + beyond);
    }
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
