// Opening the page for the first time: a new browser with nothing in its caches, each time.

const loads = 7;

/** @type {import("./figure.mjs").Measurement} */
export async function* loading(site, launch) {
  /** @type {number[][]} */
  const [visible = [], script = [], longest = []] = [[], [], []];
  for (let load = 0; load < loads; load++) {
    const browser = await launch();
    try {
      const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
      const session = await page.context().newCDPSession(page);
      await session.send("Performance.enable");
      await page.addInitScript(watchFirstPlant);
      await page.goto(site);
      const seen = await page.evaluate(() => /** @type {any} */ (window).firstPlant);
      visible.push(seen.visible);
      longest.push(seen.longest);
      const { metrics } = await session.send("Performance.getMetrics");
      script.push(1000 * (metrics.find(({ name }) => name === "ScriptDuration")?.value ?? Number.NaN));
    } finally {
      await browser.close();
    }
  }
  yield { name: "first plant visible, cold", values: visible, unit: "ms" };
  yield { name: "longest task before it", values: longest, unit: "ms" };
  yield { name: "scripts up to it", values: script, unit: "ms" };
}

/** Runs in the page before its own code. A picture counts as visible when the frame after it begins: then it is on the screen. */
function watchFirstPlant() {
  let longest = 0;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longest = Math.max(longest, duration);
  }).observe({ type: "longtask" });
  /** @type {any} */ (window).firstPlant = new Promise((resolve) => {
    const onDrawn = () => requestAnimationFrame(() => resolve({ visible: performance.now(), longest }));
    document.addEventListener("bough-drawn", onDrawn, { once: true });
  });
}
