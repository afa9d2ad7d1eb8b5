/** A plant that is pinned, beside the present one, in real Chromium. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { pointOf, tipOf } from "./points.ts";
import { meters, open } from "./study.ts";
import { placeOf, query, settled, type, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

describe("compare", () => {
  const row = (page: Page, name: string) =>
    page.locator("table.differences tr", { hasText: name }).locator("td").allInnerTexts();

  it("pins A, shows it, tells the differences, swaps, and keeps it in the link", async () => {
    const { page, problems } = await visitUnpainted(browser);
    await open(page, "compare");
    await page.getByRole("button", { name: "Pin this plant as A" }).click();
    await page.getByText("Nothing: both are the same plant.").waitFor();
    expect(query(page).get("pin")).toBe("v=1");
    await type(page, /^Young/, "0.4 GPa");
    const [a, now] = [tipOf({}), tipOf({ material: { youngsModulus: 4e8 } })];
    const [then = "", present = "", off = ""] = await row(page, "Tip up");
    expect(meters(then)).toBeCloseTo(a[1], 2);
    expect(meters(present)).toBeCloseTo(now[1], 2);
    expect(meters(off)).toBeCloseTo(now[1] - a[1], 2);
    await page.getByText("Young's modulus: 1 GPa, now 400 MPa").waitFor();
    // The dashed line is where A was, as far as it is on the picture.
    const ghost = await page.locator(".overlay .ghost").getAttribute("d");
    const middle = await placeOf(page, pointOf(grow({}), 20));
    const stage = await page.locator(".overlay").boundingBox();
    const away = [...(ghost ?? "").matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) =>
      Math.hypot((stage?.x ?? 0) + Number(x) - middle.x, (stage?.y ?? 0) + Number(y) - middle.y),
    );
    expect(Math.min(...away)).toBeLessThan(1);
    const link = page.url();
    await page.getByRole("button", { name: "Swap A and the present one" }).click();
    await settled(page);
    await page.getByText("Young's modulus: 400 MPa, now 1 GPa").waitFor();
    expect(query(page).get("pin")).toBe("v=1&ym=400000000");
    // Undo takes the swap of the present plant back; A stays what it is.
    await page.getByRole("button", { name: "Undo" }).click();
    await settled(page);
    await page.getByText("Nothing: both are the same plant.").waitFor();
    expect(problems).toEqual([]);
    await page.context().close();
    // The link brings both back.
    const again = await visitUnpainted(browser, new URL(link).search);
    await open(again.page, "compare");
    await again.page.getByText("Young's modulus: 1 GPa, now 400 MPa").waitFor();
    await again.page.getByRole("button", { name: "Take A away" }).click();
    expect(query(again.page).has("pin")).toBe(false);
    expect(await again.page.locator(".overlay .ghost").count()).toBe(0);
    expect(again.problems).toEqual([]);
    await again.page.context().close();
  });

  it("plots A along the axis beside the present plant", async () => {
    const { page } = await visitUnpainted(browser, "?ym=400000000&pin=v%3D1");
    await open(page, "why");
    await page.locator(".plots .curve.second").first().waitFor();
    expect(await page.locator(".plots .curve").count()).toBe(8);
    await page.context().close();
  });

  it("says so when what a link pins cannot be grown, and goes on", async () => {
    const { page } = await visitUnpainted(browser, "?pin=v%3D1%26n%3D100000%26th%3Dpipes");
    await open(page, "compare");
    await page.getByText("The pinned plant of the link cannot be grown").waitFor();
    await page.context().close();
  });

  it("a part that is opened stays open, whatever is drawn before the browser tells of it", async () => {
    const { page } = await visitUnpainted(browser);
    await open(page, "compare");
    await page.evaluate(() => {
      document.querySelector<HTMLElement>("details.measure > summary")?.click();
      document.querySelector<HTMLElement>("details.compare .deeds button")?.click();
    });
    await page.getByRole("button", { name: "Take A away" }).waitFor();
    await settled(page);
    expect(await page.locator("details.measure").evaluate((part: HTMLDetailsElement) => part.open)).toBe(
      true,
    );
    await page.getByRole("button", { name: "Ruler" }).waitFor({ timeout: 5000 });
    await page.context().close();
  });

  it("takes a larger A into the picture, and lets it go with it", async () => {
    const { page, problems } = await visitUnpainted(browser, "?preset=figure-2a&pin=v%3D1");
    const ghost = page.locator(".overlay .ghost");
    await ghost.waitFor();
    await settled(page);
    const tip = () => placeOf(page, pointOf(grow({}), 40));
    const picture = await page.locator("canvas.picture").boundingBox();
    const right = (picture?.x ?? 0) + (picture?.width ?? 0);
    const taken = await tip();
    expect(taken.x).toBeLessThan(right - 20);
    await open(page, "compare");
    await page.getByRole("button", { name: "Take A away" }).click();
    await settled(page);
    expect((await tip()).x).toBeGreaterThan(right);
    // To pin what is shown moves nothing.
    const before = await tip();
    await page.getByRole("button", { name: "Pin this plant as A" }).click();
    await settled(page);
    expect(await tip()).toEqual(before);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("draws a large A beside a small plant as far as it is seen: dashes beyond held the browser up for seconds", async () => {
    const pin = encodeURIComponent("v=1&preset=weeping-willow&view=space");
    const { page, problems } = await visitUnpainted(browser, `?preset=figure-2a&view=space&pin=${pin}`, {
      viewport: { width: 700, height: 420 },
    });
    const ghosts = page.locator(".overlay .ghost");
    await ghosts.first().waitFor({ state: "attached" });
    await settled(page);
    const box = await page.locator("canvas.picture").boundingBox();
    const lines = await ghosts.evaluateAll((all) => all.map((one) => one.getAttribute("d") ?? ""));
    const places = lines.flatMap((line) =>
      [...line.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)] as const),
    );
    expect(places.length).toBeGreaterThan(1);
    // It is so much larger that it is not taken in: its lines are cut, 50 px beyond the edge.
    const [across, down] = [box?.width ?? 0, box?.height ?? 0];
    expect(places.some(([x, y]) => x < 0 || x > across || y < 0 || y > down)).toBe(true);
    for (const [x, y] of places) {
      expect(x).toBeGreaterThan(-60);
      expect(x).toBeLessThan(across + 60);
      expect(y).toBeGreaterThan(-60);
      expect(y).toBeLessThan(down + 60);
    }
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
