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

/** How much of each figure's plant only the figure has, or only its poster: a share of what both cover. */
export async function apartFromPosters(page: Page): Promise<(readonly [id: string, share: number])[]> {
  return page.locator("bough-plant").evaluateAll(async (elements) => {
    /** How much a plant on nothing covers of each square of a grid. */
    const cover = (picture: CanvasImageSource): number[] => {
      const [width, height, side] = [540, 360, 6];
      const pen = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
      pen?.drawImage(picture, 0, 0);
      const { data } = pen?.getImageData(0, 0, width, height) ?? { data: [] };
      const squares = new Array<number>((width * height) / side ** 2).fill(0);
      data.forEach((value, k) => {
        const [x, y] = [(k >> 2) % width, Math.floor((k >> 2) / width)];
        const square = (Math.floor(y / side) * width) / side + Math.floor(x / side);
        if (k % 4 === 3) squares[square] = (squares[square] ?? 0) + value;
      });
      return squares;
    };
    const found: [string, number][] = [];
    for (const element of elements) {
      const plant = element as HTMLElementTagNameMap["bough-plant"];
      const poster = plant.querySelector<HTMLImageElement>("img[slot=poster]");
      if (!poster) throw new Error(`${plant.id} has no poster.`);
      poster.loading = "eager";
      await poster.decode();
      // As they are made.
      plant.controls = "none";
      plant.style.width = "542px";
      await plant.settled();
      const [there, here] = [cover(poster), cover(await createImageBitmap(await plant.toBlob()))];
      const sum = (of: (there: number, here: number) => number) =>
        there.reduce((sum, alpha, square) => sum + of(alpha, here[square] ?? 0), 0);
      found.push([plant.id, sum((a, b) => Math.abs(a - b)) / sum(Math.max)]);
    }
    return found;
  });
}
