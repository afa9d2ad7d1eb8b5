/** How the widget behaves in a page that is not its own: by real input, and by what it leaves alone. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "../browser/chromium.ts";
import { Pixels } from "../browser/pixels.ts";
import { contextsOf, drawn, type Host, open, openHost } from "./host.ts";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let browser: Browser;
let host: Host;

beforeAll(async () => {
  browser = await launchChromium();
  host = await openHost();
});
afterAll(async () => {
  await browser.close();
  host.close();
});

/** A page of text around one or more plants. */
async function visit(plants: string, options: BrowserContextOptions = {}, more = "") {
  const html = `<html lang="en"><head><title>Notes on botany</title>
    <meta name="viewport" content="width=device-width"><script src="bough-widget.js" defer></script>
    <style>html { background: Canvas } main { height: 3000px } bough-plant { width: 360px }</style>${more}</head>
    <body><main><h1>Notes</h1><a href="#before">before</a>
    ${plants}
    <a href="#after">after</a></main></body></html>`;
  const guest = await open(browser, host.page(html), options);
  await drawn(guest.page, "bough-plant >> nth=0");
  return guest;
}

const plain = `<bough-plant preset="figure-13a" controls="none"></bough-plant>`;

async function middle(page: Page): Promise<{ x: number; y: number }> {
  const box = await page.locator("bough-plant").first().boundingBox();
  if (!box) throw new Error("There is no plant.");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

const scrolled = (page: Page) => page.evaluate(() => scrollY);
const picture = (page: Page) => page.locator("bough-plant").first().screenshot();
/** The picture once it stands still: fonts and the legend come after the plant. */
async function stillPicture(page: Page) {
  let last = await picture(page);
  await expect
    .poll(async () => {
      const before = last;
      await page.evaluate(() => new Promise((done) => setTimeout(done, 200)));
      last = await picture(page);
      return last.equals(before);
    })
    .toBe(true);
  return last;
}
/** Where the focus is, in the shadow tree too. */
const focused = (page: Page) =>
  page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    return (
      element?.textContent?.trim() || element?.getAttribute("aria-label") || element?.getAttribute("type")
    );
  });

describe("wheel, touch and Tab", () => {
  it("the wheel scrolls the page, and zooms only once the plant was clicked", async () => {
    const { page } = await visit(plain);
    const { x, y } = await middle(page);
    const before = await stillPicture(page);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, 200);
    await expect.poll(() => scrolled(page)).toBe(200);
    await page.mouse.wheel(0, -200);
    await expect.poll(() => scrolled(page)).toBe(0);
    await page.mouse.move(5, 5);
    // The hint goes with the pointer; the picture is as it was.
    await expect.poll(async () => (await picture(page)).equals(before)).toBe(true);
    await page.mouse.click(x, y);
    await page.mouse.wheel(0, 200);
    await expect.poll(async () => (await picture(page)).equals(before)).toBe(false);
    expect(await scrolled(page)).toBe(0);
    // A click elsewhere gives the wheel back.
    await page.mouse.click(600, 500);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, 200);
    await expect.poll(() => scrolled(page)).toBe(200);
    await page.context().close();
  });

  /** A finger goes up over the picture. */
  async function swipe(page: Page): Promise<void> {
    const { x, y } = await middle(page);
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", at?: number) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: at === undefined ? [] : [{ x, y: at }] });
    await touch("touchStart", y + 60);
    for (let step = 1; step <= 8; step++) await touch("touchMove", y + 60 - 15 * step);
    await touch("touchEnd");
  }

  it("a touch pans the page, and after a tap the plant, until that is done", async () => {
    const phone = { hasTouch: true, isMobile: true, viewport: { width: 390, height: 700 } };
    const untouched = await visit(plain, phone);
    await swipe(untouched.page);
    await expect.poll(() => scrolled(untouched.page)).toBeGreaterThan(50);
    await untouched.page.context().close();
    const { page } = await visit(plain, phone);
    const before = await stillPicture(page);
    const { x, y } = await middle(page);
    await page.touchscreen.tap(x, y);
    await page.getByRole("button", { name: "Done" }).waitFor();
    await swipe(page);
    await expect.poll(async () => (await picture(page)).equals(before)).toBe(false);
    expect(await scrolled(page)).toBe(0);
    // Chromium takes a tap right after a swipe for the end of a fling, and keeps it; a person taps again.
    const done = page.getByRole("button", { name: "Done" });
    await expect
      .poll(async () => {
        if (await done.isVisible()) await done.tap();
        return done.isVisible();
      })
      .toBe(false);
    // What a finger may do where reaches the browser's compositor with the next frame.
    await expect
      .poll(async () => {
        await swipe(page);
        return scrolled(page);
      })
      .toBeGreaterThan(50);
    await page.context().close();
  });

  it("Tab goes in and out, Enter hands the picture over, Escape gives it back", async () => {
    const { page } = await visit(`<bough-plant controls="compact"></bough-plant>`);
    await page.getByText("before").focus();
    const stops: (string | null | undefined)[] = [];
    for (let k = 0; k < 6; k++) {
      await page.keyboard.press("Tab");
      stops.push(await focused(page));
    }
    expect(stops).toEqual(["Move and zoom", "Watch it grow", "range", "range", "range", "after"]);
    await page.getByText("before").focus();
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    expect(await focused(page)).toContain("The plant.");
    const before = await stillPicture(page);
    await page.keyboard.press("ArrowLeft");
    await expect.poll(async () => (await picture(page)).equals(before)).toBe(false);
    expect(await scrolled(page)).toBe(0);
    await page.keyboard.press("Escape");
    expect(await focused(page)).toBe("Move and zoom");
    await page.keyboard.press("Shift+Tab");
    expect(await focused(page)).toBe("before");
    await page.context().close();
  });

  it("the sliders and the button work by keys", async () => {
    const { page } = await visit(`<bough-plant controls="full"></bough-plant>`);
    await page.getByRole("slider", { name: "Elevation" }).first().focus();
    await page.keyboard.press("ArrowLeft");
    await page.getByRole("slider", { name: "Age" }).focus();
    await page.keyboard.press("Home");
    const link = () =>
      page.locator("bough-plant").evaluate((plant: HTMLElementTagNameMap["bough-plant"]) => plant.link);
    await expect.poll(link).toMatch(/e=4\d.*step=1/);
    await page.getByText("Direction of growth").click();
    await page.getByRole("slider", { name: "Strength" }).focus();
    await page.keyboard.press("End");
    await expect.poll(link).toContain("k=");
    await page.getByRole("button", { name: "Reset all" }).click();
    await expect.poll(link).toBe("?v=1&step=1");
    await page.context().close();
  });
});

