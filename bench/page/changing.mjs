// A slider over a plant of 200 segments: from the hand to the frame, and what the page's own thread does for it.

import { settled } from "./figure.mjs";

const changes = 60;
/** As fast as a held key repeats. ms */
const repeat = 33;

/** @type {import("./figure.mjs").Measurement} */
export async function* changing(site, launch) {
  const browser = await launch();
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });
    await page.addInitScript(watchChanges);
    await page.goto(`${site}?n=200&l=0.0075`);
    await settled(page);
    const session = await page.context().newCDPSession(page);
    // Time on the processor: what other processes take (the pictures are drawn without a GPU) does not count.
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    yield* dragged(page, session);
    yield* heldDown(page);
  } finally {
    await browser.close();
  }
}

/**
 * The thumb is dragged, each move answered before the next.
 * @param {import("playwright").Page} page
 * @param {import("playwright").CDPSession} session
 * @returns {AsyncGenerator<import("./figure.mjs").Figure>}
 */
async function* dragged(page, session) {
  const track = await slider(page).boundingBox();
  if (!track) throw new Error("There is no slider.");
  const move = (/** @type {number} */ k) =>
    page.mouse.move(track.x + track.width * (0.3 + 0.03 * (k % 8)), track.y + track.height / 2);
  await move(0);
  await page.mouse.down();
  /** @type {{ frame: number, trip: number, all: number, own: number }[]} */
  const seen = [];
  // The first ten are to warm up.
  for (let k = 1; k <= changes + 10; k++) {
    const before = await costs(session);
    await page.evaluate(() => /** @type {any} */ (window).nextChange());
    await move(k);
    const { frame, trip } = await page.evaluate(() => /** @type {any} */ (window).change);
    const after = await costs(session);
    if (k > 10) seen.push({ frame, trip, all: after.all - before.all, own: after.own - before.own });
  }
  await page.mouse.up();
  await settled(page);
  const column = (/** @type {"frame" | "trip" | "all" | "own"} */ name) => seen.map((one) => one[name]);
  yield { name: "parameter change to painted frame, 200 segments", values: column("frame"), unit: "ms" };
  yield { name: "main thread: scripts, style and layout, a change", values: column("own"), unit: "ms" };
  yield { name: "main thread: these, painting and all else", values: column("all"), unit: "ms" };
  yield { name: "worker round trip, 200 segments", values: column("trip"), unit: "ms" };
}

/**
 * A key held down: every press must count.
 * @param {import("playwright").Page} page
 * @returns {AsyncGenerator<import("./figure.mjs").Figure>}
 */
async function* heldDown(page) {
  await slider(page).press("Home");
  await settled(page);
  const first = await value(page);
  const began = performance.now();
  for (let press = 0; press < changes; press++) {
    await page.keyboard.down("ArrowRight");
    const due = began + (press + 1) * repeat;
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, due - performance.now())));
  }
  await page.keyboard.up("ArrowRight");
  await settled(page);
  const step = Number(await slider(page).getAttribute("step"));
  const counted = Math.round(((await value(page)) - first) / step);
  yield { name: `dropped inputs of ${changes} at 30 a second`, values: [changes - counted], unit: "" };
}

/** @param {import("playwright").Page} page */
function slider(page) {
  return page.getByRole("slider", { name: "Gravity, slider" });
}

/** @param {import("playwright").Page} page */
function value(page) {
  return slider(page).evaluate((slider) => /** @type {any} */ (slider).valueAsNumber);
}

/**
 * What the page's thread has spent so far, ms.
 * @param {import("playwright").CDPSession} session
 */
async function costs(session) {
  const { metrics } = await session.send("Performance.getMetrics");
  const spent = (/** @type {string} */ wanted) =>
    1000 * (metrics.find(({ name }) => name === wanted)?.value ?? Number.NaN);
  return {
    all: spent("TaskDuration"),
    own: spent("ScriptDuration") + spent("RecalcStyleDuration") + spent("LayoutDuration"),
  };
}

/** Runs in the page before its own code. A picture counts as painted when the frame after it begins. */
function watchChanges() {
  const own = /** @type {any} */ (window);
  let asked = Number.NaN;
  let trip = Number.NaN;
  const { postMessage } = Worker.prototype;
  const heard = new WeakSet();
  Worker.prototype.postMessage = function (/** @type {any} */ ...message) {
    if (message[0].kind === "plant") asked = performance.now();
    if (!heard.has(this)) {
      heard.add(this);
      this.addEventListener("message", ({ data }) => {
        if (data.kind === "shape") trip = performance.now() - asked;
      });
    }
    return postMessage.apply(this, /** @type {any} */ (message));
  };
  const once = { once: true, capture: true };
  own.nextChange = () => {
    own.change = new Promise((resolve) => {
      const onInput = (/** @type {Event} */ { timeStamp }) => {
        const onDrawn = () => requestAnimationFrame((now) => resolve({ frame: now - timeStamp, trip }));
        document.addEventListener("bough-drawn", onDrawn, once);
      };
      document.addEventListener("input", onInput, once);
    });
  };
}
