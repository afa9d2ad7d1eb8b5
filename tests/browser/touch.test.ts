/** A hand on the plant: it follows, the force is shown, and it returns. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { Pixels } from "./pixels.ts";
import { placeOf, pull, query, readTip, settled, visit, visitUnpainted } from "./visit.ts";

type Point = [x: number, y: number, z: number];

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Shorter than 1 m: then the page states places to half a millimetre, which is less than a pixel. */
const branch = "?l=0.0125&r=0.0015";
const params = { axis: { segmentLength: 0.0125, radius: 0.0015 } };
const tipSegment = 39;

/** Where the tip is, with or without a force on it. */
function tipOf(force?: Point): Point {
  const loads = force ? { forces: [{ segment: tipSegment, force }] } : {};
  const { points } = grow({ ...params, loads }).polylines;
  const [x = 0, y = 0, z = 0] = points.subarray(points.length - 3);
  return [x, y, z];
}

/** A length as the page writes it, in m. */
function meters(text: string): number {
  const [, number = "", unit = ""] = /([−-]?[\d.]+) (mm|cm|m)/.exec(text) ?? [];
  return Number(number.replace("−", "-")) * ({ mm: 1e-3, cm: 1e-2, m: 1 }[unit] ?? Number.NaN);
}

/** The measured tip. */
async function measuredTip(page: Page): Promise<Point> {
  const [across = "", height = ""] = (await readTip(page)).split(",");
  return [meters(across), meters(height) * (height.includes("down") ? -1 : 1), 0];
}

/** The force that the page shows, N. */
async function shownForce(page: Page): Promise<Point> {
  const [x = 0, y = 0, z = 0] = ((await page.locator(".pull data").getAttribute("value")) ?? "")
    .split(",")
    .map(Number);
  return [x, y, z];
}

async function drag(page: Page, from: Point, to: Point): Promise<{ x: number; y: number }> {
  const [start, end] = [await placeOf(page, from), await placeOf(page, to)];
  await pull(page, start, end);
  return end;
}

function distance(a: { x: number; y: number }, b: { x: number; y: number }): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

