/** Opening the built course in real Chromium. */
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { inject } from "vitest";

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
    if (["error", "warning"].includes(message.type())) problems.push(message.text());
  });
  page.on("request", (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (hostname !== "127.0.0.1" && ["http:", "https:"].includes(protocol))
      problems.push(`elsewhere: ${request.url()}`);
  });
  await page.goto(new URL(`course/${name}`, address).href);
  return { page, problems };
}

/** Draws some live figures of the page, one after the other; how long each took, ms. */
export function draw(page: Page, ids: readonly string[]): Promise<[id: string, time: number][]> {
  return page.evaluate(async (ids) => {
    const times: [string, number][] = [];
    for (const id of ids) {
      const plant = document.querySelector<HTMLElementTagNameMap["bough-plant"]>(`bough-plant#${id}`);
      const start = performance.now();
      await plant?.toBlob();
      times.push([id, performance.now() - start]);
    }
    return times;
  }, ids);
}
