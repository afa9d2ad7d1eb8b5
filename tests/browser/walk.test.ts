/** Two hundred random actions; a hundred thousand are in the soak. */
import { afterAll, beforeAll, expect, inject, test } from "vitest";
import { launchChromium } from "./chromium.ts";
import { walk } from "./walk.ts";

let browser: Awaited<ReturnType<typeof launchChromium>>;
beforeAll(async () => {
  // It asks for more changes of the address in a second than any person.
  browser = await launchChromium(["--disable-ipc-flooding-protection"]);
});
afterAll(() => browser.close());

test.each([1, 2])("100 random actions, seed %i, break nothing", { timeout: 600_000 }, async (seed) => {
  const found = await walk(browser, inject("site"), seed, Number(process.env.BOUGH_ACTIONS ?? 100));
  console.log(found);
  expect(found).toContain("0 broken");
});
