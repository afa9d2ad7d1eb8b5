/** `<bough-plant>` as authors meet it: attributes, properties, events, methods. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { BoughPlantElement } from "../../web/src/element/element.ts";
import { launchChromium } from "../browser/chromium.ts";
import { Pixels } from "../browser/pixels.ts";
import { drawn, type Host, open, openHost } from "./host.ts";

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

const script = `<script src="bough-widget.js" defer></script>`;

/** Opens a page with some HTML in it, the script included. */
async function show(html: string, options = {}) {
  const page = `<html lang="en"><title>A page with a plant</title>${script}<main>${html}</main></html>`;
  return open(browser, host.page(page), options);
}

/** Does something with the one element of the page. */
function on<Result>(
  page: Page,
  work: (plant: BoughPlantElement) => Result | Promise<Result>,
): Promise<Result> {
  return page.locator("bough-plant").evaluate(work as (plant: Element) => Result);
}

/** The share of wood in the middle of the element. */
async function woodIn(page: Page): Promise<number> {
  const box = await page.locator("bough-plant").boundingBox();
  if (!box) throw new Error("The element is not on the page.");
  const pixels = await Pixels.of(page);
  return pixels.wood(box.x + box.width / 2, box.y + box.height / 2, Math.floor(box.height / 2) - 2);
}

const narrow = `style="width: 480px"`;

