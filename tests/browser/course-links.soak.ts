/** Every state that the course links to, opened in the page: the plant is the one that the core grows from the link. */
import { expect, test } from "vitest";
import { init } from "../../web/src/package/node.ts";
import { stateLinks } from "../course/text.ts";
import { launchChromium } from "./chromium.ts";
import { visit } from "./visit.ts";
import { comparePlant } from "./walk.ts";

test("every link of the course opens its state", async () => {
  await init();
  const queries = [...new Set(stateLinks.map(({ query }) => query))];
  expect(queries.length).toBeGreaterThan(10);
  const browser = await launchChromium();
  let compared = 0;
  for (const query of queries) {
    const { page, problems } = await visit(browser, `?${query}`);
    expect(problems, query).toEqual([]);
    expect(await page.locator(".notices p").count(), query).toBe(0);
    compared += await comparePlant(page);
    await page.context().close();
  }
  await browser.close();
  console.log(
    `course links: ${queries.length} states opened, ${compared} compared with the core: all as linked`,
  );
  expect(compared).toBeGreaterThan(0.8 * queries.length);
});
