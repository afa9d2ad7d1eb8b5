/** A person's visit to the built page in real Chromium. */
import type { Browser, BrowserContextOptions, Locator, Page } from "playwright";
import { inject } from "vitest";
import type { Drawn } from "../../web/src/scene/stage.ts";
import { complaint } from "./chromium.ts";

export interface Visit {
  readonly page: Page;
  /** Everything that went wrong: console errors and warnings, exceptions, failed requests, requests to other hosts. */
  readonly problems: string[];
}

declare global {
  interface Window {
    /** Put there by the tests: pictures drawn and animation frames asked for so far, what the last picture told, and the graphics card. */
    seen: { drawn: number; frames: number; last: Drawn | null; webgl: WebGL2RenderingContext | null };
  }
}

const desktop = { width: 1280, height: 800 };

/** Opens the page at a link and waits until the plant stands still. Motion is unwelcome unless the options say otherwise. */
export async function visit(
  browser: Browser,
  query = "",
  options: BrowserContextOptions = {},
): Promise<Visit> {
  return open(browser, query, options, watch);
}

/** A visit by somebody who looks at no pixel: a third of the work. */
export async function visitUnpainted(
  browser: Browser,
  query = "",
  options: BrowserContextOptions = {},
): Promise<Visit> {
  return open(browser, query, options, watch, paintNothing);
}

async function open(
  browser: Browser,
  query: string,
  options: BrowserContextOptions,
  ...first: readonly (() => void)[]
): Promise<Visit> {
  const context = await browser.newContext({
    viewport: desktop,
    reducedMotion: "reduce",
    // What is kept for times without a network is tried where it matters: anywhere.test.ts.
    serviceWorkers: "block",
    ...options,
  });
  const page = await context.newPage();
  const problems = listen(page);
  for (const script of first) await page.addInitScript(script);
  await page.goto(new URL(query, inject("site")).href);
  await settled(page);
  return { page, problems };
}

/** Notes what goes wrong on a page. */
export function listen(page: Page): string[] {
  const problems: string[] = [];
  const site = new URL(inject("site")).origin;
  page.on("console", (message) => {
    const said = complaint(message);
    if (said) problems.push(said);
  });
  page.on("pageerror", (error) => problems.push(`exception: ${error.stack}`));
  page.on("requestfailed", (request) => {
    // What is under way when a page is left is given up; nobody misses it.
    if (request.failure()?.errorText !== "net::ERR_ABORTED") problems.push(`failed: ${request.url()}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) problems.push(`${response.status()}: ${response.url()}`);
  });
  page.on("request", (request) => {
    const { origin, protocol } = new URL(request.url());
    if (origin !== site && !["data:", "blob:"].includes(protocol))
      problems.push(`elsewhere: ${request.url()}`);
  });
  return problems;
}

/** Runs in the page before its own code. */
function watch(): void {
  window.seen = { drawn: 0, frames: 0, last: null, webgl: null };
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...asked: [string]) {
    const context = getContext.apply(this, asked);
    if (context instanceof WebGL2RenderingContext) window.seen.webgl = context;
    return context;
  } as typeof getContext;
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => {
    window.seen.frames++;
    return request(callback);
  };
  document.addEventListener("bough-drawn", (event) => {
    window.seen.drawn++;
    window.seen.last = (event as CustomEvent<Drawn>).detail;
  });
}

/**
 * Runs in the page before its own code. Where the processor paints the picture, most of a visit is painting, and many tests
 * look at no pixel: all calls of WebGL go through but those that fill pixels, and what fetches them for the page.
 */
export function paintNothing(): void {
  const { prototype } = WebGL2RenderingContext;
  prototype.drawElements = () => {};
  prototype.drawArrays = () => {};
  prototype.drawElementsInstanced = () => {};
  prototype.drawArraysInstanced = () => {};
  CanvasRenderingContext2D.prototype.drawImage = () => {};
}

/** Waits until all that was entered is computed and drawn. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => document.documentElement.dataset.settled === "true");
}

/** Where a point of the world (m) is drawn, in px of the page. */
export async function placeOf(page: Page, [x, y, z]: readonly number[]): Promise<{ x: number; y: number }> {
  const last = await page.evaluate(() => window.seen.last);
  const box = await page.locator("canvas.picture").boundingBox();
  if (!last || !box) throw new Error("Nothing was drawn.");
  const row = (k: number) =>
    (last.projection[k] ?? 0) * (x ?? 0) +
    (last.projection[k + 4] ?? 0) * (y ?? 0) +
    (last.projection[k + 8] ?? 0) * (z ?? 0) +
    (last.projection[k + 12] ?? 0);
  return {
    x: box.x + box.width * (0.5 + (0.5 * row(0)) / row(3)),
    y: box.y + box.height * (0.5 - (0.5 * row(1)) / row(3)),
  };
}

/** The measured tip, as the page states it. */
export async function readTip(page: Page): Promise<string> {
  return page.locator(".readout dd").nth(1).innerText();
}

/** The query of the page's address. */
export function query(page: Page): URLSearchParams {
  return new URL(page.url()).searchParams;
}

/** The box with this label. */
export function box(page: Page, name: RegExp | string): Locator {
  return page.getByRole("textbox", { name });
}

/** The slider with this label. */
export function slider(page: Page, name: string): Locator {
  return page.getByRole("slider", { name });
}

/** Types something into a box, and waits for what comes of it. */
export async function type(page: Page, name: RegExp | string, text: string): Promise<void> {
  await box(page, name).fill(text);
  await box(page, name).press("Enter");
  await settled(page);
}

/** Takes hold of the plant at a place on the page and pulls it to another; the button stays down. */
export async function pull(page: Page, from: { x: number; y: number }, to: { x: number; y: number }) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 6 });
  await page.locator(".pull data").waitFor();
  await settled(page);
}

/** Drops a file on the page: of a text, of bytes, or of so many zeros. */
export async function dropFile(
  page: Page,
  name: string,
  type: string,
  content: string | number | readonly number[],
): Promise<void> {
  await page.evaluate(
    ({ name, type, content }) => {
      const bytes = (of: number | readonly number[]) =>
        typeof of === "number" ? new Uint8Array(of) : new Uint8Array(of);
      const part = typeof content === "string" ? content : bytes(content);
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([part], name, { type }));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    },
    { name, type, content },
  );
}
