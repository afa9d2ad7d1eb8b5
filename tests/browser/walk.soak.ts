/** A hundred thousand random actions over several seeds, each seed a shard of the soak. */
import { afterAll, beforeAll, expect, inject, test } from "vitest";
import { launchChromium } from "./chromium.ts";
import { walk } from "./walk.ts";

let browser: Awaited<ReturnType<typeof launchChromium>>;
beforeAll(async () => {
  browser = await launchChromium(["--disable-ipc-flooding-protection"]);
});
afterAll(() => browser.close());

const { BOUGH_SEED: seed = "1", BOUGH_ACTIONS: actions = "10000", BOUGH_PAINTED: painted } = process.env;

test(`${actions} random actions, seed ${seed}`, { timeout: 18_000_000 }, async () => {
  const way = { seed: Number(seed), actions: Number(actions), painted: painted === "yes", tell: console.log };
  const found = await walk(browser, inject("site"), way);
  console.log(found);
  expect(found).toContain("0 broken");
});
