/** When something breaks: a sentence, the last good picture, and the state is kept. */
import type { Browser, BrowserContext, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { box, query, readTip, settled, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** A page that is prepared before it is opened. */
async function opened(link: string, prepare: (context: BrowserContext) => Promise<unknown>): Promise<Page> {
  const context = await browser.newContext({ reducedMotion: "reduce", serviceWorkers: "block" });
  await prepare(context);
  const page = await context.newPage();
  await page.goto(new URL(link, inject("site")).href);
  return page;
}

/** The picture as the canvas holds it. */
const picture = (page: Page) =>
  page.locator("canvas.picture").evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

describe("a worker that dies", () => {
  /** What is thrown outside of all that catches it ends a worker's work. */
  const crash = (page: Page) =>
    page.workers()[0]?.evaluate(() => {
      setTimeout(() => {
        throw new Error("crash");
      });
    });

  it("in the midst of the work is started again, with what was wanted; the picture stays until then", async () => {
    const { page } = await visit(browser, "?preset=figure-8d");
    const before = await picture(page);
    await box(page, /^Segments/).fill("30000");
    await box(page, /^Segments/).press("Enter");
    await page.getByRole("progressbar", { name: "Growing" }).waitFor();
    expect(await picture(page)).toBe(before);
    await crash(page);
    await page.getByText("The computation broke off, and was begun again.").waitFor();
    expect(query(page).get("n")).toBe("30000");
    expect(await picture(page)).toBe(before);
    // The new worker goes on; it can be cancelled as ever.
    await page.getByRole("progressbar", { name: "Growing" }).waitFor();
    await page.getByRole("button", { name: "Cancel" }).click();
    await settled(page);
    expect(await readTip(page)).toContain("across");
    await page.context().close();
  });

  it("twice over the same plant is said, and the next plant is computed all the same", async () => {
    const { page } = await visit(browser, "?preset=figure-8d&lang=de");
    await page.locator("#axis-segments").fill("30000");
    await page.locator("#axis-segments").press("Enter");
    await page.getByRole("progressbar").waitFor();
    const first = page.workers()[0];
    await crash(page);
    await page.getByText("Die Berechnung brach ab und wurde neu begonnen.").waitFor();
    await expect.poll(() => page.workers().length === 1 && page.workers()[0] !== first).toBe(true);
    await crash(page);
    await page
      .getByText("Die Pflanze konnte nicht berechnet werden. Der rechnende Worker ist ausgefallen.")
      .waitFor();
    await page.locator("#axis-segments").fill("20");
    await page.locator("#axis-segments").press("Enter");
    await settled(page);
    expect(await page.locator(".readout dd").first().innerText()).toBe("75 cm");
    await page.context().close();
  });

  it("while nothing is wanted goes unnoticed", async () => {
    const { page } = await visit(browser);
    await crash(page);
    await box(page, /^Segments/).fill("20");
    await box(page, /^Segments/).press("Enter");
    await settled(page);
    expect(await page.locator(".readout dd").first().innerText()).toBe("75 cm");
    expect(await page.locator(".notice").count()).toBe(0);
    await page.context().close();
  });
});

describe("WebAssembly that is forbidden", () => {
  /** Opens the page with another script of the worker, or under another policy for it. */
  const openedWith = (
    link: string,
    change: (script: string) => { body: string; headers?: Record<string, string> },
  ) =>
    opened(link, (context) =>
      context.route("**/worker-*.js", async (route) => {
        const response = await route.fetch();
        const { body, headers } = change(await response.text());
        await route.fulfill({ contentType: "text/javascript", body, headers: headers ?? {} });
      }),
    );

  it("by a policy is said, with what would allow it", async () => {
    const page = await openedWith("?preset=figure-13c", (body) => ({
      body,
      headers: { "content-security-policy": "script-src 'self'" },
    }));
    await page.getByText("its script-src needs 'wasm-unsafe-eval'").waitFor();
    expect(query(page).get("preset")).toBe("figure-13c");
    await page.context().close();
  });

  it("by the browser is said in a sentence; the form stays, and so does the link", async () => {
    // As browsers in their lockdown mode: there is none at all.
    const page = await openedWith("?preset=figure-13c&g=3", (body) => ({
      body: `Reflect.deleteProperty(self, "WebAssembly");${body}`,
    }));
    await page.getByText("This browser has no WebAssembly").waitFor();
    expect(await box(page, /^Gravity/).inputValue()).toBe("3");
    expect(query(page).get("g")).toBe("3");
    await page.context().close();
  });
});
