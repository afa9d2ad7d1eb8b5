/** The course as its readers meet it: quick, within reach of everybody, on a phone, offline, and where things are blocked. */
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { AxeResults } from "axe-core";
import type { Browser } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { site } from "../../../tools/paths.mjs";
import { launchChromium } from "../../browser/chromium.ts";
import { figures, pages } from "../text.ts";
import { apartFromPosters, draw, open } from "./reader.ts";

const axePath = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const names = [...pages.keys()];

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

it.each(names)(
  "%s: axe finds nothing, in light and dark, and nothing sticks out on a narrow phone",
  async (name) => {
    const { page, problems } = await open(browser, name);
    await page.addScriptTag({ path: axePath });
    await page.locator("details").evaluateAll((all) => {
      for (const details of all) details.setAttribute("open", "");
    });
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme });
      const found = await page.evaluate(async () => {
        const { axe } = window as unknown as { axe: { run(): Promise<AxeResults> } };
        const { violations } = await axe.run();
        return violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 160)}`));
      });
      expect(found, colorScheme).toEqual([]);
    }
    await page.setViewportSize({ width: 320, height: 640 });
    const wide = await page.evaluate(() =>
      [...document.querySelectorAll("main *, header *, footer *")].flatMap((element) => {
        const { right, width } = element.getBoundingClientRect();
        return width > 1 && right > innerWidth + 1 ? [element.outerHTML.slice(0, 90)] : [];
      }),
    );
    expect(wide).toEqual([]);
    expect(problems).toEqual([]);
    await page.context().close();
  },
);

describe("live figures", () => {
  it("are drawn, each in a time that is printed, and say what is read off them", {
    timeout: 300_000,
  }, async () => {
    const { page, problems } = await open(browser, "index.html");
    // What the page itself takes is over when a reader comes to the first figure.
    await page.waitForLoadState("networkidle");
    const drawn = await draw(page, [...figures.keys()]);
    expect(drawn.map(({ id }) => id)).toEqual([...figures.keys()]);
    // Printed only: on a busy machine a time says nothing of Bough. Asked are 1500 ms on a quiet one.
    const list = drawn.map(
      ({ id, clock, computing }) => `${id} ${Math.round(clock)} (processor ${Math.round(computing)})`,
    );
    console.log(`Figures of the course, ms until drawn: ${list.join(", ")}.`);
    const readings = await page.locator(".reading:visible").allInnerTexts();
    expect(readings).toHaveLength([...figures.values()].filter(({ readings }) => readings).length);
    expect(readings.join()).not.toMatch(/NaN|undefined/);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("are what their posters show until then", { timeout: 300_000 }, async () => {
    const { page } = await open(browser, "index.html");
    const apart = await apartFromPosters(page);
    expect(apart.map(([id]) => id)).toEqual([...figures.keys()]);
    // Nothing, where they were made; elsewhere edges may be smoothed otherwise. They are made anew by npm run figures -- posters.
    expect(apart.filter(([, share]) => !(share < 0.05))).toEqual([]);
    await page.context().close();
  });

  it("follow a slider, and so does the reading", async () => {
    const { page, problems } = await open(browser, "index.html");
    const figure = page.locator(".figure", { has: page.locator("#axis") });
    await figure.scrollIntoViewIfNeeded();
    await figure.getByText("gravity number q = 15").waitFor();
    await figure.getByRole("slider", { name: "Gravity" }).fill("0");
    await figure.getByText("50° above the horizontal; gravity number q = 0").waitFor();
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

it("works offline, opened from a folder", async () => {
  const folder = pathToFileURL(join(site, "/")).href;
  const { page, problems } = await open(browser, "index.html", { offline: true }, folder);
  // What is drawn and what is read off: all others do it the same way.
  await draw(page, ["branch", "axis"]);
  await page.locator(".reading", { hasText: "gravity number" }).first().waitFor({ state: "attached" });
  expect(problems).toEqual([]);
  await page.context().close();
});

describe("where something is blocked", () => {
  it.each([
    ["scripts", { javaScriptEnabled: false }, ""],
    ["WebAssembly", {}, "script-src 'self'"],
  ])("%s: poster, caption and link remain", async (what, options, policy) => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
    const page = await context.newPage();
    if (policy) {
      await page.route(/index\.html$/, async (route) => {
        const response = await route.fetch();
        await route.fulfill({
          response,
          headers: { ...response.headers(), "content-security-policy": policy },
        });
      });
    }
    const { page: other } = await open(browser, "index.html");
    const address = other.url();
    await other.context().close();
    await page.goto(address);
    const figure = page.locator(".figure").first();
    await figure.scrollIntoViewIfNeeded();
    if (policy) await figure.getByText("Content-Security-Policy forbids it").waitFor();
    const poster = figure.locator("img[slot=poster]");
    await expect.poll(() => poster.isVisible()).toBe(true);
    if (!what.startsWith("scripts"))
      expect(await poster.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(100);
    expect(await figure.getByText("A branch under two influences").isVisible()).toBe(true);
    expect(await figure.getByRole("link", { name: "Open it in Bough" }).isVisible()).toBe(true);
    await context.close();
  });
});