describe("dragged by its tip, the branch", () => {
  it("follows within 2 px, by the force that is shown, and returns", async () => {
    const { page, problems } = await visit(browser, branch);
    const [before, tipBefore] = [await Pixels.of(page), await readTip(page)];
    const free = tipOf();
    const place = tipOf([0.002, -0.01, 0]);
    const pointer = await drag(page, free, place);
    // By the numbers, and in the picture: there is wood under the pointer, and none where the tip was.
    expect(distance(await placeOf(page, await measuredTip(page)), pointer)).toBeLessThan(2);
    const held = await Pixels.of(page);
    const old = await placeOf(page, free);
    expect(held.wood(pointer.x, pointer.y, 3)).toBeGreaterThan(0.2);
    expect(held.wood(old.x, old.y, 2)).toBe(0);
    // The shown force, as a load, brings the tip to where the pointer is.
    const force = await shownForce(page);
    expect(distance(await placeOf(page, tipOf(force)), pointer)).toBeLessThan(2);
    const size = Math.hypot(...force);
    const text = await page.locator(".pull data").innerText();
    expect(Math.abs(Number.parseFloat(text) * 1e-3 - size) / size).toBeLessThan(0.06);
    expect(text).toMatch(/^[\d.]+ mN · [\d.]+ gf$/);
    await page.getByRole("status").filter({ hasText: "Held at the end of segment 40 by" }).waitFor();
    // Pulling is kept out of the link, and is nothing to undo.
    expect(query(page).get("v")).toBeNull();
    expect(await page.getByRole("button", { name: "Undo" }).isDisabled()).toBe(true);
    await page.mouse.up();
    await settled(page);
    expect(await readTip(page)).toBe(tipBefore);
    await page.mouse.move(5, 5);
    const panel = await page.locator("#controls").boundingBox();
    const after = await Pixels.of(page);
    const { x, y } = await placeOf(page, free);
    expect(after.at(x, y)).toEqual(before.at(x, y));
    expect(panel).not.toBeNull();
    expect(await page.locator(".pull").count()).toBe(0);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("is let go of by Escape, while the button is still down", async () => {
    const { page } = await visitUnpainted(browser, branch);
    const tip = await readTip(page);
    await drag(page, tipOf(), [0.3, 0.2, 0]);
    expect(await readTip(page)).not.toBe(tip);
    await page.keyboard.press("Escape");
    await settled(page);
    expect(await readTip(page)).toBe(tip);
    await page.mouse.move(400, 300);
    await settled(page);
    expect(await readTip(page)).toBe(tip);
    await page.mouse.up();
    await page.context().close();
  });

  it("swings back where motion is welcome, and at once where it is not", async () => {
    const swings: { drawn: number; took: number }[] = [];
    for (const reducedMotion of ["no-preference", "reduce"] as const) {
      const { page } = await visitUnpainted(browser, `${branch}&step=39`, { reducedMotion });
      await drag(page, tipOf(), [0.3, 0.2, 0]);
      const drawn = await page.evaluate(() => window.seen.drawn);
      await page.evaluate(() => {
        addEventListener("pointerup", () => performance.mark("let go"), { once: true, capture: true });
      });
      await page.mouse.up();
      await page.waitForTimeout(100);
      await settled(page);
      swings.push(
        await page.evaluate((before) => {
          const [letGo] = performance.getEntriesByName("let go");
          return { drawn: window.seen.drawn - before, took: performance.now() - (letGo?.startTime ?? 0) };
        }, drawn),
      );
      await page.context().close();
    }
    const [welcome, unwelcome] = swings;
    // However few pictures a busy machine draws of it, it lasts its time, 1.1 s.
    expect(welcome?.drawn).toBeGreaterThan(1);
    expect(welcome?.took).toBeGreaterThan(1000);
    expect(unwelcome?.drawn).toBeLessThanOrEqual(3);
  });

  it("comes as near as it can to a place out of reach", async () => {
    const { page } = await visitUnpainted(browser, branch);
    await drag(page, tipOf(), [0.6, 0.1, 0]);
    const [x, y] = await measuredTip(page);
    expect(Math.hypot(x, y)).toBeGreaterThan(0.48);
    expect(Math.hypot(x, y)).toBeLessThan(0.5005);
    await page.mouse.up();
    await page.context().close();
  });
});

it("any limb can be dragged, in space too; beside the plant the camera turns", async () => {
  const { page } = await visitUnpainted(browser, "?preset=figure-18b&view=space");
  const tip = await readTip(page);
  const { polylines } = grow({});
  expect(polylines.offsets.length).toBe(2);
  const start = await placeOf(page, [0.1, 0.2, 0]);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(start.x + 60, start.y + 30, { steps: 4 });
  await page.locator(".pull data").waitFor();
  await page.mouse.up();
  await settled(page);
  expect(await readTip(page)).toBe(tip);
  const before = await placeOf(page, [0.5, 0, 0]);
  await page.mouse.move(40, 200);
  await page.mouse.down();
  await page.mouse.move(140, 220, { steps: 4 });
  await page.mouse.up();
  expect(await page.locator(".pull").count()).toBe(0);
  await page.waitForTimeout(100);
  expect(distance(await placeOf(page, [0.5, 0, 0]), before)).toBeGreaterThan(5);
  await page.context().close();
});

it("by keys: Enter takes hold of the tip, arrows pull, Page Down goes towards the base, Escape lets go", async () => {
  const { page } = await visitUnpainted(browser, branch);
  const tip = await measuredTip(page);
  await page.locator("canvas.picture").focus();
  await page.keyboard.press("Enter");
  for (let press = 0; press < 5; press++) await page.keyboard.press("ArrowDown");
  await settled(page);
  const [x, y] = await measuredTip(page);
  // Five times 2 % of half a metre.
  expect(tip[1] - y).toBeCloseTo(0.05, 3);
  expect(x).toBeCloseTo(tip[0], 3);
  await page.getByRole("status").filter({ hasText: "Held at the end of segment 40 by" }).waitFor();
  await page.keyboard.press("PageDown");
  await page.getByText("Segment 39").waitFor();
  await page.keyboard.press("Escape");
  await settled(page);
  expect(await measuredTip(page)).toEqual(tip);
  // The same by the button, for who does not know the keys.
  await page.getByRole("button", { name: "Take hold of the tip" }).click();
  await page.keyboard.press("ArrowDown");
  await page.getByRole("button", { name: "Let go" }).click();
  await settled(page);
  expect(await measuredTip(page)).toEqual(tip);
  await page.context().close();
});

describe("by touch", () => {
  async function fingers(page: Page) {
    const session = await page.context().newCDPSession(page);
    return (type: "touchStart" | "touchMove" | "touchEnd", ...points: { x: number; y: number }[]) =>
      session.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: points.map(({ x, y }, id) => ({ x, y, id })),
      });
  }
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

  it("one finger drags the plant", async () => {
    const { page } = await visitUnpainted(browser, branch, phone);
    const tip = await readTip(page);
    const touch = await fingers(page);
    const { x, y } = await placeOf(page, tipOf());
    await touch("touchStart", { x, y });
    for (const share of [0.3, 0.6, 1]) await touch("touchMove", { x: x - 30 * share, y: y + 40 * share });
    await page.locator(".pull").waitFor();
    await settled(page);
    expect(await readTip(page)).not.toBe(tip);
    await touch("touchEnd");
    await settled(page);
    expect(await readTip(page)).toBe(tip);
    await page.context().close();
  });

  it("two fingers zoom, even if the first of them is on the plant", async () => {
    const { page } = await visitUnpainted(browser, branch, phone);
    const width = async () => distance(await placeOf(page, [0, 0, 0]), await placeOf(page, tipOf()));
    const before = await width();
    const touch = await fingers(page);
    const { x, y } = await placeOf(page, tipOf());
    await touch("touchStart", { x, y });
    await touch("touchStart", { x, y }, { x: x - 60, y: y + 60 });
    for (const by of [15, 30, 45])
      await touch("touchMove", { x: x + by, y: y - by }, { x: x - 60 - by, y: y + 60 + by });
    expect(await page.locator(".pull").count()).toBe(0);
    await touch("touchEnd");
    await page.waitForTimeout(100);
    await settled(page);
    expect(await width()).toBeGreaterThan(1.3 * before);
    await page.context().close();
  });
});
