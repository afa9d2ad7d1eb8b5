/** Pages of other people that have a plant in them, served from an origin of their own, together with the built widget. */

import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { site } from "../../tools/paths.mjs";
import { complaint } from "../browser/chromium.ts";

const types: Readonly<Record<string, string>> = {
  ".css": "text/css",
  ".html": "text/html",
  ".js": "text/javascript",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webp": "image/webp",
};

/** One origin. */
export interface Host {
  /** Its address, with a slash at the end. */
  readonly address: string;
  /** Puts up a page, and returns its address. */
  page(html: string, headers?: Readonly<Record<string, string>>): string;
  /** Everything that was asked for, by path, since the last page was put up. */
  readonly asked: string[];
  close(): void;
}

/** Starts an origin: its pages, and the files of the site beside them. */
export function openHost(): Promise<Host> {
  const pages = new Map<string, { html: string; headers: Readonly<Record<string, string>> }>();
  const asked: string[] = [];
  const server = createServer(({ url = "/" }, response) => {
    const path = new URL(url, "http://host").pathname;
    asked.push(path);
    const page = pages.get(path);
    if (page)
      return void response.writeHead(200, { "content-type": types[".html"], ...page.headers }).end(page.html);
    const file = join(site, path);
    if (!existsSync(file) || !statSync(file).isFile()) return void response.writeHead(404).end();
    const type = types[extname(file)] ?? "application/octet-stream";
    // As any host of scripts does, so that other origins may load the module and its wasm.
    const headers = { "content-type": type, "access-control-allow-origin": "*" };
    response.writeHead(200, headers).end(readFileSync(file));
  });
  return new Promise((resolve) => {
    server.listen(0, "127.0.0.1", () => {
      const place = server.address();
      const address = `http://127.0.0.1:${typeof place === "object" ? place?.port : ""}/`;
      resolve({
        address,
        asked,
        page: (html, headers = {}) => {
          const path = `/host-${pages.size}.html`;
          pages.set(path, { html: `<!doctype html><link rel="icon" href="data:,">${html}`, headers });
          asked.length = 0;
          return new URL(path, address).href;
        },
        close: () => server.close(),
      });
    });
  });
}

declare global {
  interface Window {
    /** Put there by the tests: every WebGL context that was made, without holding it. */
    contexts: WeakRef<WebGL2RenderingContext>[];
  }
}

/** A page that is open, and what went wrong in it: console errors and warnings, exceptions, requests elsewhere. */
export interface Guest {
  readonly page: Page;
  readonly problems: string[];
}

/** Opens an address in a browser context of its own. Motion is unwelcome unless the options say otherwise. */
export async function open(
  browser: Browser,
  address: string,
  options: BrowserContextOptions = {},
): Promise<Guest> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce",
    ...options,
  });
  const page = await context.newPage();
  const problems: string[] = [];
  page.on("console", (message) => {
    const said = complaint(message);
    if (said) problems.push(said);
  });
  page.on("pageerror", (error) => problems.push(`exception: ${error.stack}`));
  page.on("request", (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (hostname !== "127.0.0.1" && !["data:", "blob:"].includes(protocol))
      problems.push(`elsewhere: ${request.url()}`);
  });
  await page.addInitScript(countContexts);
  await page.goto(address);
  return { page, problems };
}

/** Runs in every frame before its own code. */
function countContexts(): void {
  window.contexts = [];
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...asked: [string]) {
    const context = getContext.apply(this, asked);
    if (context instanceof WebGL2RenderingContext) window.contexts.push(new WeakRef(context));
    return context;
  } as typeof getContext;
}

/** How many WebGL contexts live in all frames of a page, and how many were ever made. */
export async function contextsOf(page: Page): Promise<{ alive: number; made: number }> {
  const counts = await Promise.all(
    page.frames().map((frame) =>
      frame.evaluate(() => {
        const all = (window.contexts ?? []).map((one) => one.deref());
        const alive = all.filter((context) => context && !context.isContextLost());
        return { alive: alive.length, made: all.length };
      }),
    ),
  );
  const sum = (key: "alive" | "made") => counts.reduce((total, count) => total + count[key], 0);
  return { alive: sum("alive"), made: sum("made") };
}

/** Waits until a plant is drawn and at rest in an element of the page. */
export async function drawn(page: Page, selector = "bough-plant"): Promise<void> {
  await page.locator(selector).evaluate(async (element) => {
    await (element as HTMLElementTagNameMap["bough-plant"]).toBlob();
  });
}
