// node bench/page.mjs: what the page costs a person's machine, on the built site in real Chromium without a GPU. Prints one line
// of JSON a figure: {"name", "median", "min", "max", "unit"}.

import { join } from "node:path";
import { build, preview } from "vite";
import { launchChromium } from "../tools/chromium.mjs";
import { root } from "../tools/paths.mjs";
import { changing } from "./page/changing.mjs";
import { loading } from "./page/loading.mjs";
import { resting } from "./page/resting.mjs";

process.chdir(root);
// In a folder of its own: the built site may be in use.
const outDir = join(root, "dist", "bench-page");
/** @type {import("vite").InlineConfig} */
const shared = { configFile: join(root, "vite.config.ts"), logLevel: "error" };
await build({ ...shared, build: { outDir } });
const server = await preview({ ...shared, build: { outDir }, preview: { host: "127.0.0.1", port: 0 } });
try {
  const site = server.resolvedUrls?.local[0] ?? "";
  for (const measure of [loading, changing, resting]) {
    for await (const { name, values, unit } of measure(site, launchChromium)) {
      const sorted = values.toSorted((a, b) => a - b);
      const at = (/** @type {number} */ share) =>
        rounded(sorted[Math.round(share * (sorted.length - 1))] ?? 0);
      console.log(JSON.stringify({ name, median: at(0.5), min: at(0), max: at(1), unit }));
    }
  }
} finally {
  await server.close();
}

/** @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(3));
}
