/** axe finds nothing, in light and dark, wide and on a phone; the keyboard alone is enough. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { violations } from "./axe.ts";
import { launchChromium } from "./chromium.ts";
import { settled, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

describe("to axe", () => {
  // A sample; `npm run soak -- --only languages` looks at every state in light and dark, wide and on a phone.
  it.each([
    ["light", 1280, 800],
    ["dark", 390, 844],
  ] as const)(
    "in %s, at %d x %d, there is nothing, with everything open and something wrong",
    async (colorScheme, width, height) => {
      const viewport = { width, height };
      const { page } = await visitUnpainted(browser, "?preset=figure-8b&zz=1", {
        viewport,
        colorScheme,
        bypassCSP: true,
      });
      for (const summary of await page.locator("summary").all()) await summary.click();
      await page.getByRole("button", { name: "About Gravity" }).click();
      await page.getByRole("textbox", { name: /^Gravity/ }).fill("much");
      await page.getByRole("textbox", { name: /^Gravity/ }).press("Enter");
      await page.getByRole("alert").waitFor();
      await settled(page);
      expect(await violations(page)).toEqual([]);
      // Coloured, with its legend; held, with the force; and with each dialog open.
      await page.getByRole("combobox", { name: "Colour" }).selectOption("stress");
      await page.getByRole("button", { name: "Take hold of the tip" }).click();
      await page.locator(".pull data").waitFor({ state: "attached" });
      await settled(page);
      expect(await violations(page)).toEqual([]);
      for (const name of ["Keys", "All plates", "Take it away", "Embed"]) {
        await page.getByRole("button", { name, exact: true }).click();
        await page.getByRole("dialog", { name }).waitFor();
        expect(await violations(page)).toEqual([]);
        await page.keyboard.press("Escape");
      }
      await page.context().close();
    },
  );

  it("nothing sticks out sideways on a narrow phone", async () => {
    const { page } = await visitUnpainted(browser, "?preset=figure-8b", {
      viewport: { width: 320, height: 640 },
    });
    const overflow = await page.evaluate(() => {
      const panel = document.querySelector("#controls");
      return [document.documentElement, panel].map((element) =>
        element ? element.scrollWidth - element.clientWidth : Number.NaN,
      );
    });
    expect(overflow).toEqual([0, 0]);
    // Nor is any control of the view cut off.
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll(".view button, .view select, .view input[type=range]")].flatMap(
        (control) => {
          const { left, right, width } = control.getBoundingClientRect();
          return width > 0 && (left < 0 || right > innerWidth) ? [control.outerHTML.slice(0, 80)] : [];
        },
      ),
    );
    expect(cut).toEqual([]);
    await page.context().close();
  });
});

describe("by keyboard alone", () => {
  /** What has the focus, as a person would name it. */
  const focused = (page: Page) =>
    page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return "";
      const [label] = (element as HTMLInputElement).labels ?? [];
      const text = element.getAttribute("aria-label") ?? label?.textContent ?? element.textContent;
      return (text ?? "").replace(/\s+/g, " ").trim();
    });

  /** Presses Tab until something has the focus; nothing else would lead a person there. */
  async function tabTo(page: Page, name: string): Promise<void> {
    const passed: string[] = [];
    for (let press = 0; press < 120; press++) {
      await page.keyboard.press("Tab");
      const present = await focused(page);
      if (present.startsWith(name)) return;
      passed.push(present.slice(0, 40));
    }
    throw new Error(`Tab does not lead to ${name}: ${passed.join(" | ")}.`);
  }

  /** Presses an arrow until the plate of this name has the focus. */
  async function arrowTo(page: Page, arrow: string, name: string): Promise<void> {
    for (let press = 0; press < 30 && !(await focused(page)).startsWith(name); press++) {
      await page.keyboard.press(arrow);
    }
    expect(await focused(page)).toContain(name);
  }

  it("all plates are one stop, in the strip and in the gallery; arrows, Home and End go between them", async () => {
    const { page } = await visitUnpainted(browser, "?preset=figure-8d");
    const stops = (selector: string) =>
      page.evaluate(
        (selector) =>
          [...document.querySelectorAll<HTMLElement>(selector)]
            .filter(({ tabIndex }) => tabIndex >= 0)
            .map((plate) => (plate.textContent ?? "").trim().replace(/\s+/g, " ").slice(0, 10)),
        selector,
      );
    expect(await stops(".gallery .plate")).toEqual(["Figure 8 d"]);
    await tabTo(page, "Figure 8 d");
    for (const [key, name] of [
      ["ArrowRight", "Figure 10"],
      ["ArrowLeft", "Figure 8 d"],
      ["Home", "Default"],
      ["ArrowLeft", "Default"],
      ["End", "A snowdrop"],
    ] as const) {
      await page.keyboard.press(key);
      expect(await focused(page)).toContain(name);
    }
    // Tab leaves all of them, and comes back to the one that was left.
    await page.keyboard.press("Tab");
    expect(await page.evaluate(() => document.activeElement?.closest(".plates"))).toBeNull();
    await page.keyboard.press("Shift+Tab");
    expect(await focused(page)).toContain("A snowdrop");
    // Whatever plate is chosen, by whatever means, is the stop.
    await page.keyboard.press("Enter");
    await settled(page);
    await page.goBack();
    await page.waitForFunction(() => location.search.includes("figure-8d"));
    await settled(page);
    expect(await stops(".gallery .plate")).toEqual(["Figure 8 d"]);
    await page.keyboard.press("g");
    await page.getByRole("dialog", { name: "All plates" }).waitFor();
    expect(await stops("dialog .plate")).toEqual(["Figure 8 d"]);
    // Up and down go to the plate that is nearest in the next row.
    await page.keyboard.press("ArrowUp");
    expect(await focused(page)).toMatch(/^Figure 2/);
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    expect(await focused(page)).toMatch(/^Figure 1[03]/);
    await page.context().close();
  });

  it("a person goes through the whole page", async () => {
    const { page, problems } = await visitUnpainted(browser);
    const parameter = (key: string) => new URL(page.url()).searchParams.get(key);
    // Past everything to the controls: a slider, and its box.
    await tabTo(page, "Skip to the controls");
    await page.keyboard.press("Enter");
    expect(await page.evaluate(() => document.activeElement?.id)).toBe("controls");
    await tabTo(page, "Elevation, slider");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Tab");
    expect(await page.evaluate(() => document.activeElement?.id)).toBe("axis-elevation");
    await page.keyboard.press("ArrowUp");
    await settled(page);
    expect(parameter("e")).toBe("52");
    // A value typed, one refused and corrected, one explained, one reset.
    await tabTo(page, "Segments");
    await tabTo(page, "Segments");
    await page.keyboard.press("ControlOrMeta+a");
    await page.keyboard.type("many");
    await page.keyboard.press("Enter");
    await page.getByRole("alert").waitFor();
    await page.keyboard.press("ControlOrMeta+a");
    await page.keyboard.type("30");
    await page.keyboard.press("Enter");
    await settled(page);
    expect(parameter("n")).toBe("30");
    await tabTo(page, "About Segment length");
    await page.keyboard.press("Enter");
    await page.locator("#axis-segmentLength-help math").waitFor();
    // A group opened, and a choice in it.
    await tabTo(page, "Thickening");
    await page.keyboard.press("Enter");
    await tabTo(page, "None");
    await page.keyboard.press("ArrowDown");
    await settled(page);
    expect(parameter("th")).toBe("pipes");
    // From the top: undo, the list of keys, colour, style, view.
    await page.keyboard.press("Control+z");
    await page.waitForFunction(() => !location.search.includes("th="));
    await tabTo(page, "Keys");
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: "Keys" }).waitFor();
    await page.keyboard.press("Escape");
    expect(await focused(page)).toBe("Keys");
    await tabTo(page, "The plant");
    // The picture has the focus: the tip is taken, pulled, and let go of.
    await page.keyboard.press("Enter");
    await page.keyboard.press("ArrowDown");
    await page.locator(".pull data").waitFor();
    await page.keyboard.press("Escape");
    await settled(page);
    await tabTo(page, "Colour");
    await page.keyboard.press("ArrowDown");
    await settled(page);
    expect(parameter("color")).toBe("moment");
    await tabTo(page, "Limbs");
    await page.keyboard.press("ArrowRight");
    await tabTo(page, "Plane");
    await page.keyboard.press("ArrowRight");
    await settled(page);
    expect([parameter("style"), parameter("view")]).toEqual(["model", "space"]);
    // The age, and the loads.
    await tabTo(page, "One step younger");
    await page.keyboard.press("Enter");
    await settled(page);
    expect(parameter("step")).toBe("29");
    await tabTo(page, "Take the loads off");
    await page.keyboard.press(" ");
    await settled(page);
    expect(parameter("rm")).toBe("1");
    // The gallery, and a plate in it.
    await tabTo(page, "All plates");
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: "All plates" }).waitFor();
    expect(await focused(page)).toContain("Default");
    await arrowTo(page, "ArrowRight", "Figure 13 c");
    await page.keyboard.press("Enter");
    await settled(page);
    expect(parameter("preset")).toBe("figure-13c");
    // The same in the strip beside the picture, and the snippet for another page.
    await tabTo(page, "Figure 13 c");
    await arrowTo(page, "ArrowLeft", "Figure 8 d");
    await page.keyboard.press(" ");
    await settled(page);
    expect(parameter("preset")).toBe("figure-8d");
    await tabTo(page, "Embed");
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: "Embed" }).waitFor();
    await tabTo(page, "Paste this as HTML");
    await page.keyboard.press("Escape");
    expect(await focused(page)).toBe("Embed");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("every control that has the focus shows it", async () => {
    const { page } = await visitUnpainted(browser);
    const unmarked = new Set<string>();
    for (let press = 0; press < 40; press++) {
      await page.keyboard.press("Tab");
      const found = await page.evaluate(() => {
        const focused = document.activeElement;
        if (!focused || focused === document.body) return "";
        const marks = [focused, focused.nextElementSibling, focused.parentElement].flatMap((element) => {
          if (!element) return [];
          const { outlineStyle, outlineWidth } = getComputedStyle(element);
          return outlineStyle !== "none" && outlineWidth !== "0px" ? [element] : [];
        });
        return marks.length > 0 ? "" : focused.outerHTML.slice(0, 120);
      });
      if (found) unmarked.add(found);
    }
    expect([...unmarked]).toEqual([]);
    await page.context().close();
  });
});
