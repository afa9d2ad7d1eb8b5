/** What platforms for teaching leave of the snippets that the course prints. */
import type { Browser } from "playwright";
import sanitize from "sanitize-html";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { recipe } from "../../../tools/hosts/recipe.mjs";
import { snippet } from "../../../web/src/explorer/snippet.ts";
import { initialState, presetState } from "../../../web/src/params/state.ts";
import { launchChromium } from "../../browser/chromium.ts";
import { type Host, open, openHost } from "../../element/host.ts";
import { canvas, purifier } from "./sanitisers.ts";

let browser: Browser;
let host: Host;
beforeAll(async () => {
  browser = await launchChromium();
  host = await openHost();
});
afterAll(async () => {
  await browser.close();
  host.close();
});

/** A printed snippet, for the copy of Bough that is served here. */
function printed(name: string): string {
  const text = [...recipe(name).values()].join("");
  return text.replaceAll("https://example.org/bough/", host.address);
}

const dialog = () =>
  snippet({ ...initialState, ...presetState("figure-13c") }, host.address, {
    form: "iframe",
    width: 640,
    height: 520,
    theme: "auto",
    controls: "compact",
    poster: false,
    title: "A branch that seeks 45 degrees",
  });

const page = (body: string) => `<html lang="en"><title>A course</title><main>${body}</main></html>`;

describe("in Canvas", () => {
  it.each([
    ["the course", () => printed("frame")],
    ["the page's Embed dialog", dialog],
  ])("the snippet of %s still shows the plant, and it can be moved", async (_, made) => {
    const left = sanitize(made(), canvas);
    expect(left).toContain("<iframe");
    const { page: visited, problems } = await open(browser, host.page(page(left)));
    const frame = visited.frameLocator("iframe");
    await frame.getByRole("slider", { name: "Gravity" }).fill("2");
    const size = await frame.locator("bough-plant").evaluate(async (element) => {
      const plant = element as HTMLElementTagNameMap["bough-plant"];
      await plant.settled();
      const { size } = await plant.toBlob();
      return { size, link: plant.link };
    });
    expect(size.link).toBe("?v=1&preset=figure-13c&g=2");
    expect(size.size).toBeGreaterThan(1000);
    expect(await visited.getByRole("link", { name: "A branch that seeks 45 degrees" }).isVisible()).toBe(
      true,
    );
    expect(problems).toEqual([]);
    await visited.context().close();
  });

  it("a script and the element would not be left", () => {
    const left = sanitize(printed("plain"), canvas);
    expect(left).not.toContain("<script");
    expect(left).not.toContain("<bough-plant");
    // What is inside the element stays: poster, caption and link.
    expect(left).toContain("branch.webp");
    expect(left).toContain("Take the gravity away.");
    expect(left).toContain("Open it in Bough");
  });
});

describe("where students write in Moodle", () => {
  it("the frame is taken out, and the link under it remains", () => {
    const left = sanitize(printed("frame"), purifier);
    expect(left).not.toContain("iframe");
    expect(left).toContain(`<a href="${host.address}?v=1&amp;preset=figure-13c">`);
  });

  it("the picture that links is left whole", async () => {
    const left = sanitize(printed("picture"), purifier);
    const { page: visited, problems } = await open(browser, host.page(page(left)));
    const image = visited.getByRole("link").getByRole("img", { name: "A branch in the shape of a flat S" });
    await expect.poll(() => image.evaluate((one: HTMLImageElement) => one.naturalWidth)).toBe(192);
    const address = await visited.getByRole("link").evaluate((link: HTMLAnchorElement) => link.href);
    expect(address).toBe(`${host.address}?v=1&preset=figure-13c`);
    expect(problems).toEqual([]);
    await visited.context().close();
  });
});

it("where frames are blocked the link remains", async () => {
  const { page: visited } = await open(
    browser,
    host.page(page(printed("frame")), { "content-security-policy": "frame-src 'none'" }),
  );
  expect(await visited.frameLocator("iframe").locator("bough-plant").count()).toBe(0);
  expect(await visited.getByRole("link", { name: "A branch that seeks 45 degrees" }).isVisible()).toBe(true);
  await visited.context().close();
});

it("the recipe for a plain page is live, and its poster, caption and link remain without scripts", async () => {
  const own = printed("plain").replaceAll("branch.webp", "course/posters/branch.webp");
  const { page: visited, problems } = await open(browser, host.page(own));
  await visited.getByRole("slider", { name: "Gravity" }).fill("0");
  await visited.waitForFunction(
    () => document.querySelector("bough-plant")?.link === "?v=1&preset=figure-13c&g=0",
  );
  expect(problems).toEqual([]);
  await visited.context().close();
  const { page: bare } = await open(browser, host.page(own), { javaScriptEnabled: false });
  expect(await bare.getByRole("img", { name: "A branch in the shape of a flat S" }).isVisible()).toBe(true);
  expect(await bare.getByText("Take the gravity away.").isVisible()).toBe(true);
  expect(await bare.getByRole("link", { name: "Open it in Bough" }).isVisible()).toBe(true);
  await bare.context().close();
});
