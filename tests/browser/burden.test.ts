/** What a plant bears and what breaks it, seen and said. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { Pixels } from "./pixels.ts";
import { query, settled, type, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Shares of the picture that are green as leaves and red as fruit. */
async function shares(page: Page): Promise<{ green: number; red: number }> {
  const picture = await Pixels.of(page);
  const box = await page.locator("canvas.picture").boundingBox();
  if (!box) throw new Error("There is no picture.");
  let [green, red, all] = [0, 0, 0];
  for (let x = box.x; x < box.x + box.width; x += 3) {
    for (let y = box.y; y < box.y + box.height; y += 3) {
      const [r, g, b] = picture.at(x, y);
      if (g > r + 15 && g > b + 30) green++;
      if (r > g + 60 && r > b + 60) red++;
      all++;
    }
  }
  return { green: green / all, red: red / all };
}

it("shows leaves and fruit, and leaves them off where they are not wanted", async () => {
  const { page, problems } = await visit(browser, "?preset=apple-fruit");
  const borne = await shares(page);
  expect(borne.green).toBeGreaterThan(0.02);
  expect(borne.red).toBeGreaterThan(0.001);
  await page.getByRole("radio", { name: "Bare" }).check({ force: true });
  await settled(page);
  expect(query(page).get("style")).toBe("bare");
  const bare = await shares(page);
  expect(bare.green).toBeLessThan(0.5 * borne.green);
  expect(bare.red).toBeLessThan(0.0005);
  expect(problems).toEqual([]);
  await page.context().close();
});

it("picks the fruit", async () => {
  const { page, problems } = await visit(browser, "?preset=apple-fruit&pk=1");
  const picked = await shares(page);
  expect(picked.green).toBeGreaterThan(0.02);
  expect(picked.red).toBeLessThan(0.0005);
  expect(problems).toEqual([]);
  await page.context().close();
});

it("marks and says where a plant breaks", async () => {
  const { page, problems } = await visit(browser, "?preset=wheat");
  const mark = page.locator(".annotation text.break");
  const strength = page.locator(".readout div").filter({ hasText: "Strength" });
  expect(await mark.isVisible()).toBe(false);
  expect(await strength.innerText()).toMatch(
    /It would break first at the base, at 1\.81 times this stress\./,
  );
  await page.getByText("Loads", { exact: true }).click();
  await type(page, /^Wind/, "20");
  expect(await mark.isVisible()).toBe(true);
  const sentence = "It breaks under this load, first at the base; it is shown as if it held.";
  expect(await strength.innerText()).toContain(sentence);
  expect(await strength.getAttribute("class")).toBe("unsound");
  expect(problems).toEqual([]);
  await page.context().close();
});
