/**
 * Key states as pictures. `BOUGH_GOLDEN=update npx vitest run --project browser visual` writes them anew, to be looked at.
 * How they are compared, and what they may differ by: tools/visual/difference.mjs. Every preset is compared in `npm run soak`.
 * Motion is unwelcome in these visits: nothing in them depends on a clock.
 */
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { difference, isSame } from "../../tools/visual/difference.mjs";
import { shrunk } from "../../tools/visual/shrunk.mjs";
import { launchChromium } from "./chromium.ts";
import { settled, visit } from "./visit.ts";

/** How many times smaller. */
const shrink = 4;

/** Hides all that is written over the picture. */
const unwritten =
  ".annotation, .look, .zoom, .legend, .notices { visibility: hidden } *:focus { outline: none !important }";

interface State {
  readonly query?: string;
  readonly options?: BrowserContextOptions;
  /** Done before the picture is taken. */
  act?(page: Page): Promise<void>;
  /** What the picture is of. */
  readonly of?: string;
}

const states: Readonly<Record<string, State>> = {
  "first-view": {},
  gallery: {
    query: "?preset=figure-17c",
    of: "dialog section:nth-of-type(4) .plates",
    async act(page) {
      await page.getByRole("button", { name: "All plates" }).click();
      await page.getByRole("dialog").waitFor();
      // The drawings alone, which are as large on every machine.
      await page.addStyleTag({
        content:
          "dialog section:not(:nth-of-type(4)), dialog h3, .dialog-head, .plate-name, .plate-title { display: none !important; }",
      });
      await page.waitForFunction(() =>
        [...document.querySelectorAll<HTMLImageElement>("dialog section:nth-of-type(4) img")].every(
          ({ complete, naturalWidth }) => complete && naturalWidth > 0,
        ),
      );
    },
  },
  fork: { query: "?preset=figure-18b" },
  model: { query: "?n=10&l=0.12&style=model" },
  moment: { query: "?preset=figure-18b&color=moment" },
  phone: {
    query: "?preset=figure-13c",
    options: { viewport: { width: 390, height: 844 } },
  },
  dark: { query: "?preset=figure-13d&theme=dark" },
  space: { query: "?preset=figure-17d&view=space" },
};

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

it.each(Object.entries(states))(
  "%s looks as it did",
  async (name, { query, options, act, of = ".stage" }) => {
    const viewport = { width: 1000, height: 640 };
    const { page } = await visit(browser, query, {
      bypassCSP: true,
      viewport,
      deviceScaleFactor: 1,
      ...options,
    });
    await page.addStyleTag({ content: unwritten });
    await act?.(page);
    await settled(page);
    const shot = (await page.locator(of).screenshot({ animations: "disabled" })).toString("base64");
    const golden = new URL(`golden/${name}.png`, import.meta.url);
    if (process.env.BOUGH_GOLDEN === "update") {
      const { picture } = await page.evaluate(shrunk, { picture: shot, size: null, by: shrink });
      writeFileSync(golden, Buffer.from(picture, "base64"));
    }
    expect(existsSync(golden), `There is no golden picture of ${name} yet.`).toBe(true);
    const found = await differenceTo(page, golden, shot);
    expect(isSame(found), `most ${found.most}, mean ${found.mean}`).toBe(true);
    await page.context().close();
  },
);

it.each([
  ["a branch that is 4 % heavier", "?g=10.2", ""],
  ["wood of another colour", "?color=age", ""],
  ["a picture that is 2 px lower", "", ".picture { transform: translateY(2px) }"],
])("tells %s from the first view", async (_, query, content) => {
  const viewport = { width: 1000, height: 640 };
  const { page } = await visit(browser, query, { bypassCSP: true, viewport });
  await page.addStyleTag({ content: `${unwritten} ${content}` });
  await settled(page);
  const shot = (await page.locator(".stage").screenshot({ animations: "disabled" })).toString("base64");
  const golden = new URL("golden/first-view.png", import.meta.url);
  expect(isSame(await differenceTo(page, golden, shot))).toBe(false);
  await page.context().close();
});

async function differenceTo(page: Page, golden: URL, shot: string) {
  const kept = readFileSync(golden).toString("base64");
  const before = await page.evaluate(shrunk, { picture: kept, size: null, by: 1 });
  // To the same size: another font may make the timeline a pixel higher, and the picture as much lower.
  const present = await page.evaluate(shrunk, { picture: shot, size: before.size, by: shrink });
  return difference(before.colors, present.colors);
}