describe("an element in a bare page", () => {
  it("shows its plant, and says when it is there", async () => {
    const { page, problems } = await show(
      `<bough-plant preset="figure-13a" controls="none" ${narrow}></bough-plant>`,
    );
    await drawn(page);
    expect(await woodIn(page)).toBeGreaterThan(0.005);
    const found = await on(page, ({ plant, params, step, link, preset }) => ({
      status: plant?.report.status,
      tropism: (params as { tropism: { strength: number } }).tropism.strength > 0,
      step,
      link,
      preset,
    }));
    expect(found).toEqual({
      status: "converged",
      tropism: true,
      step: 13,
      link: "?v=1&preset=figure-13a",
      preset: "figure-13a",
    });
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("takes every attribute", async () => {
    const { page } = await show(
      `<bough-plant preset="figure-8a" params='{"loads":{"gravity":3}}' step="4" view="space" color="moment"
        drawing="model" theme="dark" controls="full" alt="A rod" ${narrow}></bough-plant>`,
    );
    await drawn(page);
    expect(await on(page, ({ link }) => link)).toBe(
      "?v=1&preset=figure-8a&g=3&step=4&view=space&color=moment&style=model&theme=dark",
    );
    expect(await page.getByRole("img", { name: "A rod" }).count()).toBe(1);
    await page.getByText("Bending moment").waitFor();
    const box = await page.locator("bough-plant").boundingBox();
    const [red] = (await Pixels.of(page)).at((box?.x ?? 0) + 20, (box?.y ?? 0) + 120);
    expect(red, "dark paper").toBeLessThan(80);
    await page.context().close();
  });

  it("has the controls that its author names, in that order, and others when they are changed", async () => {
    const { page } = await show(
      `<bough-plant fields="tropism.strength loads.gravity growth.thickening" ${narrow}></bough-plant>`,
    );
    await drawn(page);
    const labels = () =>
      on(page, ({ shadowRoot }) =>
        [...(shadowRoot?.querySelectorAll<HTMLElement>(".dial") ?? [])]
          .filter((dial) => dial.offsetWidth > 0)
          .map((dial) => dial.firstElementChild?.textContent),
      );
    expect(await labels()).toEqual(["Age", "Tropism strength", "Gravity", "Thickening"]);
    await page.getByRole("slider", { name: "Gravity" }).fill("2");
    await page.waitForFunction(() => document.querySelector("bough-plant")?.link === "?v=1&g=2");
    await on(page, async (plant) => {
      plant.fields = "axis.segments";
      await plant.settled();
    });
    expect(await labels()).toEqual(["Age", "Segments"]);
    // Only one age: nothing to choose, nothing to watch.
    await page.getByRole("slider", { name: "Segments" }).fill("1");
    await page.getByRole("button", { name: "Watch it grow" }).waitFor({ state: "hidden" });
    expect(await labels()).toEqual(["Segments"]);
    await on(page, async (plant) => {
      plant.fields = null;
      await plant.settled();
    });
    expect(await labels()).toEqual(["Elevation", "Gravity"]);
    await page.context().close();
  });

  it.each([
    ["lies between the steps of its slider", "arrangement.divergence", "Divergence", "?v=1"],
    ["lies past the end of its slider", "tropism.strength", "Tropism strength", "?v=1&tk=1000000"],
  ])("a value that %s is had again by a reader who goes back", async (_, path, name, link) => {
    const { page } = await show(`<bough-plant link="${link}" fields="${path}" ${narrow}></bough-plant>`);
    await drawn(page);
    const slider = page.getByRole("slider", { name });
    const value = () => slider.getAttribute("aria-valuetext");
    const first = await value();
    await slider.press("ArrowLeft");
    await page.waitForFunction((link) => document.querySelector("bough-plant")?.link !== link, link);
    expect(await value()).not.toBe(first);
    await slider.press("ArrowRight");
    await page.waitForFunction((link) => document.querySelector("bough-plant")?.link === link, link);
    expect(await value()).toBe(first);
    await page.context().close();
  });

  it("prints its picture without the controls, also once they are there", async () => {
    const { page } = await show(`<bough-plant ${narrow}></bough-plant>`);
    await drawn(page);
    const gravity = page.getByRole("slider", { name: "Gravity" });
    expect(await gravity.isVisible()).toBe(true);
    await page.emulateMedia({ media: "print" });
    expect(await gravity.isVisible()).toBe(false);
    expect(await page.locator("canvas.picture").isVisible()).toBe(true);
    // What is written over the picture shrinks with it where paper has less room, and no script runs in between.
    const corners = await page.locator("canvas.picture").evaluate((canvas: HTMLCanvasElement) => {
      const scene = canvas.parentElement as HTMLElement;
      const arc = () => {
        const whole = canvas.getBoundingClientRect();
        const box = scene.querySelector(".elevation-arc")?.getBoundingClientRect() ?? new DOMRect();
        return [(box.x - whole.x) / whole.width, (box.bottom - whole.y) / whole.height];
      };
      const before = arc();
      Object.assign(scene.style, { width: "50%", height: "50%" });
      return [before, arc()];
    });
    expect(corners[1]?.[0]).toBeCloseTo(corners[0]?.[0] ?? Number.NaN, 2);
    expect(corners[1]?.[1]).toBeCloseTo(corners[0]?.[1] ?? Number.NaN, 2);
    await page.context().close();
  });

  it("takes a link of the page instead", async () => {
    const { page } = await show(
      `<bough-plant link="https://example.org/bough/?v=1&preset=figure-13a&g=4&step=9&color=age#top"></bough-plant>`,
    );
    await drawn(page);
    expect(await on(page, ({ link }) => link)).toBe("?v=1&preset=figure-13a&g=4&step=9&color=age");
    await page.context().close();
  });

  it("takes properties that were set before it was defined", async () => {
    const late = `<html lang="en"><title>Late</title><bough-plant></bough-plant><script>
      const plant = document.querySelector("bough-plant");
      plant.preset = "figure-13a";
      plant.params = { loads: { gravity: 2 } };
      plant.step = 7;
      const script = document.createElement("script");
      script.src = "bough-widget.js";
      document.head.append(script);
    </script></html>`;
    const { page, problems } = await open(browser, host.page(late));
    await page.waitForFunction(() => customElements.get("bough-plant") !== undefined);
    await drawn(page);
    expect(await on(page, ({ link }) => link)).toBe("?v=1&preset=figure-13a&g=2&step=7");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("follows changes, one event for all of a task", async () => {
    const { page } = await show(`<bough-plant></bough-plant>`);
    await drawn(page);
    const events = await on(page, async (plant) => {
      const heard: (number | null)[] = [];
      plant.addEventListener("bough-change", ({ detail }) => heard.push(detail.step));
      plant.params = { axis: { segments: 20 } };
      plant.view = "space";
      plant.step = 5;
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
      return heard;
    });
    expect(events).toEqual([5]);
    expect(await on(page, ({ link }) => link)).toBe("?v=1&n=20&step=5&view=space");
    const reset = await on(page, async (plant) => {
      plant.params = null;
      plant.step = null;
      plant.setAttribute("view", "plane");
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
      return plant.link;
    });
    expect(reset).toBe("?v=1");
    await page.context().close();
  });

  it("plays its growth when it is told to, and stops", async () => {
    const { page } = await show(`<bough-plant></bough-plant>`);
    await drawn(page);
    const steps = await on(page, async (plant) => {
      const heard: number[] = [];
      await new Promise<void>((resolve) => {
        plant.addEventListener("bough-change", ({ detail }) => {
          heard.push(detail.plant.report.steps);
          if (heard.length === 3) resolve();
        });
        void plant.play();
      });
      plant.pause();
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
      return [...heard, plant.step];
    });
    expect(steps[0]).toBeLessThan(5);
    expect(steps.at(-1), "it stays at the age it had reached").toBe(steps.at(-2));
    await page.context().close();
  });

  it("gives its picture as a PNG", async () => {
    const { page } = await show(`<div style="height: 3000px"></div><bough-plant ${narrow}></bough-plant>`);
    const found = await on(page, async (plant) => {
      const blob = await plant.toBlob();
      const image = await createImageBitmap(blob);
      const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
      pen?.drawImage(image, 0, 0);
      const { data } = pen?.getImageData(0, 0, image.width, image.height) ?? { data: [] };
      let opaque = 0;
      for (let at = 3; at < data.length; at += 4) if (data[at] === 255) opaque++;
      return { type: blob.type, width: image.width, opaque };
    });
    expect(found.type).toBe("image/png");
    expect(found.width).toBe(478);
    expect(found.opaque, "even out of view").toBeGreaterThan(500);
    await page.context().close();
  });

  it("stays what it is when it is moved in the page, and goes on after it was away", async () => {
    const { page, problems } = await show(`<bough-plant ${narrow}></bough-plant><section></section>`);
    await drawn(page);
    const moved = await on(page, async (plant) => {
      const { plant: before } = plant;
      plant.params = { loads: { gravity: 2 } };
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
      const canvas = plant.shadowRoot?.querySelector("canvas");
      document.querySelector("section")?.append(plant);
      await new Promise(requestAnimationFrame);
      return { isNew: before !== plant.plant, isSame: canvas === plant.shadowRoot?.querySelector("canvas") };
    });
    expect(moved).toEqual({ isNew: true, isSame: true });
    await page.evaluate(async () => {
      const plant = document.querySelector("bough-plant");
      plant?.remove();
      await new Promise(requestAnimationFrame);
      if (plant?.plant !== null) throw new Error("It still holds a plant.");
      if (plant) document.querySelector("main")?.append(plant);
    });
    await drawn(page);
    expect(await on(page, ({ link }) => link)).toBe("?v=1&g=2");
    expect(await woodIn(page)).toBeGreaterThan(0.005);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("what cannot be shown", () => {
  const good = { preset: "figure-13a", controls: "none" };
  let page: Page;
  beforeAll(async () => {
    const { preset, controls } = good;
    const shown = await show(
      `<bough-plant preset="${preset}" controls="${controls}" ${narrow}></bough-plant>`,
    );
    page = shown.page;
    await drawn(page);
  });
  afterAll(() => page.context().close());

  /** What the element says of bad attributes while it shows a good plant; afterwards it has the good ones again. */
  async function refusal(bad: Readonly<Record<string, string>>) {
    const detail = await page.locator("bough-plant").evaluate(async (element, bad) => {
      const plant = element as BoughPlantElement;
      const told = new Promise<HTMLElementEventMap["bough-error"]>((resolve) =>
        plant.addEventListener("bough-error", resolve, { once: true }),
      );
      for (const [name, value] of Object.entries(bad)) plant.setAttribute(name, value);
      const { detail } = await told;
      return {
        ...detail,
        link: plant.link,
        said: plant.shadowRoot?.querySelector("[role=status]")?.textContent,
      };
    }, bad);
    await drawn(page);
    expect(await woodIn(page), "the last good plant stays").toBeGreaterThan(0.005);
    await page.locator("bough-plant").evaluate(
      async (element, { names, good }) => {
        for (const name of names) element.removeAttribute(name);
        for (const [name, value] of Object.entries(good)) element.setAttribute(name, value);
        await (element as BoughPlantElement).settled();
      },
      { names: Object.keys(bad), good },
    );
    return detail;
  }

  it.each([
    [{ params: "{gravity: 3}" }, "unreadable", "params"],
    [{ params: '{"loads":{"gravity":-1}}' }, "outOfRange", "loads.gravity"],
    [{ params: '{"loads":{"gravity":"much"}}' }, "wrongType", "loads.gravity"],
    [{ params: '{"leaves":1}' }, "unknownKey", "leaves"],
    [{ params: "[]" }, "wrongType", ""],
    [{ preset: "figure-99" }, "notAnOption", "preset"],
    [{ view: "above" }, "notAnOption", "view"],
    [{ color: "red" }, "notAnOption", "color"],
    [{ drawing: "sketch" }, "notAnOption", "drawing"],
    [{ theme: "sepia" }, "notAnOption", "theme"],
    [{ controls: "many" }, "notAnOption", "controls"],
    [{ fields: "loads.gravity loads.weight" }, "notAnOption", "fields"],
    [{ step: "last" }, "outOfRange", "step"],
  ])("%j is told as %s of %s, in an event and a sentence", async (bad, code, path) => {
    const { issues, message, said, link } = await refusal(bad);
    expect(issues).toHaveLength(1);
    expect(issues[0]).toMatchObject({ code, path });
    expect(said).toBe(message);
    expect(message).toContain(issues[0]?.message);
    expect(link).toBe("?v=1&preset=figure-13a");
  });

  it("lists all that is wrong at once", async () => {
    const { issues } = await refusal({
      preset: "figure-13",
      params: '{"axis":{"segments":0}}',
      view: "above",
    });
    expect(issues.map(({ path }) => path).sort()).toEqual(["axis.segments", "preset", "view"]);
  });

  it("is forgotten with the next good value", async () => {
    const { page } = await show(`<bough-plant step="x" params='{"loads":{"gravity":1}}'></bough-plant>`);
    await page.getByText("step must be a whole number").waitFor();
    await on(page, (plant) => {
      plant.step = 3;
    });
    await page.getByText("step must be a whole number").waitFor({ state: "detached" });
    expect(await on(page, ({ plant }) => plant?.report.steps)).toBe(3);
    await page.context().close();
  });
});
