/** A hundred thousand random actions over several seeds, each seed a shard of the soak. */
import { afterAll, beforeAll, expect, inject, test } from "vitest";
import { launchChromium } from "./chromium.ts";
import { walk } from "./walk.ts";

let browser: Awaited<ReturnType<typeof launchChromium>>;
beforeAll(async () => {
  browser = await launchChromium(["--disable-ipc-flooding-protection"]);
});
afterAll(() => browser.close());

const { BOUGH_SEED: seed = "1", BOUGH_ACTIONS: actions = "10000" } = process.env;

test(`${actions} random actions, seed ${seed}`, async () => {
  const found = await walk(browser, inject("site"), Number(seed), Number(actions));
  console.log(found);
  expect(found).toContain("0 broken");
});
