// Every preset in light and dark, wide and on a phone, against the pictures in tests/visual/golden.

import { existsSync } from "node:fs";
import { mkdir, mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build, preview, runnerImport } from "vite";
import { complaint, launchChromium } from "../chromium.mjs";
import { Obstacle } from "../obstacle.mjs";
import { root } from "../paths.mjs";
import { difference, isSame, limits } from "./difference.mjs";
import { shrunk } from "./shrunk.mjs";

const golden = join(root, "tests", "visual", "golden");
/** Where the page is built for it: a check may be using the other. */
export const platesFolder = join(root, "dist", "visual");

/** As the issue has it; each shrinks to about 300 by 230 pixels, of 1 to 4 kB. */
const screens = { wide: { width: 1280, height: 800, by: 3 }, phone: { width: 390, height: 844, by: 1.5 } };
const papers = { light: "#f7f5ee", dark: "#1a1e1a" };

/** @typedef {{ screen: keyof typeof screens, theme: keyof typeof papers }} Look */

/** @type {readonly Look[]} */
export const looks = [
  { screen: "wide", theme: "light" },
  { screen: "wide", theme: "dark" },
  { screen: "phone", theme: "light" },
  { screen: "phone", theme: "dark" },
];

/** Leaves of the page only what the renderer draws, on nothing. */
const onlyPicture = `
  html, body, .stage { background: none !important; }
  body * { visibility: hidden; }
  .picture { visibility: visible; }
  *:focus { outline: none !important; }
`;

/** Builds the page. */
export async function buildPlates() {
  await build({ logLevel: "error", build: { outDir: platesFolder } });
}

/**
 * Compares every preset, or writes their pictures anew.
 * @param {Look} look
 * @param {boolean} update
 * @returns {Promise<string>} how many there are, and which differs most
 */
export async function comparePlates(look, update) {
  const server = await preview({
    logLevel: "error",
    build: { outDir: platesFolder },
    preview: { host: "127.0.0.1", port: 0 },
  });
  const browser = await launchChromium();
  try {
    const { module } = await runnerImport(join(root, "web/src/params/declaration.ts"));
    const { width, height } = screens[look.screen];
    const context = await browser.newContext({
      viewport: { width, height },
      deviceScaleFactor: 1,
      reducedMotion: "reduce",
      bypassCSP: true,
    });
    const ids = Object.keys(module.presets);
    /** @type {Plate[]} */
    const plates = [];
    for (const id of ids) {
      const page = await context.newPage();
      plates.push(await plate(page, server.resolvedUrls?.local[0] ?? "", id, look, update));
      await page.close();
    }
    return await judged(plates, look);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @typedef {{ name: string, most: number, mean: number, picture: Buffer }} Plate */

/**
 * @param {import("playwright").Page} page
 * @param {string} site
 * @param {string} id
 * @param {Look} look
 * @param {boolean} update
 * @returns {Promise<Plate>}
 */
async function plate(page, site, id, { screen, theme }, update) {
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    const said = complaint(message);
    if (said) errors.push(said);
  });
  await page.goto(`${site}?preset=${id}&theme=${theme}`);
  await page.addStyleTag({ content: onlyPicture });
  await page.waitForFunction(() => document.documentElement.dataset.settled === "true");
  if (errors.length > 0) throw new Obstacle(`${page.url()} is not without errors:\n${errors.join("\n")}`);
  const shot = await page
    .locator("canvas.picture")
    .screenshot({ omitBackground: true, animations: "disabled" });
  const name = `${id}-${screen}-${theme}`;
  const file = join(golden, `${name}.webp`);
  const present = /** @type {const} */ ({
    picture: shot.toString("base64"),
    by: screens[screen].by,
    paper: papers[theme],
    type: "image/webp",
  });
  if (update || !existsSync(file)) {
    if (!update)
      throw new Obstacle(`There is no golden picture ${name}.`, { remedy: "npm run visual -- --update" });
    await mkdir(golden, { recursive: true });
    const { picture } = await page.evaluate(shrunk, { ...present, size: null });
    await writeFile(file, Buffer.from(picture, "base64"));
  }
  const kept = (await readFile(file)).toString("base64");
  const before = await page.evaluate(decoded, kept);
  // To the same size: another font may make the timeline a pixel higher, and the picture as much lower.
  const now = await page.evaluate(shrunk, { ...present, size: before.size });
  return { name, ...difference(before.colors, now.colors), picture: shot };
}

/**
 * Runs in a page.
 * @param {string} picture
 */
async function decoded(picture) {
  const image = new Image();
  image.src = `data:;base64,${picture}`;
  await image.decode();
  const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
  pen?.drawImage(image, 0, 0);
  const colors = [...(pen?.getImageData(0, 0, image.width, image.height).data ?? [])];
  return { size: /** @type {[number, number]} */ ([image.width, image.height]), colors };
}

/**
 * @param {readonly Plate[]} plates
 * @param {Look} look
 */
async function judged(plates, { screen, theme }) {
  const others = plates.filter((one) => !isSame(one));
  if (others.length > 0) {
    const folder = await mkdtemp(join(tmpdir(), "bough-visual-"));
    for (const { name, picture } of others) await writeFile(join(folder, `${name}.png`), picture);
    const lines = others.map(
      ({ name, most, mean }) => `${name}: ${most} at most, ${mean.toFixed(2)} on average`,
    );
    const may = `They may differ by ${limits.most} of 255 in a pixel and by ${limits.mean} on average.`;
    throw new Obstacle(
      `These look other than they did; they are in ${folder}.\n${lines.join("\n")}\n${may}`,
      {
        remedy: "look at them; if it is meant: npm run visual -- --update",
      },
    );
  }
  const [worst] = plates.toSorted((a, b) => b.most - a.most);
  const found =
    worst &&
    `${worst.name} differs most: ${worst.most} of 255 in a pixel (${limits.most} may be), ${worst.mean.toFixed(3)} on average (${limits.mean})`;
  return `${plates.length} plates, ${screen} and ${theme}; ${found}`;
}
