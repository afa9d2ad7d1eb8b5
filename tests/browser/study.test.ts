/** The study of a plant in real Chromium: why it has its shape, how it compares, what is measured on it. */
import { createRequire } from "node:module";
import type { AxeResults } from "axe-core";
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init, type ParamsInput } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { pointOf, tipOf } from "./points.ts";
import { meters, open } from "./study.ts";
import { placeOf, settled, slider, visit, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Gets the text of a file that a click saves. */
async function saved(page: Page, button: string): Promise<{ name: string; text: string }> {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: button }).click(),
  ]);
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(Buffer.from(chunk));
  return { name: download.suggestedFilename(), text: Buffer.concat(chunks).toString("utf8") };
}

/** Where a circle of the overlay is on the page. */
async function circleAt(page: Page, selector: string): Promise<{ x: number; y: number }> {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`There is no ${selector}.`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

describe("see why: along the axis", () => {
  const plant = () => grow({});

  it("plots and picture show one place, found on either", async () => {
    const { page, problems } = await visitUnpainted(browser);
    await open(page, "why");
    const place = slider(page, "Place along the axis");
    const start = await placeOf(page, pointOf(plant(), 20));
    await page.mouse.move(start.x, start.y);
    // The pointer is on the joint between two segments.
    await expect.poll(() => place.getAttribute("aria-valuenow")).toMatch(/^2[01]$/);
    await page.mouse.move(5, 5);
    await place.focus();
    await page.keyboard.press("Home");
    for (let press = 0; press < 10; press++) await page.keyboard.press("ArrowRight");
    expect(await place.getAttribute("aria-valuenow")).toBe("11");
    const [shown, meant] = [
      await circleAt(page, ".overlay .place"),
      await placeOf(page, pointOf(plant(), 10)),
    ];
    expect(Math.hypot(shown.x - meant.x, shown.y - meant.y)).toBeLessThan(1.5);
    const { segments } = plant();
    const text = (await place.getAttribute("aria-valuetext")) ?? "";
    expect(text).toContain("37.5 cm:");
    const [, moment = ""] = /bending moment ([−\d.]+) mN m/.exec(text) ?? [];
    // In two digits.
    expect(Number(moment.replace("−", "-")) / 1000 / (segments.moment[10] ?? 0)).toBeCloseTo(1, 1);
    // By the pointer on the plots, too.
    const plots = await page.locator(".plots").boundingBox();
    if (!plots) throw new Error("There are no plots.");
    await page.mouse.move(plots.x + plots.width * 0.99, plots.y + 80);
    await expect.poll(() => place.getAttribute("aria-valuenow")).toBe("40");
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("are a table and files too, with the numbers of the plant", async () => {
    const { page } = await visit(browser);
    await open(page, "why");
    await page.getByText("As a table").click();
    expect(await page.locator(".numbers tbody tr").count()).toBe(40);
    const csv = await saved(page, "Save as CSV");
    expect(csv.name).toBe("bough-along-the-axis.csv");
    const [header = "", ...rows] = csv.text.trim().split("\n");
    expect(header).toBe("segment,distance (m),angle (deg),curvature (1/m),moment (N m),stress (Pa)");
    const { segments } = plant();
    expect(rows).toHaveLength(40);
    rows.forEach((row, k) => {
      const [segment, distance, angle, curvature, moment, stress] = row.split(",").map(Number);
      expect([segment, curvature, moment, stress]).toEqual([
        k,
        segments.curvature[k],
        segments.moment[k],
        segments.stress[k],
      ]);
      expect(distance).toBeCloseTo(0.0375 * k, 12);
      const [from, to] = [pointOf(plant(), k), pointOf(plant(), k + 1)];
      expect(angle).toBeCloseTo((Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI, 9);
    });
    const drawing = await saved(page, "Save as SVG");
    // Opened by the browser as a picture: nothing of the page's styles is needed.
    const ink = await page.evaluate(async (text) => {
      const image = new Image();
      image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const pen = canvas.getContext("2d");
      pen?.drawImage(image, 0, 0);
      const { data = [] } = pen?.getImageData(0, 0, canvas.width, canvas.height) ?? {};
      let green = 0;
      for (let at = 0; at < data.length; at += 4) {
        const [r = 0, g = 0, b = 0] = [data[at], data[at + 1], data[at + 2]];
        if (g > r + 15 && g > b + 25) green++;
      }
      return { width: image.width, height: image.height, green };
    }, drawing.text);
    expect(ink.width).toBe(340);
    expect(ink.height).toBeGreaterThan(400);
    // Four curves of some 280 px, 2 px wide.
    expect(ink.green).toBeGreaterThan(1200);
    await page.context().close();
  });

  it("goes along the thicker children of forks, and through whatever is pointed at", async () => {
    const { page } = await visitUnpainted(browser, "?preset=figure-18b");
    await open(page, "why");
    const place = slider(page, "Place along the axis");
    const whole = Number(await place.getAttribute("aria-valuemax"));
    await place.focus();
    await page.keyboard.press("End");
    expect(await place.getAttribute("aria-valuenow")).toBe(String(whole));
    expect(whole).toBeGreaterThan(20);
    await page.context().close();
  });
});

describe("see why: what moves the tip", () => {
  it("is what central differences say, the most important first", async () => {
    const { page } = await visitUnpainted(browser);
    await open(page, "why");
    await page.locator(".bars li").first().waitFor();
    const bars = await page.locator(".bars li").evaluateAll((items) =>
      items.map((item) => ({
        label: item.querySelector("span")?.textContent ?? "",
        text: item.querySelector("small")?.textContent ?? "",
        width: Number.parseFloat(item.querySelector("rect")?.getAttribute("width") ?? ""),
      })),
    );
    expect(bars.map(({ width }) => width)).toEqual(bars.map(({ width }) => width).sort((a, b) => b - a));
    expect(bars[0]?.width).toBe(100);
    const cases: [RegExp, (change: number) => ParamsInput][] = [
      [/^Young's modulus/, (change) => ({ material: { youngsModulus: 1e9 * (1 + change) } })],
      [/^Radius/, (change) => ({ axis: { radius: 0.005 * (1 + change) } })],
      [/^Gravity/, (change) => ({ loads: { gravity: 9.81 * (1 + change) } })],
    ];
    for (const [label, changed] of cases) {
      const bar = bars.find((bar) => label.test(bar.label));
      const [ahead, behind] = [tipOf(changed(1e-3)), tipOf(changed(-1e-3))];
      // By a tenth more, along the tangent.
      const up = ((ahead[1] - behind[1]) / 2e-3) * 0.1;
      const part = bar?.text.split(", ").find((part) => /up|down/.test(part)) ?? "";
      expect(part).toContain(up > 0 ? "up" : "down");
      // Two digits are written.
      expect(Math.abs(meters(part) / Math.abs(up) - 1)).toBeLessThan(0.051);
    }
    await page.context().close();
  });

  it("is said to be unknown where it is", async () => {
    const { page } = await visitUnpainted(browser, "?st=extrapolated&n=400&l=0.004");
    await open(page, "why");
    await page.getByText("Extrapolated growth has no exact derivatives").waitFor();
    await page.context().close();
  });
});

it("see why: whether it holds", async () => {
  const { page } = await visitUnpainted(browser, "?e=90&ym=20000000&r=0.005");
  await open(page, "why");
  const facts = await page.locator(".facts").innerText();
  const { report } = grow({ axis: { elevation: 90, radius: 0.005 }, material: { youngsModulus: 2e7 } });
  expect(report.stable).toBe(true);
  expect(report.selfBuckling).toBeGreaterThan(1);
  expect(facts).toContain("Stable, at every age so far.");
  expect(facts).toMatch(
    /Its loads are [\d,.]+ % of those at which it can no longer stand straight: it has leaned over/,
  );
  expect(facts).toContain("gravity number of 7.84 (Greenhill 1881)");
  expect(facts).toMatch(/Largest stress [\d.]+ /);
  await page.context().close();
});

it("see why: the paper's relaxation and Newton's iterations are played, and end in the plant", async () => {
  const { page, problems } = await visitUnpainted(browser, "?n=16&l=0.09");
  await open(page, "why");
  await page.getByRole("radio", { name: /All the weight at once/ }).check();
  await page.getByRole("button", { name: "Play both" }).click();
  const moment = slider(page, "Moment");
  await moment.waitFor();
  await page.getByRole("button", { name: "Pause" }).click();
  const ends = async () =>
    page.locator(".overlay .euler, .overlay .newton").evaluateAll((lines) =>
      lines.map((line) => {
        const [x = 0, y = 0] = (line.getAttribute("d") ?? "").split("L").at(-1)?.split(" ").map(Number) ?? [];
        return { x, y };
      }),
    );
  await moment.fill("0");
  const [eulerStart, newtonStart] = await ends();
  expect(eulerStart).toEqual(newtonStart);
  await moment.fill("1000");
  await page.getByText(/^Euler step (\d+) of \1$/).waitFor();
  const stage = await page.locator(".overlay").boundingBox();
  const plant = grow({ axis: { segments: 16, segmentLength: 0.09 } });
  const tip = await placeOf(page, pointOf(plant, 16));
  for (const { x, y } of await ends()) {
    expect(Math.hypot((stage?.x ?? 0) + x - tip.x, (stage?.y ?? 0) + y - tip.y)).toBeLessThan(1);
  }
  // The unloaded axis is elsewhere.
  expect(Math.hypot((eulerStart?.x ?? 0) - tip.x, (eulerStart?.y ?? 0) - tip.y)).toBeGreaterThan(50);
  const words = await page.locator("dl.ways").innerText();
  expect(Number(/Euler step (\d+)/.exec(words)?.[1])).toBeGreaterThan(100);
  expect(Number(/iteration (\d+)/.exec(words)?.[1])).toBeLessThan(15);
  await page.getByRole("button", { name: "Close" }).click();
  expect(await page.locator(".overlay .euler").count()).toBe(0);
  expect(problems).toEqual([]);
  await page.context().close();
});

describe("the ruler and the protractor", () => {
  async function drag(page: Page, name: RegExp, to: { x: number; y: number }): Promise<void> {
    const handle = page.getByRole("button", { name });
    const box = await handle.boundingBox();
    if (!box) throw new Error(`There is no handle ${name}.`);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 4 });
    await page.mouse.up();
  }

  it("measure what is under them", async () => {
    const { page, problems } = await visitUnpainted(browser);
    await open(page, "measure");
    await page.getByRole("button", { name: "Ruler" }).click();
    const plant = grow({});
    const [from, to] = [pointOf(plant, 8), pointOf(plant, 30)];
    await drag(page, /^Ruler, end 2/, await placeOf(page, to));
    await drag(page, /^Ruler, end 1/, await placeOf(page, from));
    const measured = page.locator(".measured");
    const text = await measured.innerText();
    // A pixel is about 2 mm here.
    expect(Math.abs(meters(text) - Math.hypot(to[0] - from[0], to[1] - from[1]))).toBeLessThan(0.004);
    await page.getByRole("button", { name: "Ruler", exact: true }).click();
    await page.getByRole("button", { name: "Protractor" }).click();
    await drag(page, /^Protractor, arm 2/, await placeOf(page, pointOf(plant, 40)));
    const [x, y] = pointOf(plant, 40);
    const angle = Number.parseFloat((await measured.innerText()).replace("Protractor: ", ""));
    expect(angle).toBeCloseTo(Math.abs((Math.atan2(y, x) * 180) / Math.PI), 0);
    // By keys: ten px to the right make the arm longer, not the angle larger than it was by much.
    await page.getByRole("button", { name: /^Protractor, corner/ }).focus();
    for (let press = 0; press < 3; press++) await page.keyboard.press("Shift+ArrowDown");
    expect(Number.parseFloat((await measured.innerText()).replace("Protractor: ", ""))).not.toBeCloseTo(
      angle,
      0,
    );
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("are put away in the space view, with a way back", async () => {
    const { page } = await visitUnpainted(browser, "?view=space");
    await open(page, "measure");
    await page.getByRole("button", { name: "Look at the plane" }).click();
    await settled(page);
    await page.getByRole("button", { name: "Ruler" }).click();
    await page.locator(".overlay .ruler").waitFor({ state: "attached" });
    await page.context().close();
  });
});

describe("by keys alone", () => {
  it("a line is traced, a point taken away", async () => {
    const { page } = await visitUnpainted(browser);
    await open(page, "measure");
    await page.getByRole("radio", { name: "Traces the branch" }).check();
    const add = page.getByRole("button", { name: "Add a point" });
    await add.press("Enter");
    await add.press("Enter");
    const second = page.getByRole("button", { name: /^Traced point 2/ });
    await second.focus();
    for (let press = 0; press < 4; press++) await page.keyboard.press("Shift+ArrowUp");
    await page.getByText("2 points").waitFor();
    await page.keyboard.press("Delete");
    await page.getByText("1 point", { exact: true }).waitFor();
    await page.getByRole("button", { name: "Fit to the line" }).press("Enter");
    await page.getByRole("alert").filter({ hasText: "Trace at least" }).waitFor();
    await page.context().close();
  });
});

describe.each(["light", "dark"] as const)("axe finds nothing in %s", (colorScheme) => {
  const axePath = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  it.each([
    [1280, 800],
    [390, 844],
  ])("at %d x %d, with everything open and in use", async (width, height) => {
    const viewport = { width, height };
    const { page } = await visitUnpainted(browser, "?pin=v%3D1&ym=400000000", {
      viewport,
      colorScheme,
      bypassCSP: true,
    });
    await page.addScriptTag({ path: axePath });
    for (const part of ["why", "compare", "measure"] as const) await open(page, part);
    await page.locator(".bars li").first().waitFor();
    await page.getByText("As a table").click();
    await page.getByRole("button", { name: "Ruler" }).click();
    await page.getByRole("button", { name: "Protractor" }).click();
    await page.getByRole("radio", { name: "Traces the branch" }).check();
    await page.getByRole("button", { name: "Add a point" }).click();
    await page.getByRole("button", { name: "Fit to the line" }).click();
    await page.getByRole("alert").filter({ hasText: "Trace at least" }).waitFor();
    await page.getByRole("button", { name: "Play both" }).click();
    await slider(page, "Moment").waitFor();
    await page.getByRole("button", { name: "Pause" }).click();
    const { violations } = await page.evaluate(async () => {
      const { axe } = window as unknown as { axe: { run(): Promise<AxeResults> } };
      return axe.run();
    });
    expect(
      violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 200)}`)),
    ).toEqual([]);
    const sticksOut = await page.evaluate(() => {
      const panel = document.querySelector("#controls");
      return panel ? panel.scrollWidth - panel.clientWidth : Number.NaN;
    });
    expect(sticksOut).toBe(0);
    await page.context().close();
  });
});
