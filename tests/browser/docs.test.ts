/** The docs site: no violation of accessibility, search, and reading without a network. */
import { readdirSync } from "node:fs";
import { join } from "node:path";
import axe, { type AxeResults } from "axe-core";
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, test } from "vitest";
import { site } from "../../tools/paths.mjs";
import { launchChromium } from "./chromium.ts";
import { listen } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

const pages = readdirSync(join(site, "docs")).filter((file) => file.endsWith(".html"));
const phone = { viewport: { width: 320, height: 640 } };

async function open(file: string, options: BrowserContextOptions = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    serviceWorkers: "block",
    ...options,
  });
  const page = await context.newPage();
  const problems = listen(page);
  await page.goto(new URL(`docs/${file}`, inject("site")).href);
  // What the tests themselves cause: no service worker, and an icon that is left behind when they go on at once.
  const caused = /blocked by Playwright|^failed: .*favicon\.svg$/;
  return { page, problems: () => problems.filter((problem) => !caused.test(problem)) };
}

async function violations(page: Page): Promise<string[]> {
  await page.evaluate(axe.source);
  const { violations: found } = (await page.evaluate("axe.run()")) as AxeResults;
  return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`);
}

describe.each([
  ["light, and wide", { colorScheme: "light" }],
  ["dark, on a phone", { ...phone, colorScheme: "dark" }],
] as const)("%s", (_, options) => {
  test("no page has a violation, a problem, or more width than the screen", async () => {
    expect(pages.length).toBeGreaterThan(12);
    const { page, problems } = await open("index.html", { ...options });
    for (const file of [...pages, "files/docs/evidence.html", "files/CITATION.cff.html"]) {
      await page.goto(new URL(`docs/${file}`, inject("site")).href);
      expect(await violations(page), file).toEqual([]);
      const [needed, there] = await page.evaluate(() => {
        const { scrollWidth, clientWidth } = document.documentElement;
        return [scrollWidth, clientWidth] as const;
      });
      expect(needed, file).toBeLessThanOrEqual(there);
    }
    expect(problems()).toEqual([]);
    await page.context().close();
  });
});

describe("search", () => {
  test("finds a parameter by its name, and goes there by the keyboard alone", async () => {
    const { page, problems } = await open("index.html");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Tab");
    await page.keyboard.type("neighbours wind sway");
    await page.locator(".count", { hasText: "Nothing has" }).waitFor();
    await page.getByRole("searchbox", { name: "Search" }).fill("plastochron");
    await page.locator(".count", { hasText: /\d+ place/ }).waitFor();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press("Enter");
    await page.waitForURL(/parameters\.html#arrangement$/);
    expect(problems()).toEqual([]);
    await page.context().close();
  });

  test("is put away by Escape", async () => {
    const { page } = await open("api.html");
    const box = page.getByRole("searchbox", { name: "Search" });
    await box.fill("pool");
    await page.locator(".found a").first().waitFor();
    await page.keyboard.press("Escape");
    expect(await page.locator(".found").isVisible()).toBe(false);
    expect(await box.inputValue()).toBe("");
    await page.context().close();
  });
});

test("once visited, every page and the search are there without a network", async () => {
  const { page } = await open("index.html", { serviceWorkers: "allow" });
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await page.context().setOffline(true);
  for (const file of pages) {
    await page.goto(new URL(`docs/${file}`, inject("site")).href);
    expect(await page.locator("main h1").count(), file).toBeGreaterThan(0);
  }
  await page.getByRole("searchbox", { name: "Search" }).fill("gravity");
  await page.locator(".found a").first().waitFor();
  await page.context().close();
});

test("the docs and the page lead to each other", async () => {
  const { page } = await open("index.html");
  await page.getByRole("link", { name: "Grow a branch" }).click();
  await page.locator("canvas.picture").waitFor();
  await page.context().close();
});
