/** Many plants on one page: which ones, and whether all of them are seen. */
import type { CDPSession, Locator, Page } from "playwright";
import { expect } from "vitest";
import { presets } from "../../web/src/params/declaration.ts";
import { Pixels } from "../browser/pixels.ts";

const ids = Object.keys(presets);
/** So many presets, all of them before any again. */
export const choose = (count: number) => Array.from({ length: count }, (_, k) => ids[k % ids.length] ?? "");

/** Scrolls through a page from top to bottom; at every stop the elements in view must show wood. */
export async function scrollThrough(
  page: Page,
  elements: Locator,
  atStop: () => Promise<void>,
): Promise<Set<number>> {
  const seen = new Set<number>();
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  for (let top = 0; top < height; top += 500) {
    await page.evaluate((top) => scrollTo(0, top), top);
    await expect.poll(() => blankIn(page, elements, seen), { timeout: 30_000, interval: 250 }).toEqual([]);
    await atStop();
  }
  return seen;
}

/** Numbers of the elements that are wholly in view and show no wood; the others are noted. */
async function blankIn(page: Page, elements: Locator, seen: Set<number>): Promise<number[]> {
  const boxes = await elements.evaluateAll((all) =>
    all.map((element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x, y, width, height };
    }),
  );
  const pixels = await Pixels.of(page);
  const blank: number[] = [];
  boxes.forEach(({ x, y, width, height }, index) => {
    if (y < 0 || y + height > 800) return;
    // The smallest of the presets' plants still fill that much of a disc in the middle.
    const wood = pixels.wood(x + width / 2, y + height / 2, Math.floor(height / 2) - 2);
    if (wood > 0.002) seen.add(index);
    else blank.push(index);
  });
  return blank;
}

/** Thirty widgets. */
export const thirty = choose(30)
  .map((id) => `<bough-plant preset="${id}" step="full" controls="none"></bough-plant>`)
  .join("\n");

/** Two dozen frames of an origin. */
export function twoDozen(address: string): string {
  const frames = choose(24).map(
    (id, k) => `<iframe src="${address}embed.html?v=1&preset=${id}&step=full&ui=none" width="480" height="320"
      title="Plant ${k}" style="border: 0"></iframe>`,
  );
  return frames.join("\n");
}

/** What a page holds when all garbage is gone; the heap in MB. */
export interface Held {
  readonly nodes: number;
  readonly listeners: number;
  readonly heap: number;
}

/** Reads what a page holds. */
export async function heldBy(session: CDPSession): Promise<Held> {
  await session.send("Performance.enable");
  await session.send("HeapProfiler.collectGarbage");
  const { metrics } = await session.send("Performance.getMetrics");
  const value = (name: string) => metrics.find((metric) => metric.name === name)?.value ?? 0;
  return { nodes: value("Nodes"), listeners: value("JSEventListeners"), heap: value("JSHeapUsedSize") / 1e6 };
}
