// The page while nobody touches it: every animation frame asked for, and every call that draws.

import { settled } from "./figure.mjs";

const seconds = 5;

/** @type {import("./figure.mjs").Measurement} */
export async function* resting(site, launch) {
  const browser = await launch();
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    await page.addInitScript(count);
    await page.goto(site);
    await settled(page);
    const before = await page.evaluate(() => ({ .../** @type {any} */ (window).counted }));
    await page.waitForTimeout(1000 * seconds);
    const after = await page.evaluate(() => ({ .../** @type {any} */ (window).counted }));
    const inWords = { frames: "animation frames", draws: "draw calls" };
    for (const [key, words] of Object.entries(inWords)) {
      if (!(before[key] > 0)) throw new Error(`No ${words} were counted while the plant grew.`);
      yield { name: `${words} in ${seconds} s at rest`, values: [after[key] - before[key]], unit: "" };
    }
  } finally {
    await browser.close();
  }
}

/** Runs in the page before its own code. */
function count() {
  const counted = { frames: 0, draws: 0 };
  /** @type {any} */ (window).counted = counted;
  const request = requestAnimationFrame;
  window.requestAnimationFrame = (callback) => {
    counted.frames++;
    return request.call(window, callback);
  };
  const drawing = /** @type {any} */ (WebGL2RenderingContext.prototype);
  for (const name of Object.getOwnPropertyNames(drawing)) {
    if (!/^(draw|clear$|blitFramebuffer)/.test(name) || name === "drawingBufferColorSpace") continue;
    const { value } = Object.getOwnPropertyDescriptor(drawing, name) ?? {};
    if (typeof value !== "function") continue;
    drawing[name] = function (/** @type {unknown[]} */ ...args) {
      counted.draws++;
      return value.apply(this, args);
    };
  }
}
