/** axe in every state of the page, and whether any text is cut off, in one language: each a shard of the soak. */
import { afterAll, beforeAll, expect, test } from "vitest";
import { violations } from "./axe.ts";
import { launchChromium } from "./chromium.ts";
import { cutTexts } from "./cut.ts";
import { everySight, type Tag, tags } from "./sights.ts";

let browser: Awaited<ReturnType<typeof launchChromium>>;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Contrast is the same in every language: the other two of the four are looked at in English. */
const { BOUGH_LANGUAGE: language = "en" } = process.env;
const tag = tags.find((one): one is Tag => one === language) ?? "en";
const screens = [
  { width: 1280, height: 800, colorScheme: "light" },
  { width: 390, height: 844, colorScheme: "dark" },
  ...(tag === "en"
    ? ([
        { width: 1280, height: 800, colorScheme: "dark" },
        { width: 390, height: 844, colorScheme: "light" },
      ] as const)
    : []),
  // Only whether texts fit; the second as at a zoom of 200 %.
  { width: 320, height: 640 },
  { width: 640, height: 400, deviceScaleFactor: 2 },
] as const;

test(`every state of the page in ${tag}`, async () => {
  const found: string[] = [];
  let seen = 0;
  for (const { width, height, ...screen } of screens) {
    const options = { viewport: { width, height }, bypassCSP: true, ...screen };
    seen += await everySight(browser, tag, options, async (page, sight) => {
      const problems = [
        ...("colorScheme" in screen ? await violations(page) : []),
        ...(await page.evaluate(cutTexts)).map((text) => `cut off: ${text}`),
      ];
      found.push(...problems.map((problem) => `${width} x ${height}, ${sight}: ${problem}`));
    });
  }
  console.log(`${tag}: ${seen} states on ${screens.length} screens, ${found.length} found by axe or cut off`);
  expect(found).toEqual([]);
});
