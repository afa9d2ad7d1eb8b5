/** Plants that lie in no plane: seen, turned, dragged, coloured, replayed and explained like any other. */
import type { Browser } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { grow, init, type ParamsInput } from "../../web/src/package/node.ts";
import { write } from "../../web/src/params/link.ts";
import { complete } from "../../web/src/params/params.ts";
import { initialState } from "../../web/src/params/state.ts";
import { launchChromium } from "./chromium.ts";
import { placeOf, pull, query, readTip, settled, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Forks whose planes turn from one to the next, twice. */
const bush: ParamsInput = {
  axis: { segments: 8, segmentLength: 0.04, radius: 0.003, elevation: 60 },
  branching: { pattern: "bifurcation", generations: 2, roll: 65, girthRatio: 0.7 },
};
/** A stem that bends under the axes around it. */
const stem: ParamsInput = {
  axis: { segments: 10, radius: 0.003, elevation: 30 },
  arrangement: { pattern: "flexibleStem", count: 4, interval: 2, stemRadius: 0.006, stemElevation: 80 },
};

function link(params: ParamsInput): string {
  return write({ ...initialState, params: complete(params), view: "space" });
}

/** Where the last segment ends, with or without a force on it. */
function lastEnd(
  params: ParamsInput,
  force?: [number, number, number],
): { place: number[]; segment: number } {
  const plain = grow(params);
  const segment = plain.segments.parent.length - 1;
  const loads = force ? { forces: [{ segment, force }] } : {};
  const { polylines, segments } = grow({ ...params, loads });
  const point = 3 * (segments.point[segment] ?? 0);
  return { place: [...polylines.points.subarray(point, point + 3)], segment };
}

it.each([
  ["forks in space", bush],
  ["axes on a stem that bends", stem],
])("%s: the tip follows the pointer, by the force that is shown", async (_, params) => {
  const { page, problems } = await visitUnpainted(browser, link(params));
  const tip = await readTip(page);
  const { place, segment } = lastEnd(params);
  expect(Math.abs(place[2] ?? 0)).toBeGreaterThan(0.01);
  const start = await placeOf(page, place);
  const pointer = { x: start.x + 15, y: start.y + 25 };
  await pull(page, start, pointer);
  const shown = (await page.locator(".pull data").getAttribute("value")) ?? "";
  const [x = 0, y = 0, z = 0] = shown.split(",").map(Number);
  await page
    .locator(".pull")
    .getByText(`Segment ${segment + 1} `)
    .waitFor();
  const there = await placeOf(page, lastEnd(params, [x, y, z]).place);
  expect(Math.hypot(there.x - pointer.x, there.y - pointer.y)).toBeLessThan(2);
  await page.mouse.up();
  await settled(page);
  expect(await readTip(page)).toBe(tip);
  expect(problems).toEqual([]);
  await page.context().close();
});

it("colours, model, plane view, ages and loads off work on them", async () => {
  const { page, problems } = await visitUnpainted(browser, link(bush));
  for (const [control, wanted] of [
    ["Model", "style"],
    ["Limbs", ""],
    ["Plane", ""],
    ["Space", "view"],
  ] as const) {
    await page.getByRole("radio", { name: control, exact: true }).check({ force: true });
    await settled(page);
    if (wanted) expect(query(page).has(wanted)).toBe(true);
  }
  for (const color of ["moment", "stress", "curvature", "age"]) {
    await page.getByRole("combobox", { name: "Colour" }).selectOption(color);
    await settled(page);
    expect(query(page).get("color")).toBe(color);
    expect(await page.locator(".legend").innerText()).toMatch(/\d/);
  }
  const tip = await readTip(page);
  await page.getByRole("switch", { name: "Take the loads off" }).click();
  await settled(page);
  expect(await readTip(page)).not.toBe(tip);
  await page.getByRole("button", { name: "Undo" }).click();
  await page.getByRole("button", { name: "One step younger" }).click();
  await settled(page);
  expect(query(page).get("step")).toBe("23");
  expect(problems).toEqual([]);
  await page.context().close();
});

it("a stem past its critical height leans, and See why says by how much it is past it", async () => {
  const tall: ParamsInput = {
    axis: { segments: 40, segmentLength: 0.05, radius: 0.003, elevation: 90 },
    solver: { space: true },
  };
  const { report, polylines } = grow(tall);
  expect(report.selfBuckling).toBeGreaterThan(1);
  expect(polylines.points.at(-3)).toBeGreaterThan(0.1);
  const { page, problems } = await visitUnpainted(browser, link(tall));
  await page.locator("details.why > summary").click();
  await page.getByText(`${Number((100 * (report.selfBuckling ?? 0)).toPrecision(3))} %`).waitFor();
  expect(problems).toEqual([]);
  await page.context().close();
});
