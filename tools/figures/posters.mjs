// What stands for each live figure of the course until it is drawn, and where no script runs: web/course/posters/<id>.webp,
// the plant on nothing, so that it fits light and dark.

import { mkdir, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { preview } from "vite";
import { buildSite } from "../build-site.mjs";
import { courseFolder } from "../course/pages.mjs";

/** Half as much again is what a figure has at most; the poster only stands in for it. */
const width = 542;

/** @param {import("playwright").Browser} browser */
export async function makePosters(browser) {
  await buildSite();
  const server = await preview({ logLevel: "error", preview: { host: "127.0.0.1", port: 0 } });
  const context = await browser.newContext({ colorScheme: "light", reducedMotion: "reduce" });
  try {
    const page = await context.newPage();
    await page.goto(`${server.resolvedUrls?.local[0]}course/index.html`);
    const posters = await page.locator("bough-plant").evaluateAll(draw, width);
    const folder = join(courseFolder, "posters");
    await rm(folder, { recursive: true, force: true });
    await mkdir(folder);
    for (const { id, webp } of posters) {
      await writeFile(join(folder, `${id}.webp`), Buffer.from(webp, "base64"));
      console.log(`poster of ${id}: ${Math.round((webp.length * 3) / 4000)} kB`);
    }
  } finally {
    await context.close();
    await server.close();
  }
}

/**
 * Runs in the page.
 * @param {(HTMLElement | SVGElement)[]} elements
 * @param {number} width
 */
async function draw(elements, width) {
  const posters = [];
  for (const element of elements) {
    const plant = /** @type {HTMLElementTagNameMap["bough-plant"]} */ (element);
    plant.controls = "none";
    plant.style.width = `${width}px`;
    await plant.settled();
    const bytes = new Uint8Array(await (await plant.toBlob("image/webp", 0.8)).arrayBuffer());
    posters.push({
      id: plant.id,
      webp: btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")),
    });
  }
  return posters;
}
