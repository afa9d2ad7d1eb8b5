/** How the plant is looked at, and what opens over the page. */

import { readFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { site } from "../../tools/paths.mjs";
import { launchChromium } from "./chromium.ts";
import { Pixels } from "./pixels.ts";
import { box, placeOf, query, readTip, settled, slider, type, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

const color = (page: Page) => page.getByRole("combobox", { name: "Colour" });

describe("colour", () => {
  it("by moment is blue at the clamped base and pale at the tip, with a legend in real units, and in the link", async () => {
    const { page, problems } = await visit(browser);
    await color(page).selectOption("moment");
    await settled(page);
    expect(query(page).get("color")).toBe("moment");
    const legend = page.locator(".legend");
    expect(await legend.innerText()).toMatch(/Bending moment m?N m/);
    const scale = await legend.getByRole("img").getAttribute("aria-label");
    expect(scale).toMatch(/^Colour scale from −\d+(\.\d+)? to \d+(\.\d+)? m?N m$/);
    const picture = await Pixels.of(page);
    const at = async (point: number[]) => {
      const { x, y } = await placeOf(page, point);
      return picture.at(x, y);
    };
    const [red, , blue] = await at([0.06, 0.068, 0]);
    expect(blue - red).toBeGreaterThan(60);
    const tip = await at([1.4, 0.338, 0]);
    expect(Math.max(...tip) - Math.min(...tip)).toBeLessThan(40);
    await page.goBack();
    await page.waitForFunction(() => !location.search.includes("color"));
    expect(await legend.count()).toBe(0);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("by stress, curvature and age has its legend; the key C goes round", async () => {
    const { page } = await visit(browser, "?color=stress");
    await page.locator("#controls").focus();
    for (const words of [/Largest stress [kM]?Pa/, /Curvature 1\/m/, /Age of the wood steps/]) {
      expect(await page.locator(".legend").innerText()).toMatch(words);
      await page.keyboard.press("c");
      await settled(page);
    }
    expect(await page.locator(".legend").count()).toBe(0);
    expect(query(page).has("color")).toBe(false);
    await page.context().close();
  });
});

it("the model style draws rods instead of limbs, and is in the link", async () => {
  const { page, problems } = await visit(browser, "?n=8&l=0.1");
  const before = await Pixels.of(page);
  await page.getByRole("radio", { name: "Model" }).check({ force: true });
  await settled(page);
  expect(query(page).get("style")).toBe("model");
  const panel = await page.locator("#controls").boundingBox();
  expect((await Pixels.of(page)).difference(before, panel?.x ?? 0)).toBeGreaterThan(60);
  await page.locator("#controls").focus();
  await page.keyboard.press("m");
  await settled(page);
  expect(query(page).has("style")).toBe(false);
  expect(problems).toEqual([]);
  await page.context().close();
});

describe("the gallery of all plates", () => {
  it("opens by key, shows the drawing of every preset, and a plate is chosen", async () => {
    const { page, problems } = await visit(browser);
    await page.locator("#controls").focus();
    await page.keyboard.press("g");
    const dialog = page.getByRole("dialog", { name: "All plates" });
    await dialog.waitFor();
    expect(await dialog.getByRole("button", { name: "Default" }).getAttribute("aria-pressed")).toBe("true");
    const plate = dialog.getByRole("button", { name: /^Figure 18 b/ });
    await plate.scrollIntoViewIfNeeded();
    await page.waitForFunction(() =>
      [...document.querySelectorAll("img")].some(
        (image) => image.src.endsWith("figure-18b.webp") && image.naturalWidth > 100,
      ),
    );
    await plate.click();
    await settled(page);
    expect(await dialog.count()).toBe(0);
    expect(query(page).get("preset")).toBe("figure-18b");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("does without drawings where they are missing", async () => {
    const context = await browser.newContext({ reducedMotion: "reduce" });
    await context.route("**/presets/*", (route) => route.fulfill({ status: 404, body: "" }));
    const page = await context.newPage();
    await page.goto(inject("site"));
    await settled(page);
    await page.getByRole("button", { name: "All plates" }).click();
    await page.waitForFunction(() => !document.querySelector("dialog .plate img[src*='figure-2a']"));
    await page
      .getByRole("dialog")
      .getByRole("button", { name: /^Figure 2 a/ })
      .click();
    await settled(page);
    expect(query(page).get("preset")).toBe("figure-2a");
    await context.close();
  });
});

describe("the list of keys", () => {
  it("opens by ?, says what they do, closes by Escape and gives the focus back", async () => {
    const { page } = await visit(browser);
    await page.getByRole("button", { name: "Undo" }).waitFor();
    await page.getByRole("button", { name: "Copy link" }).focus();
    await page.keyboard.press("?");
    const dialog = page.getByRole("dialog", { name: "Keys" });
    await dialog.waitFor();
    expect(await dialog.innerText()).toContain("Take the loads off");
    await page.keyboard.press("Escape");
    expect(await dialog.count()).toBe(0);
    expect(await page.evaluate(() => document.activeElement?.getAttribute("aria-label"))).toBe("Copy link");
    await page.context().close();
  });

  it("can turn single keys off, for people who speak to their computer", async () => {
    const { page } = await visit(browser);
    await page.getByRole("button", { name: "Keys" }).click();
    await page.getByRole("checkbox", { name: "Single keys are shortcuts" }).uncheck();
    await page.keyboard.press("Escape");
    await page.locator("#controls").focus();
    await page.keyboard.press("v");
    await page.reload();
    await settled(page);
    await page.locator("#controls").focus();
    await page.keyboard.press("v");
    await settled(page);
    expect(query(page).has("view")).toBe(false);
    await page.context().close();
  });
});

it("help gives the equation as MathML, and its source", async () => {
  const { page, problems } = await visit(browser);
  await page.getByRole("button", { name: "About Young's modulus" }).click();
  const help = page.locator("#material-youngsModulus-help");
  await help.locator("math").waitFor();
  expect(((await help.locator("math").textContent()) ?? "").replace(/\s/g, "")).toContain("κ=");
  expect(await help.innerText()).toContain("Equation 26");
  const size = await help.locator("math mfrac").first().boundingBox();
  expect(size?.height).toBeGreaterThan(20);
  expect(problems).toEqual([]);
  await page.context().close();
});

it("all values are reset at once, and that can be undone", async () => {
  const { page } = await visit(browser, "?preset=figure-8d");
  const tip = await readTip(page);
  await type(page, /^Gravity/, "3");
  await type(page, /^Radius/, "8 mm");
  await page.getByRole("button", { name: "Reset all" }).click();
  await settled(page);
  expect(await readTip(page)).toBe(tip);
  expect(await box(page, /^Gravity/).inputValue()).toBe("9.81");
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => location.search.includes("g=3"));
  await settled(page);
  expect(await box(page, /^Radius/).inputValue()).toBe("0.008");
  await page.context().close();
});

it("q comes with a sentence on what it means", async () => {
  const { page } = await visit(browser, "?preset=figure-8d");
  const gravityNumber = page.locator(".readout div").filter({ hasText: "Gravity number" });
  expect(await gravityNumber.innerText()).toMatch(/q\s+15\s+Weight rules: the tip hangs\./);
  await page.context().close();
});

describe("from a folder of some host", () => {
  const types: Record<string, string> = {
    html: "text/html",
    js: "text/javascript",
    css: "text/css",
    wasm: "application/wasm",
    svg: "image/svg+xml",
    webp: "image/webp",
  };
  let server: Server;
  beforeAll(async () => {
    server = createServer(async ({ url = "" }, response) => {
      const { pathname } = new URL(url, "http://host");
      const [, name] = /^\/~someone\/plants\/(.*)$/.exec(pathname) ?? [];
      const file = name === "" ? "index.html" : name;
      const body = file === undefined ? null : await readFile(join(site, file)).catch(() => null);
      response.writeHead(body ? 200 : 404, {
        "Content-Type": types[file?.split(".").at(-1) ?? ""] ?? "text/plain",
      });
      response.end(body ?? "");
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  });
  afterAll(() => server.close());

  it("everything works: worker, wasm, drawings, links", async () => {
    const { port } = server.address() as AddressInfo;
    const page = await browser.newPage({ reducedMotion: "reduce" });
    const failed: string[] = [];
    page.on("response", (response) => response.status() >= 400 && failed.push(response.url()));
    await page.goto(`http://127.0.0.1:${port}/~someone/plants/?g=3`);
    await settled(page);
    await slider(page, "Gravity, slider").press("ArrowRight");
    await settled(page);
    expect(new URL(page.url()).pathname).toBe("/~someone/plants/");
    expect(query(page).get("g")).toBe("3.2");
    await page.getByRole("button", { name: "All plates" }).click();
    await page
      .getByRole("dialog")
      .getByRole("button", { name: /^Figure 2 a/ })
      .waitFor();
    await page.waitForFunction(() =>
      [...document.querySelectorAll("dialog img")].some(
        (image) => (image as HTMLImageElement).naturalWidth > 0,
      ),
    );
    expect(failed).toEqual([]);
    await page.close();
  });
});
