/** Opening the built course in real Chromium. */
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { inject } from "vitest";
import { complaint } from "../../browser/chromium.ts";

/** A page of the course that is open, and what went wrong on it. */
export interface Reader {
  readonly page: Page;
  readonly problems: string[];
}

/** Opens a page of the course; `address` replaces the address of the site. */
export async function open(
  browser: Browser,
  name: string,
  options: BrowserContextOptions = {},
  address: string = inject("site"),
): Promise<Reader> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    reducedMotion: "reduce",
    ...options,
  });
  const page = await context.newPage();
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
  page.on("console", (message) => {
    const said = complaint(message);
    if (said) problems.push(said);
  });
  page.on("request", (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (hostname !== "127.0.0.1" && ["http:", "https:"].includes(protocol))
      problems.push(`elsewhere: ${request.url()}`);
  });
  await page.goto(new URL(`course/${name}`, address).href);
  return { page, problems };
}

/** How long a figure took until it was drawn, ms. */
export interface Drawing {
  readonly id: string;
  /** By the clock. */
  readonly clock: number;
  /** Of processors, in all processes of the browser. */
  readonly computing: number;
}

/** Draws some live figures of the page, one after the other. */
export async function draw(page: Page, ids: readonly string[]): Promise<Drawing[]> {
  const session = await page.context().browser()?.newBrowserCDPSession();
  const computed = async () => {
    const { processInfo = [] } = (await session?.send("SystemInfo.getProcessInfo")) ?? {};
    return 1000 * processInfo.reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  };
  const drawings: Drawing[] = [];
  for (const id of ids) {
    const before = await computed();
    const clock = await page.locator(`bough-plant#${id}`).evaluate(async (element) => {
      const start = performance.now();
      await (element as HTMLElementTagNameMap["bough-plant"]).toBlob();
      return performance.now() - start;
    });
    drawings.push({ id, clock, computing: (await computed()) - before });
  }
  await session?.detach();
  return drawings;
}
