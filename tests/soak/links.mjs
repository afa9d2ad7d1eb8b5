// Opens damaged links in the built page, one by one as a person would, and fails if one of them breaks it.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { preview } from "vite";
import { launchChromium } from "../../tools/chromium.mjs";
import { root } from "../../tools/paths.mjs";

const kept = readFileSync(join(root, "tests", "unit", "links-v1.jsonl"), "utf8")
  .trim()
  .split("\n");
const links = kept.map((line) => /** @type {string} */ (JSON.parse(line).link));

/** Every so manieth with the picture: it takes most of the time, and knows nothing of links. */
const drawn = 50;

/**
 * @param {string} outDir the built page
 * @param {number} first
 * @param {number} count
 * @returns {Promise<string>} what was found
 */
export async function openDamagedLinks(outDir, first, count) {
  const server = await preview({
    logLevel: "error",
    build: { outDir },
    preview: { host: "127.0.0.1", port: 0 },
  });
  const browser = await launchChromium();
  const site = server.resolvedUrls?.local[0] ?? "";
  let repaired = 0;
  try {
    const [bare, whole] = await Promise.all([open(browser, false), open(browser, true)]);
    for (let number = first; number < first + count; number++) {
      const visit = number % drawn === 0 ? whole : bare;
      const link = damaged(number);
      visit.errors.length = 0;
      await visit.page.goto(site + link);
      const found = await visit.page.evaluate(look);
      const problem = visit.errors[0] ?? found.problem;
      if (problem) throw new Error(`Link ${number} breaks the page: ${JSON.stringify(link)}: ${problem}`);
      if (found.notices > 0) repaired++;
    }
  } finally {
    await browser.close();
    await server.close();
  }
  return `${count} damaged links: each opens a page with a plant and its controls; ${repaired} are told to be damaged`;
}

/**
 * @param {import("playwright").Browser} browser
 * @param {boolean} draws
 */
async function open(browser, draws) {
  const context = await browser.newContext({ reducedMotion: "reduce" });
  await context.route("**/presets/*", (route) => route.fulfill({ body: "" }));
  const page = await context.newPage();
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    // That there is no picture is said by three, too.
    const isExpected = !draws && message.text().startsWith("THREE.WebGLRenderer");
    if (message.type() === "error" && !isExpected) errors.push(message.text());
  });
  if (!draws) {
    await page.addInitScript(() => {
      Object.defineProperty(HTMLCanvasElement.prototype, "getContext", { value: () => null });
    });
  }
  return { page, errors };
}

/** Runs in the page: waits until a plant is there, or is seen to grow, and looks whether all else is. */
async function look() {
  const texts = () => [...document.querySelectorAll(".notice")].map((one) => one.textContent?.trim() ?? "");
  const own = () => texts().filter((text) => !text.includes("draws no 3D pictures"));
  const isThere = () =>
    document.documentElement.dataset.settled === "true" || document.querySelector(".progress") !== null;
  const fails = () => own().find((text) => text.includes("could not be"));
  while (!isThere() && !fails()) await new Promise((resolve) => setTimeout(resolve, 5));
  const boxes = document.querySelectorAll("bough-field input").length;
  const problem = fails() ?? (boxes < 20 ? `there are but ${boxes} controls` : null);
  return { problem, notices: own().length };
}

/**
 * A link that was kept, with some of its characters lost, doubled, swapped or replaced.
 * @param {number} number the same number is the same link
 */
function damaged(number) {
  const random = randomFrom(number);
  const pick = (/** @type {number} */ size) => Math.floor(random() * size);
  let text = links[pick(links.length)] ?? "";
  const signs = "&=?%.,-+eE0123456789 abcgnlv\u0000\u00e9\ud83c\udf33\"'<>#;/\\";
  for (let hit = 1 + pick(6); hit > 0; hit--) {
    const at = 1 + pick(text.length);
    const sign = signs[pick(signs.length)] ?? "";
    const cut = 1 + pick(4);
    const ways = [
      () => text.slice(0, at) + text.slice(at + cut),
      () => text.slice(0, at) + sign + text.slice(at),
      () => text.slice(0, at) + sign + text.slice(at + 1),
      () => text + text.slice(at),
      () => `${text}&${links[pick(links.length)]?.slice(1)}`,
      () => text.slice(0, at),
      () => text.replace(/\d+/, () => "9".repeat(1 + pick(30))),
    ];
    text = (ways[pick(ways.length)] ?? ways[0])?.() ?? text;
  }
  return text.slice(0, 3000);
}

/**
 * Random numbers from 0 to 1, the same for the same seed (mulberry32).
 * @param {number} seed
 */
function randomFrom(seed) {
  let state = (seed + 1) * 0x9e3779b9;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
