// The one place that starts a browser.

import { chromium } from "playwright";
import { findBrowser } from "./setup/browser.mjs";

/** WebGL without a GPU, and none of the calls home that a closed network would refuse one by one. */
const flags = [
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** @param {readonly string[]} more flags that only some need */
export async function launchChromium(more = []) {
  const executablePath = await findBrowser();
  if (!executablePath) throw new Error("There is no Chrome or Chromium; `npm test` finds or installs one.");
  // Chromium's sandbox refuses to run as root, which containers and CI machines mostly are.
  const asRoot = process.getuid?.() === 0;
  return chromium.launch({ executablePath, args: [...flags, ...more], chromiumSandbox: !asRoot });
}
