/** What the page does, and does not do, for every change: counted in the browser before any script of the page runs. */
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { box, query, settled, slider } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

interface Counts {
  /** Animation frames asked for. */
  frames: number;
  /** Calls that draw, and that clear. */
  draws: number;
  /** Buffers made, and buffers given another size. */
  made: number;
  sized: number;
  /** Buffers written over in place. */
  written: number;
  /** Pictures that were finished. */
  pictures: number;
  /** Plants that came from the worker, as their points. */
  shapes: number[][];
}

declare global {
  interface Window {
    counts: Counts;
  }
}

/** Runs in the page before its own code. */
function count(): void {
  const counts: Counts = { frames: 0, draws: 0, made: 0, sized: 0, written: 0, pictures: 0, shapes: [] };
  window.counts = counts;
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => {
    counts.frames++;
    return request(callback);
  };
  const drawing = WebGL2RenderingContext.prototype as unknown as Record<string, unknown>;
  const wrap = (name: string, what: "draws" | "made" | "sized" | "written") => {
    const original = drawing[name] as (...args: unknown[]) => unknown;
    drawing[name] = function (...args: unknown[]) {
      counts[what]++;
      // Nobody looks at the pixels, which would be most of the work.
      return what === "draws" ? undefined : original.apply(this, args);
    };
  };
  for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced", "clear"])
    wrap(name, "draws");
  wrap("createBuffer", "made");
  wrap("bufferData", "sized");
  wrap("bufferSubData", "written");
  document.addEventListener("bough-drawn", () => counts.pictures++);
  const { addEventListener } = Worker.prototype;
  Worker.prototype.addEventListener = function (this: Worker, ...args: Parameters<typeof addEventListener>) {
    if (args[0] === "message") {
      addEventListener.call(this, "message", (event) => {
        const { data } = event as MessageEvent;
        if (data.kind === "shape") counts.shapes.push([...data.shape.polylines.points]);
      });
    }
    addEventListener.apply(this, args);
  } as typeof addEventListener;
}

async function open(link = "", options: BrowserContextOptions = {}): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce",
    ...options,
  });
  const page = await context.newPage();
  await page.addInitScript(count);
  await page.goto(new URL(link, inject("site")).href);
  await settled(page);
  return page;
}

const counted = (page: Page) =>
  page.evaluate(() => ({ ...window.counts, shapes: window.counts.shapes.length }));

it.each(["", "?preset=figure-17d&view=space&color=stress"])(
  "left alone for 5 s after its growth was watched, the page asks for no frame and draws nothing: %s",
  async (link) => {
    const page = await open(link, { reducedMotion: "no-preference" });
    const before = await counted(page);
    expect(before.frames).toBeGreaterThan(0);
    expect(before.draws).toBeGreaterThan(0);
    await page.waitForTimeout(5000);
    expect(await counted(page)).toEqual(before);
    await page.context().close();
  },
);

it("where motion is unwelcome the plant is there full grown at once", async () => {
  const page = await open();
  expect((await counted(page)).pictures).toBeLessThanOrEqual(3);
  expect((await counted(page)).shapes).toBe(1);
  await page.context().close();
});

it("plants are computed in a worker", async () => {
  const page = await open();
  expect(page.workers()).toHaveLength(1);
  expect((await counted(page)).shapes).toBeGreaterThan(0);
  await page.context().close();
});

