/** Screens with more than one device pixel a CSS px: the picture is as fine as they are, and the hand as exact. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { Pixels } from "./pixels.ts";
import { placeOf, settled, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Shorter than 1 m, so that places are shown to half a millimetre. */
const query = "?l=0.0125&r=0.0015";
const tip = (forces: { segment: number; force: [number, number, number] }[] = []) => {
  const { points } = grow({ axis: { segmentLength: 0.0125, radius: 0.0015 }, loads: { forces } }).polylines;
  return [...points.subarray(points.length - 3)];
};

it.each([
  [2, 2],
  [1.5, 1.5],
  // More than two cannot be seen, and costs with its square.
  [3, 2],
])("at %d device pixels the picture has %d pixels a CSS px", async (deviceScaleFactor, density) => {
  const { page, problems } = await visit(browser, query, { deviceScaleFactor });
  const size = await page.locator("canvas.picture").evaluate((canvas: HTMLCanvasElement) => ({
    fine: [canvas.width, canvas.height],
    coarse: [canvas.clientWidth, canvas.clientHeight],
  }));
  expect(size.fine).toEqual(size.coarse.map((length) => Math.round(length * density)));
  expect(problems).toEqual([]);
  await page.context().close();
});

it("at 2 device pixels an edge is as steep from pixel to pixel as at 1: nothing is merely enlarged", async () => {
  const steepest: number[] = [];
  for (const density of [1, 2]) {
    const { page } = await visit(browser, query, { deviceScaleFactor: density });
    const { x, y } = await placeOf(page, [0.2, 0.2, 0]);
    const pixels = await Pixels.of(page);
    const brightness = (across: number, up: number) =>
      pixels.at(density * (x + across), density * y - up).reduce((sum, value) => sum + value, 0);
    let most = 0;
    // Upwards through the limb, at many places.
    for (let across = 0; across < 40; across++) {
      for (let up = -60 * density; up < 60 * density; up++) {
        most = Math.max(most, Math.abs(brightness(across, up + 1) - brightness(across, up)));
      }
    }
    steepest.push(most);
    await page.context().close();
  }
  // An enlarged picture would spread each step over two pixels: half as steep.
  expect(steepest[0]).toBeGreaterThan(60);
  expect(steepest[1]).toBeGreaterThan(0.75 * (steepest[0] ?? 0));
});

it("at 2 device pixels the tip follows the pointer within 2 px, and the force shown is the one that solves it", async () => {
  const { page, problems } = await visit(browser, query, { deviceScaleFactor: 2 });
  const [from, to] = [
    await placeOf(page, tip()),
    await placeOf(page, tip([{ segment: 39, force: [0.002, -0.01, 0] }])),
  ];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.locator(".pull data").waitFor();
  await settled(page);
  const [x = 0, y = 0, z = 0] = ((await page.locator(".pull data").getAttribute("value")) ?? "")
    .split(",")
    .map(Number);
  const solved = await placeOf(page, tip([{ segment: 39, force: [x, y, z] }]));
  expect(Math.hypot(solved.x - to.x, solved.y - to.y)).toBeLessThan(2);
  expect((await Pixels.of(page)).wood(2 * to.x, 2 * to.y, 6)).toBeGreaterThan(0.2);
  await page.mouse.up();
  expect(problems).toEqual([]);
  await page.context().close();
});
