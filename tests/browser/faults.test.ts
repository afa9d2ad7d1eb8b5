/** Faults from outside, put into the way of a person: storage, network, files, clock. Each has its row in docs/promises.md. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { box, dropFile, listen, query, readTip, settled, type, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** A page on which something is put into the way before it is opened. */
async function hindered(hinder: (page: Page) => Promise<unknown>, link = "") {
  const context = await browser.newContext({ serviceWorkers: "block", reducedMotion: "reduce" });
  const page = await context.newPage();
  const problems = listen(page);
  await hinder(page);
  await page.goto(new URL(link, inject("site")).href);
  return { page, problems };
}

const length = (page: Page) => page.locator(".readout dd").first().innerText();

describe("a storage that is", () => {
  it.each([
    [
      "denied",
      () => {
        const refuse = () => {
          throw new DOMException("Access is denied.", "SecurityError");
        };
        Object.defineProperty(window, "localStorage", { get: refuse });
        Object.defineProperty(window, "indexedDB", { get: refuse });
      },
    ],
    [
      "full",
      () => {
        Storage.prototype.setItem = () => {
          throw new DOMException("The quota is exceeded.", "QuotaExceededError");
        };
      },
    ],
  ])("%s takes nothing away: what is chosen counts for the visit", async (_, fault) => {
    const { page, problems } = await hindered((page) => page.addInitScript(fault));
    await settled(page);
    await type(page, /^Segments/, "20");
    expect(await length(page)).toBe("75 cm");
    // The one thing that is kept there.
    await page.keyboard.press("Escape");
    await page.locator("#controls").focus();
    await page.keyboard.press("?");
    const single = page.getByRole("dialog").getByRole("checkbox");
    await single.uncheck();
    await page.keyboard.press("Escape");
    await page.locator("#controls").focus();
    await page.keyboard.press("m");
    await settled(page);
    expect(query(page).has("view")).toBe(false);
    expect(query(page).has("style")).toBe(false);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("wasm that", () => {
  const wasm = "**/bough*.wasm";

  /** A page whose wasm comes when it is sent. */
  async function withLateWasm() {
    let send = () => {};
    const late = new Promise<void>((resolve) => {
      send = resolve;
    });
    const opened = await hindered((page) =>
      page.route(wasm, async (route) => {
        await late;
        await route.continue();
      }),
    );
    return { ...opened, send };
  }

  it.each([
    [
      "form",
      async (page: Page) => {
        await box(page, /^Segments/).fill("20");
        await box(page, /^Segments/).press("Enter");
      },
      "75 cm",
    ],
    ["plates", (page: Page) => page.getByRole("button", { name: /^Figure 13 c/ }).click(), "1.5 m"],
  ])(
    "comes late leaves the %s to be used, and the plant that comes is what was chosen",
    async (what, choose, expected) => {
      const { page, problems, send } = await withLateWasm();
      await choose(page);
      expect(await page.evaluate(() => document.documentElement.dataset.settled)).not.toBe("true");
      send();
      await settled(page);
      expect(await length(page)).toBe(expected);
      expect(query(page).get(what === "form" ? "n" : "preset")).toBe(what === "form" ? "20" : "figure-13c");
      expect(problems).toEqual([]);
      await page.context().close();
    },
  );

  it("comes late leaves files to be dropped: a plant, and a photo, are taken when there is somebody who can", async () => {
    const { page, problems, send } = await withLateWasm();
    await page.locator("#controls").waitFor();
    await dropFile(page, "plant.json", "application/json", JSON.stringify({ axis: { segments: 20 } }));
    await dropFile(page, "broken.png", "image/png", [1, 2, 3]);
    send();
    await page.getByText("plant.json is open; Undo brings back what was there.").waitFor();
    await page.getByRole("alert").filter({ hasText: "broken.png cannot be read as a picture" }).waitFor();
    await settled(page);
    expect(await length(page)).toBe("75 cm");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("comes as another type of file works all the same", async () => {
    const { page, problems } = await hindered((page) =>
      page.route(wasm, async (route) => {
        const response = await route.fetch();
        await route.fulfill({ body: await response.body(), contentType: "text/plain" });
      }),
    );
    await settled(page);
    expect(await length(page)).toBe("1.5 m");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it.each([
    [
      "is a web page, as servers send it for what they do not have",
      "<!doctype html><title>Not found</title>",
    ],
    ["is cut off", "\0asm\u0001\0\0\0\u0001"],
    ["is empty", ""],
  ])("%s is said in a sentence; form and link stay", async (_, body) => {
    const fault = (page: Page) => page.route(wasm, (route) => route.fulfill({ body }));
    const { page } = await hindered(fault, "?preset=figure-13c&g=3");
    await page.getByText("The plant could not be computed.").waitFor();
    expect(await box(page, /^Gravity/).inputValue()).toBe("3");
    expect(query(page).get("g")).toBe("3");
    await page.context().close();
  });
});

describe("a network that is lost", () => {
  it("after the page has come takes only what is fetched later, and says so", async () => {
    const { page } = await visit(browser);
    await page.context().setOffline(true);
    await page.getByRole("button", { name: "All plates" }).click();
    await page.getByText("A part of the page could not be loaded: reload it.").first().waitFor();
    await type(page, /^Segments/, "20");
    expect(await length(page)).toBe("75 cm");
    await page.context().close();
  });
});

describe("a clock that", () => {
  /** What the page reads: the system's clock, which may be set, and the one that only goes on, as it does over a sleep. */
  const skewed = () => {
    let skew = 0;
    const [now, date, request] = [performance.now.bind(performance), Date.now, requestAnimationFrame];
    Object.assign(window, { skewClock: (by: number) => (skew += by) });
    Date.now = () => date() + skew;
    performance.now = () => now() + Math.max(0, skew);
    window.requestAnimationFrame = (callback) => request((time) => callback(time + Math.max(0, skew)));
  };

  it.each([
    ["jumps an hour on, as after a sleep,", 3_600_000],
    ["is set back an hour", -3_600_000],
  ])("%s while the plant grows leaves it full grown at the end", async (_, jump) => {
    const { page, problems } = await hindered((page) => page.addInitScript(skewed));
    await settled(page);
    const tip = await readTip(page);
    await page.getByRole("button", { name: "Watch it grow" }).click();
    await page.waitForFunction(() => Number(document.querySelector<HTMLInputElement>("#age")?.value) < 30);
    await page.evaluate((by) => Reflect.get(window, "skewClock")(by), jump);
    await settled(page);
    expect(await readTip(page)).toBe(tip);
    expect(query(page).has("step")).toBe(false);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