describe("a change of a value", () => {
  it("is drawn once, into the buffers that are there", async () => {
    const page = await open("?n=200&l=0.0075");
    const gravity = slider(page, "Gravity, slider");
    for (let press = 0; press < 3; press++) {
      await gravity.press("ArrowRight");
      await settled(page);
    }
    const before = await counted(page);
    for (let press = 0; press < 5; press++) {
      await gravity.press("ArrowRight");
      await settled(page);
    }
    const after = await counted(page);
    expect(after.shapes - before.shapes).toBe(5);
    expect(after.written - before.written).toBeGreaterThan(0);
    expect([after.made - before.made, after.sized - before.sized]).toEqual([0, 0]);
    // Once when it is there; once more may be when the key is up, and the frame fits closely again.
    expect(after.pictures - before.pictures).toBeLessThanOrEqual(10);
    expect(after.pictures - before.pictures).toBeGreaterThanOrEqual(5);
    await page.context().close();
  });

  it("by a key that is held down loses no press, and is one step of history", async () => {
    const page = await open();
    const entries = await page.evaluate(() => history.length);
    await slider(page, "Gravity, slider").focus();
    for (let press = 0; press < 30; press++) await page.keyboard.down("ArrowRight");
    // The gesture goes on until the key is up.
    expect(await page.evaluate(() => document.documentElement.dataset.settled)).toBe("false");
    expect(await page.evaluate(() => history.length)).toBe(entries);
    await page.keyboard.up("ArrowRight");
    await settled(page);
    expect(query(page).get("g")).toBe("15.8");
    expect(await page.evaluate(() => history.length)).toBe(entries + 1);
    await page.goBack();
    await page.waitForFunction(() => !location.search.includes("g="));
    await settled(page);
    expect(await box(page, /^Gravity/).inputValue()).toBe("9.81");
    await page.context().close();
  });

  it("by a key that is still down when the focus goes elsewhere ends there", async () => {
    const page = await open();
    await slider(page, "Age").focus();
    await page.keyboard.down("ArrowLeft");
    await page.keyboard.down("ArrowLeft");
    await slider(page, "Gravity, slider").focus();
    await settled(page);
    expect(query(page).get("step")).toBe("38");
    await page.keyboard.up("ArrowLeft");
    await settled(page);
    expect(query(page).get("step")).toBe("38");
    await page.context().close();
  });

  it("that comes while a long one is computed takes its place", async () => {
    const page = await open();
    await box(page, /^Segments/).fill("60000");
    await box(page, /^Segments/).press("Enter");
    await page.getByRole("progressbar", { name: "Growing" }).waitFor();
    const before = await counted(page);
    await slider(page, "Segments, slider").press("Home");
    await settled(page);
    // The long one never came.
    expect((await counted(page)).shapes - before.shapes).toBe(1);
    expect(await page.getByRole("progressbar").count()).toBe(0);
    await page.context().close();
  });
});

it("a plant that was pulled and let go of has the shape of before, to 1e-9 of its length", async () => {
  const page = await open("?l=0.0125&r=0.0015");
  await page.locator("canvas.picture").focus();
  await page.keyboard.press("Enter");
  for (let press = 0; press < 4; press++) await page.keyboard.press("ArrowDown");
  await page.locator(".pull data").waitFor();
  await page.keyboard.press("Escape");
  await settled(page);
  // Computed once more, from the state that the pulling left behind.
  await page.keyboard.press(",");
  await settled(page);
  await slider(page, "Gravity, slider").press("ArrowRight");
  await settled(page);
  await page.keyboard.press("Control+z");
  await settled(page);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => !location.search.includes("step"));
  await settled(page);
  const { first, last } = await page.evaluate(() => {
    const { shapes } = window.counts;
    const whole = shapes.filter(({ length }) => length === shapes[0]?.length);
    return { first: whole[0] ?? [], last: whole.at(-1) ?? [] };
  });
  expect(first.length).toBe(123);
  const farthest = last.reduce((most, value, at) => Math.max(most, Math.abs(value - (first[at] ?? 0))), 0);
  expect(farthest).toBeLessThanOrEqual(1e-9 * 0.5);
  await page.context().close();
});

it("the plant is described when it has settled, not at every tick of its growth", async () => {
  const page = await open("?preset=figure-13c");
  await page.getByRole("status").filter({ hasText: "An axis of 40 segments" }).waitFor();
  await page.evaluate(() => {
    const region = document.querySelector("#page > [role=status]");
    const said: string[] = [];
    Object.assign(window, { said });
    if (region) {
      const note = () => said.push(region.textContent ?? "");
      new MutationObserver(note).observe(region, { characterData: true, childList: true, subtree: true });
    }
  });
  const said = () => page.evaluate(() => (window as unknown as { said: string[] }).said);
  await page.getByRole("button", { name: "Watch it grow" }).click();
  // Paused by the page itself: on a slow machine it would be full grown before a pointer is there.
  const onTheWay = await page.waitForFunction(() => {
    // Until the first picture of the replay is there, the age is still that of the full-grown plant.
    const age = Number(document.querySelector<HTMLInputElement>("#age")?.value);
    if (!(age > 12 && age < 40)) return null;
    document.querySelector<HTMLElement>(".play")?.click();
    return [...(window as unknown as { said: string[] }).said];
  });
  expect(await onTheWay.jsonValue()).toEqual([]);
  await settled(page);
  await page.waitForFunction(() => (window as unknown as { said: string[] }).said.length > 0);
  expect(await said()).toHaveLength(1);
  expect((await said())[0]).toMatch(/^An axis of \d+ segments/);
  await page.context().close();
});
