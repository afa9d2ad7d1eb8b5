/** The page anywhere: installed, without a network, from a file; and never a request to anybody else. */
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { buildSingle } from "../../tools/build-single.mjs";
import { launchChromium } from "./chromium.ts";
import { query, readTip, settled, slider, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** The whole page is gone through, with pictures that the CPU computes. ms */
const patience = 180_000;

/** Uses everything that loads late: each dialog, a help, a language, a body to take away, a point to pull at, the study. */
async function useEverything(page: Page): Promise<void> {
  await page.getByRole("button", { name: "About Elevation" }).click();
  await page.locator("#axis-elevation-help math").waitFor();
  for (const name of ["Keys", "All plates", "Embed", "Take it away"]) {
    // A page that is a file cannot be put into another one.
    if (name === "Embed" && page.url().startsWith("file:")) continue;
    await page.getByRole("button", { name, exact: true }).click();
    await page.getByRole("dialog", { name }).waitFor();
    if (name === "Take it away") {
      const [file] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name: "Save GLB" }).click(),
      ]);
      expect(file.suggestedFilename()).toMatch(/\.glb$/);
    }
    await page.keyboard.press("Escape");
  }
  await page.getByRole("button", { name: "Take hold of the tip" }).click();
  await page.locator(".pull data").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("details.why > summary").click();
  await page.locator(".bars li").first().waitFor();
  await page.locator("details.why > summary").click();
  for (const [lang, name] of [
    ["de", "Wachsen sehen"],
    ["zh", "观看生长"],
    ["fr", "La voir pousser"],
    ["es", "Ver crecer"],
    ["en", "Watch it grow"],
  ] as const) {
    await page.locator(".tongues select").selectOption(lang);
    await page.getByRole("button", { name, exact: true }).waitFor();
  }
  await settled(page);
}

/** Waits until the browser keeps the page. */
async function kept(page: Page): Promise<void> {
  await page.waitForFunction(async () => (await navigator.serviceWorker.ready).active?.state === "activated");
}

describe("on a server", () => {
  it(
    "everything can be used without a request to anybody else",
    async () => {
      const { page, problems } = await visit(browser, "?preset=figure-13c&color=stress");
      const asked: string[] = [];
      page.context().on("request", (request) => asked.push(request.url()));
      await useEverything(page);
      await page.goto(new URL("embed.html?preset=figure-8a", inject("site")).href);
      await page.locator("bough-plant").waitFor();
      const elsewhere = asked.filter((url) => {
        const { origin, protocol } = new URL(url);
        return origin !== new URL(inject("site")).origin && !["data:", "blob:"].includes(protocol);
      });
      expect(asked.length).toBeGreaterThan(10);
      expect(elsewhere).toEqual([]);
      expect(problems).toEqual([]);
      await page.context().close();
    },
    patience,
  );

  it("can be installed", async () => {
    const { page } = await visit(browser, "", { serviceWorkers: "allow" });
    const devtools = await page.context().newCDPSession(page);
    const { errors, data } = await devtools.send("Page.getAppManifest");
    expect(errors).toEqual([]);
    expect(JSON.parse(data ?? "{}")).toMatchObject({ name: /^Bough/, display: "standalone" });
    const { installabilityErrors } = await devtools.send("Page.getInstallabilityErrors");
    // A context of the tests is a private window, in which nothing is installed.
    const found = installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== "in-incognito");
    expect(found).toEqual([]);
    await page.context().close();
  });

  it("clears away what an older version kept, and nothing of the docs, which are of the same origin", async () => {
    const context = await browser.newContext({ serviceWorkers: "allow", reducedMotion: "reduce" });
    const page = await context.newPage();
    await page.goto(new URL("embed.html", inject("site")).href);
    const names = () => page.evaluate(async () => (await caches.keys()).sort());
    await page.evaluate(() => Promise.all(["bough-docs-1", "bough-page-1"].map((name) => caches.open(name))));
    await page.goto(inject("site"));
    await settled(page);
    await kept(page);
    expect(await names()).toEqual(["bough-docs-1", expect.stringMatching(/^bough-page-[0-9a-f]{16}$/)]);
    await context.close();
  });

  it(
    "works without a network after the first visit: every plate, language and part",
    async () => {
      const { page, problems } = await visit(browser, "", { serviceWorkers: "allow" });
      await kept(page);
      await page.context().setOffline(true);
      await page.goto(new URL("?preset=figure-17c&g=3", inject("site")).href);
      await settled(page);
      expect(await readTip(page)).toContain("across");
      await useEverything(page);
      await page.getByRole("button", { name: /^Figure 8 d/ }).click();
      await settled(page);
      const missing = await page.evaluate(
        () =>
          [...document.images].filter(({ complete, naturalWidth }) => complete && naturalWidth === 0).length,
      );
      expect(missing).toBe(0);
      expect(problems).toEqual([]);
      await page.context().close();
    },
    patience,
  );
});

describe("as a single file", () => {
  const folder = mkdtempSync(join(tmpdir(), "bough-single-"));
  let file = "";
  beforeAll(async () => {
    file = await buildSingle(folder);
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  it("its policy allows the one script and the one style it has, and no address", () => {
    const html = readFileSync(file, "utf8");
    expect(html).toMatch(
      /script-src 'sha256-[\w+/=]+' 'wasm-unsafe-eval'; style-src 'sha256-[\w+/=]+'; img-src data: blob:;/,
    );
    expect(html).not.toMatch(/<(script|link|img)[^>]*(src|href)="(?!data:)/);
  });

  it(
    "works from a double click: everything in it, nothing asked for",
    async () => {
      const context = await browser.newContext({
        reducedMotion: "reduce",
        viewport: { width: 1280, height: 800 },
      });
      const page = await context.newPage();
      const asked: string[] = [];
      const said: string[] = [];
      page.on("request", (request) => asked.push(request.url()));
      page.on("console", (message) => said.push(message.text()));
      page.on("pageerror", (error) => said.push(String(error)));
      const address = pathToFileURL(file).href;
      await page.goto(`${address}?preset=figure-13c`);
      await settled(page);
      expect(await readTip(page)).toContain("across");
      await useEverything(page);
      await slider(page, "Gravity, slider").focus();
      await page.keyboard.press("ArrowRight");
      await settled(page);
      expect(query(page).has("g")).toBe(true);
      await page.getByRole("button", { name: "Undo" }).click();
      await page.waitForFunction(() => !new URLSearchParams(location.search).has("g"));
      expect(asked.filter((url) => !url.startsWith(address) && !/^(data|blob):/.test(url))).toEqual([]);
      expect(said).toEqual([]);
      await context.close();
    },
    patience,
  );
});
