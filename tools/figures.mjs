// npm run figures: every preset as the page draws it. They become docs/figures.png, the contact sheet of the paper, and
// public/presets/<id>.webp, the thumbnails of the gallery; the plant of the bare page is default.webp among them. Then the
// posters of the course; they alone with `npm run figures -- posters`.

import { mkdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { build, preview, runnerImport } from "vite";
import { launchChromium } from "./chromium.mjs";
import { makeIcons } from "./figures/icons.mjs";
import { makePosters } from "./figures/posters.mjs";
import { makeSheet } from "./figures/sheet.mjs";
import { makeThumbnail } from "./figures/thumbnail.mjs";
import { orExplain } from "./obstacle.mjs";
import { root } from "./paths.mjs";
import { setUpForTests } from "./setup.mjs";

/** What a figure is drawn at; the sheet shows it half as large, which smooths it. px */
const picture = { width: 600, height: 450 };

/** What stands above the sheets. */
const titles = {
  paper: `The figures of <cite>A Biomechanical Model of Branch Shape in Plants</cite>
    (Jirasek &amp; Prusinkiewicz 1998), as Bough grows them`,
  species: "Plants one knows, as Bough grows them",
};

/** Leaves of the page only the plant, on nothing. */
const onlyPlant = `
  html, body { background: none !important; }
  body * { visibility: hidden; }
  .stage { position: fixed !important; inset: 0; background: none !important; }
  .picture, .annotation, .annotation * { visibility: visible; }
  .annotation { stroke-width: 2; }
  .annotation text { font-size: 1.375rem; }
  .annotation .angle { font-size: 1.625rem; }
`;
const unannotated = `${onlyPlant} .annotation, .annotation * { visibility: hidden; }`;

/**
 * @typedef {object} Figure
 * @property {string} id
 * @property {string} title
 * @property {Buffer} plate with ground line, angle and scale bar; PNG without a background
 * @property {Buffer} plant by itself, the same
 */

await orExplain(async () => {
  await setUpForTests();
  const browser = await launchChromium();
  try {
    if (!process.argv.includes("posters")) await drawPresets(browser);
    await makePosters(browser);
  } finally {
    await browser.close();
  }
});

/** @param {import("playwright").Browser} browser */
async function drawPresets(browser) {
  const folder = join(root, "dist", "figures");
  await build({ logLevel: "error", build: { outDir: folder } });
  const server = await preview({
    logLevel: "error",
    build: { outDir: folder },
    preview: { host: "127.0.0.1", port: 0 },
  });
  try {
    const { module } = await runnerImport(join(root, "web/src/params/declaration.ts"));
    /** @type {Figure[]} */
    const figures = [];
    for (const [id, preset] of Object.entries(module.presets)) {
      figures.push(await draw(browser, server.resolvedUrls?.local[0] ?? "", id, preset));
      console.log(`${id}: ${preset.title}`);
    }
    const paper = figures.filter(({ id }) => id.startsWith("figure-"));
    await writeFile(join(root, "docs", "figures.png"), await makeSheet(browser, paper, titles.paper));
    const species = figures.filter((figure) => !paper.includes(figure));
    await writeFile(join(root, "docs", "species.png"), await makeSheet(browser, species, titles.species));
    figures.push(await draw(browser, server.resolvedUrls?.local[0] ?? "", null, { title: "", params: {} }));
    await makeIcons(browser);
    const thumbnails = join(root, "public", "presets");
    await mkdir(thumbnails, { recursive: true });
    for (const { id, plant } of figures) {
      await writeFile(join(thumbnails, `${id}.webp`), await makeThumbnail(browser, plant));
    }
  } finally {
    await server.close();
  }
}

/**
 * @param {import("playwright").Browser} browser
 * @param {string} site
 * @param {string | null} id null is the default plant
 * @param {Pick<import("../web/src/params/declaration.ts").Preset, "title" | "params">} preset
 * @returns {Promise<Figure>}
 */
async function draw(browser, site, id, { title, params }) {
  const context = await browser.newContext({ viewport: picture, reducedMotion: "reduce", bypassCSP: true });
  try {
    const page = await context.newPage();
    const view = params.arrangement?.pattern === "stem" ? "space" : "plane";
    await page.goto(`${site}?${id === null ? "" : `preset=${id}&`}view=${view}&theme=light`);
    await page.addStyleTag({ content: onlyPlant });
    await settle(page);
    const plate = await page.screenshot({ omitBackground: true });
    await page.addStyleTag({ content: unannotated });
    return { id: id ?? "default", title, plate, plant: await page.screenshot({ omitBackground: true }) };
  } finally {
    await context.close();
  }
}

/**
 * Waits until the plant is drawn in its new size: a change of size is answered in the frame after it.
 * @param {import("playwright").Page} page
 */
async function settle(page) {
  await page.waitForFunction(() => {
    const { width, height } = document.querySelector("canvas.picture")?.getBoundingClientRect() ?? {};
    return width === innerWidth && height === innerHeight;
  });
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  await page.waitForFunction(() => document.documentElement.dataset.settled === "true");
}
