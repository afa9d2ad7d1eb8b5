/** The age in steps and at speeds, and the loads taken off. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { Pixels } from "./pixels.ts";
import { placeOf, query, readTip, settled, slider, visit, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

const age = (page: Page) => slider(page, "Age").inputValue();

describe("the age", () => {
  it("goes by single steps, by buttons and by keys, and stops at both ends", async () => {
    const { page } = await visitUnpainted(browser, "?step=2");
    const younger = page.getByRole("button", { name: "One step younger" });
    const older = page.getByRole("button", { name: "One step older" });
    await older.click();
    await settled(page);
    expect([await age(page), query(page).get("step")]).toEqual(["3", "3"]);
    await page.locator("#controls").focus();
    await page.keyboard.press(",");
    await page.keyboard.press(",");
    await settled(page);
    expect(await age(page)).toBe("1");
    expect(await younger.isDisabled()).toBe(true);
    await page.keyboard.press(",");
    await settled(page);
    expect(await age(page)).toBe("1");
    await slider(page, "Age").press("End");
    await settled(page);
    expect(await older.isDisabled()).toBe(true);
    // Steps can be undone like everything.
    await page.goBack();
    await page.waitForFunction(() => location.search.includes("step=1"));
    await page.context().close();
  });

  it("is at rest when it is paused before the first step is over", async () => {
    const { page } = await visitUnpainted(browser, "?step=1");
    const play = page.locator("button.play");
    // By the page itself, as soon as it says that it plays: the age that is paused at is that of the link still.
    const said = await play.evaluate(async (button: HTMLElement) => {
      button.click();
      await new Promise((resolve) => setTimeout(resolve));
      const said = button.ariaLabel;
      button.click();
      return said;
    });
    expect(said).toBe("Pause");
    await settled(page);
    expect([await play.getAttribute("aria-label"), await age(page)]).toEqual(["Watch it grow", "1"]);
    await page.context().close();
  });

  it("is replayed at the speed that is chosen", async () => {
    const { page } = await visitUnpainted(browser);
    const rates: number[] = [];
    for (const speed of ["0.5", "4"]) {
      await page.getByRole("combobox", { name: "Speed" }).selectOption(speed);
      // By the page itself: on a slow machine the plant would be full grown before a pointer is there.
      const rate = await page.evaluate(async () => {
        const [play, age] = [".play", "#age"].map((one) => document.querySelector<HTMLInputElement>(one));
        const started = performance.now();
        play?.click();
        while (performance.now() - started < 400) await new Promise(requestAnimationFrame);
        const [steps, took] = [Number(age?.value), performance.now() - started];
        if (play?.ariaLabel === "Pause") play.click();
        return steps / took;
      });
      rates.push(rate);
      await settled(page);
      await slider(page, "Age").press("End");
      await settled(page);
    }
    // At 90 ms a step and speed 1: a step in 180 ms, and in 22, fewer where the machine is slow. Two more may be under way.
    expect(rates[0]).toBeLessThan(1 / 180 + 2 / 400);
    expect(rates[1]).toBeGreaterThan(2 * (rates[0] ?? 0));
    await page.context().close();
  });
});

describe("the loads", () => {
  it("are taken off: the plant rises through the shapes between, stays bent, and the link says so", async () => {
    const { page, problems } = await visitUnpainted(browser, "?preset=figure-17c&step=39", {
      reducedMotion: "no-preference",
    });
    const loaded = await readTip(page);
    const before = await page.evaluate(() => window.seen.drawn);
    const off = page.getByRole("switch", { name: "Take the loads off" });
    expect(await off.getAttribute("aria-checked")).toBe("false");
    await off.click();
    await page.waitForFunction(() => location.search.includes("rm=1"));
    await settled(page);
    expect(await off.getAttribute("aria-checked")).toBe("true");
    // At the least one between the first and the last, however slow the machine.
    expect(await page.evaluate((drawn) => window.seen.drawn - drawn, before)).toBeGreaterThan(2);
    const free = await readTip(page);
    const up = (text: string) => Number(/([\d.]+) cm up/.exec(text)?.[1]);
    expect(up(free)).toBeGreaterThan(up(loaded));
    // Straight at 50 degrees its tip would be 1.1 m up.
    expect(up(free)).toBeLessThan(105);
    await page.goBack();
    await page.waitForFunction(() => !location.search.includes("rm=1"));
    await settled(page);
    expect(await readTip(page)).toBe(loaded);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("are put on and off by a key, and the picture shows it", async () => {
    const { page } = await visit(browser, "?preset=figure-8d");
    await page.locator("#controls").focus();
    await page.keyboard.press("l");
    await settled(page);
    // Without memory it is straight again: there is wood at half of its length, in its first direction.
    const { x, y } = await placeOf(page, [0.482, 0.5745, 0]);
    expect((await Pixels.of(page)).wood(x, y, 3)).toBeGreaterThan(0.5);
    await page.keyboard.press("l");
    await settled(page);
    const old = await placeOf(page, [0.482, 0.5745, 0]);
    expect((await Pixels.of(page)).wood(old.x, old.y, 3)).toBe(0);
    await page.context().close();
  });
});
