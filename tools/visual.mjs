// npm run visual: every preset in light and dark, wide and on a phone, as screenshots in a folder of the system's for temporary
// files, to be looked at. Fails if any of the pages says an error.

import { mkdtemp } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { preview, runnerImport } from "vite";
import { buildSite } from "./build-site.mjs";
import { launchChromium } from "./chromium.mjs";
import { Obstacle, orExplain } from "./obstacle.mjs";
import { root } from "./paths.mjs";
import { setUpForTests } from "./setup.mjs";

const screens = { wide: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };

await orExplain(async () => {
  await setUpForTests();
  await buildSite();
  const folder = await mkdtemp(join(tmpdir(), "bough-visual-"));
  const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "error" });
  const browser = await launchChromium();
  /** @type {string[]} */
  const errors = [];
  try {
    const { module } = await runnerImport(join(root, "web/src/params/declaration.ts"));
    for (const [screen, viewport] of Object.entries(screens)) {
      for (const theme of ["light", "dark"]) {
        const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
        page.on("pageerror", (error) => errors.push(`${page.url()}: ${error.message}`));
        page.on("console", (message) => {
          if (["error", "warning"].includes(message.type())) errors.push(`${page.url()}: ${message.text()}`);
        });
        for (const id of Object.keys(module.presets)) {
          await page.goto(`${server.resolvedUrls?.local[0]}?preset=${id}&theme=${theme}`);
          await page.waitForFunction(() => document.documentElement.dataset.settled === "true");
          await page.screenshot({ path: join(folder, `${id}-${screen}-${theme}.png`) });
        }
        await page.close();
      }
    }
  } finally {
    await browser.close();
    await server.close();
  }
  if (errors.length > 0) throw new Obstacle(`Not without errors:\n${errors.join("\n")}`);
  console.log(`All presets are in ${folder}`);
});