describe("axe finds nothing wrong with a page that has plants in it", () => {
  const plants = `<bough-plant preset="figure-13a"><span slot="caption">A shoot</span></bough-plant>
    <bough-plant preset="figure-8a" controls="none" color="moment"></bough-plant>
    <bough-plant controls="full" color="stress"></bough-plant>
    <bough-plant loading="click" poster="presets/figure-8a.webp" alt="A rod that bends"></bough-plant>
    <bough-plant preset="nothing"></bough-plant>`;

  it.each([
    ["light", { colorScheme: "light" as const }, `<meta name="color-scheme" content="light dark">`],
    ["dark", { colorScheme: "dark" as const }, `<meta name="color-scheme" content="light dark">`],
    ["on a phone", { viewport: { width: 390, height: 844 } }, ""],
  ])("%s", { timeout: 120_000 }, async (_, options, more) => {
    const { page } = await visit(plants, options, more);
    await page.locator("bough-plant").last().scrollIntoViewIfNeeded();
    await page.getByText("There is no preset nothing").waitFor();
    for (const index of [1, 2]) await drawn(page, `bough-plant >> nth=${index}`);
    await page.addScriptTag({ content: axe });
    const found = await page.evaluate(async () => {
      const run = Reflect.get(window, "axe").run as (on: Document) => Promise<{
        violations: { id: string; nodes: { html: string; failureSummary: string }[] }[];
      }>;
      const { violations } = await run(document);
      return violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map((node) => node.html + node.failureSummary).join()}`,
      );
    });
    expect(found).toEqual([]);
    await page.context().close();
  });
});

describe("a good guest", () => {
  it("leaves no globals, no styles and no attributes in the page", async () => {
    const bare = await open(browser, host.page("<title>Bare</title>"));
    const names = (page: Page) => page.evaluate(() => Object.getOwnPropertyNames(window));
    const usual = await names(bare.page);
    const { page, problems } = await visit(
      plain,
      {},
      "<style>p, button { color: red; font-size: 40px }</style>",
    );
    expect((await names(page)).filter((name) => !usual.includes(name))).toEqual([]);
    const left = await page.evaluate(() => ({
      sheets: document.styleSheets.length + document.adoptedStyleSheets.length,
      html: document.documentElement.getAttributeNames(),
      body: document.body.getAttributeNames(),
      children: document.body.children.length,
      button: getComputedStyle(
        document.querySelector("bough-plant")?.shadowRoot?.querySelector("button") as Element,
      ).fontSize,
    }));
    expect(left).toEqual({ sheets: 2, html: ["lang"], body: [], children: 1, button: "14px" });
    expect(problems, "and asks nobody else for anything").toEqual([]);
    await bare.page.context().close();
    await page.context().close();
  });

  it("two copies live on one page under two tags; the first definition of a tag wins", async () => {
    const { page, problems } = await visit(
      `${plain}<other-plant preset="figure-8a" controls="none" style="width: 360px"></other-plant>`,
      {},
      `<script src="bough-widget.js?tag=other-plant" defer></script><script src="bough-widget.js?again" defer></script>`,
    );
    await drawn(page, "other-plant");
    const { x, y } = await middle(page);
    expect((await Pixels.of(page)).wood(x, y, 100)).toBeGreaterThan(0.005);
    expect((await contextsOf(page)).alive, "each copy has a press of its own").toBe(2);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("the module does the same, and before it is wanted loads next to nothing", async () => {
    const html = `<html lang="en"><title>Module</title><script type="module" src="bough-plant.js?tag=my-plant"></script>
      <my-plant loading="click" style="width: 360px"></my-plant></html>`;
    const { page, problems } = await open(browser, host.page(html));
    await page.getByRole("button", { name: "Show the plant" }).waitFor();
    expect(host.asked.filter((path) => /wasm|widget/.test(path))).toEqual([]);
    const from = performance.now();
    await page.getByRole("button", { name: "Show the plant" }).click();
    await drawn(page, "my-plant");
    console.log(`from activation to the first picture: ${Math.round(performance.now() - from)} ms`);
    expect(host.asked.some((path) => path.endsWith(".wasm"))).toBe(true);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("is as dark as the page around, not as the reader's system", async () => {
    const brightness = async (page: Page) => {
      const box = await page.locator("bough-plant").boundingBox();
      const [red] = (await Pixels.of(page)).at((box?.x ?? 0) + 8, (box?.y ?? 0) + 60);
      return red;
    };
    const undecided = await visit(plain, { colorScheme: "dark" });
    expect(await brightness(undecided.page), "a page that knows no dark stays light").toBeGreaterThan(200);
    await undecided.page.context().close();
    const { page } = await visit(
      plain,
      { colorScheme: "dark" },
      `<meta name="color-scheme" content="light dark">`,
    );
    expect(await brightness(page)).toBeLessThan(80);
    // A page with a switch of its own: the drawing follows, not only the paper.
    const before = await page
      .locator("bough-plant")
      .evaluate((plant: HTMLElementTagNameMap["bough-plant"]) => {
        document.documentElement.style.colorScheme = "light";
        return plant.shadowRoot?.querySelector("canvas")?.toDataURL();
      });
    await expect.poll(() => brightness(page)).toBeGreaterThan(200);
    await expect
      .poll(() =>
        page
          .locator("bough-plant")
          .evaluate((plant) => plant.shadowRoot?.querySelector("canvas")?.toDataURL()),
      )
      .not.toBe(before);
    await page.context().close();
  });

  it("fits a page that is written from right to left", async () => {
    const { page } = await visit(`<div dir="rtl"><bough-plant controls="compact"></bough-plant></div>`);
    const places = await page.locator("bough-plant").evaluate((plant) => {
      const at = (selector: string) => plant.shadowRoot?.querySelector(selector)?.getBoundingClientRect();
      const [frame, play, length] = [plant.getBoundingClientRect(), at(".play"), at(".length")];
      return {
        frame: frame.left,
        playFromRight: frame.right - (play?.right ?? 0),
        length: length?.left ?? 0,
        reading: getComputedStyle(plant.shadowRoot?.querySelector(".dials output") as Element).direction,
      };
    });
    expect(places.playFromRight).toBeLessThan(30);
    expect(places.reading, "9.81 m/s², not m/s² 9.81").toBe("ltr");
    expect(places.length - places.frame, "the drawing is not mirrored").toBeLessThan(40);
    await page.context().close();
  });

  it("moves nothing where motion is unwelcome, and nothing by itself where it is welcome", async () => {
    for (const reducedMotion of ["reduce", "no-preference"] as const) {
      const { page } = await visit(plain, { reducedMotion });
      const steps = await page
        .locator("bough-plant")
        .evaluate(async (plant: HTMLElementTagNameMap["bough-plant"]) => {
          let changes = 0;
          plant.addEventListener("bough-change", () => changes++);
          for (let frame = 0; frame < 20; frame++) await new Promise(requestAnimationFrame);
          return changes;
        });
      expect(steps).toBe(0);
      await page.context().close();
    }
  });

  it("prints its picture, and its poster where there is none yet", async () => {
    const { page } = await visit(
      `${plain}<bough-plant loading="click" poster="presets/figure-8a.webp"></bough-plant>`,
    );
    await page.emulateMedia({ media: "print" });
    const pixels = await Pixels.of(page);
    for (const index of [0, 1]) {
      const box = await page.locator("bough-plant").nth(index).boundingBox();
      if (!box) throw new Error("There is no plant.");
      expect(pixels.wood(box.x + box.width / 2, box.y + box.height / 2, 100)).toBeGreaterThan(0.005);
    }
    expect(await page.getByRole("button").count(), "and no buttons").toBe(0);
    await page.context().close();
  });

  it("is read rightly by a page that does not say its encoding", async () => {
    const { page } = await visit(`<bough-plant preset="figure-13a" alt=""></bough-plant>`);
    expect(await page.evaluate(() => document.characterSet)).toBe("windows-1252");
    const angle = await page
      .locator("bough-plant")
      .evaluate((plant) => plant.shadowRoot?.querySelector(".angle")?.textContent);
    expect(angle).toBe("45\u00b0");
    await page.context().close();
  });
});
