/** Pages with a strict Content-Security-Policy, and browsers that lack something. */
import { readFileSync } from "node:fs";
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "../browser/chromium.ts";
import { Pixels } from "../browser/pixels.ts";
import { drawn, type Host, open, openHost } from "./host.ts";

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

/** The policy that docs/widget.md names for a script, with everything else forbidden. */
function policyFor(script: string): string {
  const docs = readFileSync(new URL("../../docs/widget.md", import.meta.url), "utf8");
  const [row] = docs
    .split("\n")
    .filter((line) => line.startsWith(`| \`${script}\``) && line.includes("script-src"));
  const [, policy] = / \| `(.+)` \|$/.exec(row ?? "") ?? [];
  if (!policy) throw new Error(`docs/widget.md names no policy for ${script}.`);
  return `default-src 'none'; ${policy}; require-trusted-types-for 'script'`;
}

const policies = { script: policyFor("bough-widget.js"), module: policyFor("bough-plant.js") };

/** A page under a policy. Its icon is the test's own, so that nothing is asked for. */
function under(policy: string, script: string) {
  const html = `<html lang="en"><head><title>Strict</title>${script}</head><body>
    <bough-plant preset="figure-13a" controls="full" color="moment" poster="presets/figure-13a.webp"></bough-plant>
    </body></html>`;
  // The icon of every page of the tests is a data: address.
  const all = policy.replace("img-src 'self'", "img-src 'self' data:");
  return open(browser, host.page(html, { "content-security-policy": all }));
}

async function woodIn(page: Page): Promise<number> {
  const box = await page.locator("bough-plant").boundingBox();
  return (await Pixels.of(page)).wood((box?.x ?? 0) + 400, (box?.y ?? 0) + 250, 200);
}

describe("under a strict policy", () => {
  it.each([
    ["one file", policies.script, `<script src="bough-widget.js" defer></script>`],
    ["the module", policies.module, `<script type="module" src="bough-plant.js"></script>`],
  ])("%s works, with nothing to complain of", async (_, policy, script) => {
    const { page, problems } = await under(policy, script);
    await drawn(page);
    await page.getByText("Bending moment").waitFor();
    await page.getByRole("slider", { name: "Gravity" }).fill("2");
    await page.getByRole("button", { name: "Watch it grow" }).click();
    const height = await page.locator("bough-plant").evaluate((plant) => plant.clientHeight);
    expect(height, "its styles are in force").toBeGreaterThan(300);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it.each([
    ["one file", `<script src="bough-widget.js" defer></script>`],
    ["the module", `<script type="module" src="bough-plant.js"></script>`],
  ])("%s shows the poster and a sentence where WebAssembly is forbidden", async (_, script) => {
    const { page } = await under(policies.module.replace(" 'wasm-unsafe-eval'", ""), script);
    await page
      .getByText("Content-Security-Policy forbids it; its script-src needs 'wasm-unsafe-eval'")
      .waitFor();
    expect(await woodIn(page)).toBeGreaterThan(0.005);
    const reason = await page.locator("bough-plant").evaluate((plant: HTMLElementTagNameMap["bough-plant"]) =>
      plant.toBlob().then(
        () => "a picture",
        (error: Error) => error.message,
      ),
    );
    expect(reason).toContain("wasm-unsafe-eval");
    await page.context().close();
  });
});

describe("where something is missing", () => {
  it("WebGL: the poster and a sentence", async () => {
    const context = await browser.newContext();
    await context.addInitScript(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string) {
        return kind === "2d" ? getContext.call(this, kind) : null;
      } as typeof getContext;
    });
    const page = await context.newPage();
    await page.goto(
      host.page(
        `<script src="bough-widget.js" defer></script><bough-plant poster="presets/figure-8a.webp"></bough-plant>`,
      ),
    );
    await page.getByText("This browser draws no 3D pictures").waitFor();
    expect(await woodIn(page)).toBeGreaterThan(0.005);
    await context.close();
  });

  it("a part that cannot be loaded: a sentence, and another try with the next click", async () => {
    const { page } = await open(
      browser,
      host.page(
        `<script type="module" src="bough-plant.js"></script><bough-plant loading="click" style="width: 360px"></bough-plant>`,
      ),
    );
    let blocked = true;
    await page.route(/\.wasm$/, (route) => (blocked ? route.abort() : route.continue()));
    await page.getByRole("button", { name: "Show the plant" }).click();
    await page.getByText("could not be fetched").waitFor();
    blocked = false;
    await page.locator("bough-plant").evaluate((plant: HTMLElementTagNameMap["bough-plant"]) => {
      plant.step = 3;
    });
    await drawn(page);
    await page.getByText("could not be fetched").waitFor({ state: "detached" });
    await page.context().close();
  });

  it("a graphics card that drops the picture: the last one stays, and the next change draws a new one", async () => {
    const { page } = await open(
      browser,
      host.page(
        `<script src="bough-widget.js" defer></script><bough-plant controls="none" style="width: 600px"></bough-plant>`,
      ),
    );
    await drawn(page);
    await page.evaluate(() => window.contexts[0]?.deref()?.getExtension("WEBGL_lose_context")?.loseContext());
    await page.evaluate(() => new Promise(requestAnimationFrame));
    expect(await woodIn(page)).toBeGreaterThan(0);
    await page.locator("bough-plant").evaluate(async (plant: HTMLElementTagNameMap["bough-plant"]) => {
      plant.params = { loads: { gravity: 0 } };
      await new Promise((resolve) => plant.addEventListener("bough-change", resolve, { once: true }));
    });
    await drawn(page);
    expect(await page.evaluate(() => window.contexts.length)).toBe(2);
    await page.context().close();
  });
});
