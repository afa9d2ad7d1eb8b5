/** Every state in which a person can see the page, one after another, in a language: what is looked at in each is the caller's. */
import type { Browser, BrowserContextOptions, Locator, Page } from "playwright";
import { inject } from "vitest";
import { chinese } from "../../web/src/language/chinese.ts";
import type { Text } from "../../web/src/language/english.ts";
import { french } from "../../web/src/language/french.ts";
import { german } from "../../web/src/language/german.ts";
import { spanish } from "../../web/src/language/spanish.ts";
import { dropFile, settled, visit } from "./visit.ts";

const dictionaries = { en: null, de: german, fr: french, es: spanish, zh: chinese } as const;
export type Tag = keyof typeof dictionaries;
export const tags = Object.keys(dictionaries) as readonly Tag[];

export const dialogs = ["Keys", "All plates", "Take it away", "Embed"] as const;

/** What the page says for an English text. */
export function said(tag: Tag, text: Text): string {
  return dictionaries[tag]?.texts[text] ?? text;
}

/** Opens a dialog by the button of its English name. */
export async function openDialog(page: Page, tag: Tag, name: (typeof dialogs)[number]): Promise<Locator> {
  await page.getByRole("button", { name: said(tag, name), exact: true }).click();
  const dialog = page.getByRole("dialog", { name: said(tag, name) });
  await dialog.waitFor();
  return dialog;
}

/** Opens all that can be opened: the study, too, which comes after the plant. */
export async function openAll(page: Page): Promise<void> {
  await page.locator("details.measure").waitFor();
  // One after another: what opens may hold others.
  const closed = page.locator("details:not([open]) > summary");
  while ((await closed.count()) > 0) await closed.first().click();
}

/** Opens everything, and enters what is refused. */
export async function openAndSpoil(page: Page): Promise<void> {
  await openAll(page);
  await page.locator("button.explain").first().click();
  await page.locator(".help math").first().waitFor();
  await page.locator("#loads-gravity").fill("?");
  await page.locator("#loads-gravity").press("Enter");
  await page.getByRole("alert").waitFor();
  await settled(page);
}

/** Brings the page into one state after another, and has each looked at; how many there were. */
export async function everySight(
  browser: Browser,
  tag: Tag,
  options: BrowserContextOptions,
  look: (page: Page, sight: string) => Promise<void>,
): Promise<number> {
  let count = 0;
  const see = async (page: Page, sight: string) => {
    count++;
    await look(page, sight);
  };
  await inPlane(browser, tag, options, see);
  const { page: space } = await visit(
    browser,
    `?preset=figure-17d&view=space&style=model&color=age&lang=${tag}`,
    options,
  );
  await openAll(space);
  await see(space, "in space, as a model, by age");
  await space.context().close();
  await broken(browser, tag, options, see);
  return count;
}

async function inPlane(
  browser: Browser,
  tag: Tag,
  options: BrowserContextOptions,
  see: (page: Page, sight: string) => Promise<void>,
): Promise<void> {
  // Its link has a word that means nothing: that is said.
  const { page } = await visit(browser, `?preset=figure-8b&zz=1&lang=${tag}`, options);
  await see(page, "at first sight");
  await openAndSpoil(page);
  await see(page, "everything open, something wrong");
  await page.locator("#loads-gravity").press("Escape");
  await page.locator("label.color select").selectOption("stress");
  await page.getByRole("button", { name: said(tag, "Pin this plant as A") }).click();
  // By key: a phone has no button for it.
  await page.locator("canvas.picture").press("Enter");
  await page.locator(".pull data").waitFor({ state: "attached" });
  await settled(page);
  await see(page, "coloured, held, compared with a pinned one");
  await page.keyboard.press("Escape");
  for (const name of dialogs) {
    await openDialog(page, tag, name);
    await see(page, `with the dialog “${name}”`);
    await page.keyboard.press("Escape");
  }
  await dropFile(page, "notes.txt", "text/plain", "hello");
  await page.getByText("notes.txt").waitFor();
  await see(page, "a file refused");
  await page.locator("#axis-segments").fill("30000");
  await page.locator("#axis-segments").press("Enter");
  await page.getByRole("progressbar").waitFor();
  await see(page, "growing for long");
  await page.context().close();
}

/** Without pictures, and without what computes. */
async function broken(
  browser: Browser,
  tag: Tag,
  options: BrowserContextOptions,
  see: (page: Page, sight: string) => Promise<void>,
): Promise<void> {
  for (const sight of ["without WebGL", "without the core"]) {
    const context = await browser.newContext({
      reducedMotion: "reduce",
      serviceWorkers: "block",
      ...options,
    });
    if (sight === "without WebGL")
      await context.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
      });
    else await context.route("**/*.wasm", (route) => route.abort());
    const page = await context.newPage();
    await page.goto(new URL(`?lang=${tag}`, inject("site")).href);
    await page.locator(".notice").first().waitFor();
    await see(page, sight);
    await context.close();
  }
}
