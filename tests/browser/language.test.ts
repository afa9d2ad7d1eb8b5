/** The page in each of its languages. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { violations } from "./axe.ts";
import { launchChromium } from "./chromium.ts";
import { cutTexts } from "./cut.ts";
import { dialogs, openAll, openAndSpoil, openDialog } from "./sights.ts";
import { query, settled, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

describe("a language", () => {
  it("is chosen from the menu, said by the link, and undone like anything else", async () => {
    const { page, problems } = await visitUnpainted(browser, "?preset=figure-13c");
    const loaded: string[] = [];
    page.on("request", (request) => loaded.push(request.url()));
    expect(await page.evaluate(() => document.documentElement.lang)).toBe("en");
    expect(
      await page.evaluate(() =>
        performance
          .getEntriesByType("resource")
          .map(({ name }) => name)
          .join(),
      ),
    ).not.toMatch(/german|french|spanish|chinese/);
    await page.getByRole("combobox", { name: "Language" }).selectOption("de");
    await page.getByRole("heading", { name: "Ein Tropismus gegen die Schwerkraft, ausgewachsen" }).waitFor();
    expect(loaded.filter((url) => /german/.test(url))).toHaveLength(1);
    expect(loaded.filter((url) => /french|spanish|chinese/.test(url))).toEqual([]);
    expect(await page.evaluate(() => [document.documentElement.lang, document.title])).toEqual([
      "de",
      "Bough: wie sich Äste beim Wachsen biegen",
    ]);
    expect(query(page).get("lang")).toBe("de");
    expect(await page.getByRole("textbox", { name: /^Schwerkraft/ }).inputValue()).toBe("9,81");
    await page.getByRole("textbox", { name: /^Schwerkraft/ }).fill("1,62");
    await page.getByRole("textbox", { name: /^Schwerkraft/ }).press("Enter");
    await settled(page);
    expect(query(page).get("g")).toBe("1.62");
    await page.getByRole("textbox", { name: /^Schwerkraft/ }).fill("viel");
    await page.getByRole("textbox", { name: /^Schwerkraft/ }).press("Enter");
    expect(await page.getByRole("alert").innerText()).toBe(
      "Schwerkraft: nötig ist eine Zahl von 0 bis 1e6 m/s², angegeben ist der Text „viel“.",
    );
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Rückgängig" }).click();
    await page.getByRole("button", { name: "Rückgängig" }).click();
    await page.getByRole("heading", { name: "A tropism against gravity, full grown" }).waitFor();
    expect(await page.evaluate(() => document.documentElement.lang)).toBe("en");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("is the reader's own where the link says none; what is no language is said", async () => {
    const { page, problems } = await visitUnpainted(browser, "", { locale: "fr-CA" });
    expect(await page.evaluate(() => document.documentElement.lang)).toBe("fr");
    await page.getByRole("button", { name: "La voir pousser" }).waitFor();
    expect(problems).toEqual([]);
    await page.context().close();
    const strange = await visitUnpainted(browser, "?lang=tlh");
    await strange.page.getByText('lang is "tlh" in the link; it must be one of auto, en, de').waitFor();
    await strange.page.context().close();
  });

  it("that cannot be loaded is said in English, and the page stays", async () => {
    const context = await browser.newContext({ reducedMotion: "reduce" });
    const page = await context.newPage();
    await page.route("**/german-*.js", (route) => route.abort());
    const { page: other } = await visitUnpainted(browser);
    await page.goto(`${other.url().split("?")[0]}?lang=de`);
    await page.getByText("A part of the page could not be loaded").waitFor();
    await settled(page);
    expect(await page.getByRole("button", { name: "Watch it grow" }).count()).toBe(1);
    await context.close();
    await other.context().close();
  });
});

/** A sample; `npm run soak -- --only languages` looks at every state in each language. */
describe.each([
  ["de", "dark", 390, 844, "?preset=figure-17c&color=stress", "Take it away"],
  ["zh", "light", 1280, 800, "?preset=figure-13d&view=space&color=age", "All plates"],
] as const)("in %s", (lang, colorScheme, width, height, link, dialog) => {
  it("axe finds nothing, with everything open and something wrong, and in a dialog", async () => {
    const options = { viewport: { width, height }, colorScheme, bypassCSP: true };
    const { page } = await visitUnpainted(browser, `${link}&lang=${lang}`, options);
    await openAndSpoil(page);
    expect(await violations(page)).toEqual([]);
    await openDialog(page, lang, dialog);
    expect(await violations(page)).toEqual([]);
    await page.context().close();
  });
});

it.each([
  ["320 px wide in German", "de", { viewport: { width: 320, height: 640 } }],
  ["320 px wide in French", "fr", { viewport: { width: 320, height: 640 } }],
  ["at 200 % zoom in Spanish", "es", { viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 }],
] as const)("no text is cut off %s", async (_, lang, options) => {
  const { page } = await visitUnpainted(browser, `?preset=figure-17d&color=stress&lang=${lang}`, options);
  await openAll(page);
  expect(await page.evaluate(cutTexts)).toEqual([]);
  for (const name of dialogs) {
    await openDialog(page, lang, name);
    expect(await page.evaluate(cutTexts), name).toEqual([]);
    await page.keyboard.press("Escape");
  }
  await page.context().close();
});
