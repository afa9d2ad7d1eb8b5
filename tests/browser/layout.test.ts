/** From a narrow phone to a projector: the plant fills the view, nothing is cut off, nothing covers the plant. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init, presets } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { placeOf, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

const sizes = [
  [320, 640],
  [390, 844],
  [768, 1024],
  [844, 390],
  [1280, 800],
  [2560, 1440],
] as const;

/** Where the points of the plant are drawn, in px of the page. */
async function places(page: Page, id: string) {
  const { points } = grow(presets[id]?.params ?? {}).polylines;
  const chosen = Array.from({ length: points.length / 3 }, (_, i) => [...points.subarray(3 * i, 3 * i + 3)]);
  return Promise.all(chosen.filter((_, i) => i % 4 === 0).map((point) => placeOf(page, point)));
}

describe.each(sizes)("at %d x %d", (width, height) => {
  it("no control is cut off, and the legend does not cover the plant", async () => {
    const { page, problems } = await visitUnpainted(browser, "?preset=figure-18b&color=stress", {
      viewport: { width, height },
    });
    const cut = await page.evaluate(() =>
      [
        ...document.querySelectorAll("header button, .view button, .view select, .view input, .plate-head *"),
      ].flatMap((control) => {
        const { left, right, width, height } = control.getBoundingClientRect();
        const isSeen = width > 1 && height > 1;
        return isSeen && (left < -0.5 || right > innerWidth + 0.5) ? [control.outerHTML.slice(0, 90)] : [];
      }),
    );
    expect(cut).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(
      0,
    );
    const legend = await page.locator(".legend").boundingBox();
    if (!legend) throw new Error("There is no legend.");
    const covered = (await places(page, "figure-18b")).filter(
      ({ x, y }) =>
        x > legend.x && x < legend.x + legend.width && y > legend.y && y < legend.y + legend.height,
    );
    expect(covered).toEqual([]);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("the whole plant is in the picture, and fills it", async () => {
    const { page } = await visitUnpainted(browser, "?preset=figure-13c", { viewport: { width, height } });
    const canvas = await page.locator("canvas.picture").boundingBox();
    if (!canvas) throw new Error("There is no picture.");
    const drawn = await places(page, "figure-13c");
    const [xs, ys] = [drawn.map(({ x }) => x), drawn.map(({ y }) => y)];
    expect(Math.min(...xs)).toBeGreaterThan(canvas.x);
    expect(Math.max(...xs)).toBeLessThan(canvas.x + canvas.width);
    expect(Math.min(...ys)).toBeGreaterThan(canvas.y);
    expect(Math.max(...ys)).toBeLessThan(canvas.y + canvas.height);
    // With its stand and the margins for what is written, half of one side is the plant.
    const across = (Math.max(...xs) - Math.min(...xs)) / canvas.width;
    const base = await placeOf(page, [0, 0, 0]);
    const up = (canvas.y + 0.85 * canvas.height - Math.min(...ys, base.y)) / canvas.height;
    expect(Math.max(across, up)).toBeGreaterThan(0.5);
    await page.context().close();
  });
});

it.each([
  ["en", 1280, 800],
  ["fr", 700, 420],
  ["de", 320, 640],
] as const)(
  "every box and slider of the form has room, where values were changed too: %s, %d x %d",
  async (lang, width, height) => {
    const changed = "?ta=0&rc=0.1&l=0.03&sn=1&tm=0.01";
    const { page } = await visitUnpainted(browser, `${changed}&lang=${lang}`, {
      viewport: { width, height },
    });
    expect(await page.locator(".changed").count()).toBeGreaterThanOrEqual(3);
    const entries = await page.locator(".fields .entry").evaluateAll((all) => {
      for (const group of document.querySelectorAll<HTMLDetailsElement>("details.group")) group.open = true;
      return all.map((entry) => {
        const { left, right } = entry.getBoundingClientRect();
        const parts = [...entry.children].map((part) => part.getBoundingClientRect());
        return {
          name: entry.parentElement?.querySelector(".label")?.textContent,
          // No part is as narrow as that: a box to tick has 16 px.
          narrow: parts.some((part) => part.width < 13),
          typed: [...entry.querySelectorAll("input[type=text]")].map((box) => box.clientWidth),
          sticksOut: parts.some((part) => part.left < left - 1 || part.right > right + 1),
        };
      });
    });
    expect(entries.length).toBeGreaterThan(30);
    for (const { name, narrow, typed, sticksOut } of entries) {
      expect(narrow, `${name} is narrow`).toBe(false);
      expect(sticksOut, `${name} sticks out`).toBe(false);
      // Three digits have 24 px.
      for (const room of typed) expect(room, `${name} has a box of ${room} px`).toBeGreaterThan(24);
    }
    await page.context().close();
  },
);

it("the scale bar is as long as it says", async () => {
  const { page } = await visitUnpainted(browser);
  const bar = await page
    .locator(".annotation .scale-bar")
    .evaluate((path) => (path as SVGPathElement).getBBox().width);
  const text = (await page.locator(".annotation .length").textContent()) ?? "";
  const [, number = "", unit = ""] = /^(\d+) (cm|m|mm)/.exec(text) ?? [];
  const length = Number(number) * ({ mm: 1e-3, cm: 1e-2, m: 1 }[unit] ?? Number.NaN);
  const [base, metre] = [await placeOf(page, [0, 0, 0]), await placeOf(page, [1, 0, 0])];
  expect(bar / (metre.x - base.x)).toBeCloseTo(length, 2);
  await page.context().close();
});

it.each([
  ["", "50°"],
  ["?preset=figure-20a", "10°"],
  ["?preset=figure-13d&view=space", "45°"],
  ["?preset=figure-18a", "−60°"],
])("the angle of elevation is written beside the drawing, not on it: %s", async (query, text) => {
  const { page } = await visitUnpainted(browser, query);
  const label = page.locator(".annotation .angle");
  expect(await label.textContent()).toBe(text);
  const at = await label.boundingBox();
  if (!at) throw new Error("The label is not to be seen.");
  const id = new URLSearchParams(query).get("preset") ?? "";
  const touched = (await places(page, id)).filter(
    ({ x, y }) => x > at.x && x < at.x + at.width && y > at.y && y < at.y + at.height,
  );
  expect(touched).toEqual([]);
  await page.context().close();
});
