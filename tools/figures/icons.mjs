// The icons of the installed page: favicon.svg on paper, as systems want it.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { root } from "../paths.mjs";

/** File, size in px, and how much of the paper around the drawing is left free: systems cut maskable icons to their shape. */
const icons = /** @type {const} */ ([
  ["180.png", 180, 0.14],
  ["192.png", 192, 0.1],
  ["512.png", 512, 0.1],
  ["maskable.png", 512, 0.22],
]);

/** @param {import("playwright").Browser} browser */
export async function makeIcons(browser) {
  const folder = join(root, "public", "icons");
  await mkdir(folder, { recursive: true });
  const drawing = await readFile(join(root, "public", "favicon.svg"), "utf8");
  for (const [file, size, margin] of icons) {
    const page = await browser.newPage({ viewport: { width: size, height: size }, colorScheme: "light" });
    const style = `margin: 0; padding: ${margin * size}px; background: #f7f5ee`;
    await page.setContent(`<body style="${style}">${drawing.replace("<svg ", '<svg width="100%" ')}</body>`);
    await writeFile(join(folder, file), await page.screenshot());
    await page.close();
  }
}
