/** A thousand random actions; a hundred thousand are in the soak. */
import { afterAll, beforeAll, expect, inject, test } from "vitest";
import { launchChromium } from "./chromium.ts";
import { walk } from "./walk.ts";

let browser: Awaited<ReturnType<typeof launchChromium>>;
beforeAll(async () => {
  // It asks for more changes of the address in a second than any person.
  browser = await launchChromium(["--disable-ipc-flooding-protection"]);
});
afterAll(() => browser.close());

test.each([
  { seed: 1, actions: 100, painted: true },
  { seed: 2, actions: 900, painted: false },
])("$actions random actions, seed $seed, break nothing", { timeout: 900_000 }, async (way) => {
  const found = await walk(browser, inject("site"), way);
  console.log(found);
  expect(found).toContain("0 broken");
});
