// The one place that starts a browser.

import { chromium } from "playwright";
import { findBrowser } from "./setup/browser.mjs";

/**
 * What a whole browser does for its own windows, and what would wait for other hosts: without the first, which are pages of
 * their own behind the address bar, a visit takes half the time. Of one switch the last counts, so what playwright turns off
 * and matters here stands in the list too.
 */
const withoutFeatures = [
  "WebUIOmniboxPopup",
  "WebUIOmniboxAimPopup",
  "WebUIOmniboxFullPopup",
  "AimEnabled",
  "AvoidUnnecessaryBeforeUnloadCheckSync",
  "DestroyProfileOnBrowserClose",
  "HttpsFirstBalancedModeAutoEnable",
  "HttpsUpgrades",
  "LensOverlay",
  "MediaRouter",
  "NetworkTimeServiceQuerying",
  "OptimizationHints",
  "PaintHolding",
  "PreconnectToSearch",
  "ThirdPartyStoragePartitioning",
];

/**
 * WebGL without a GPU, and none of the calls home that a closed network would refuse one by one. WebGL alone is left to the
 * software that stands in for the GPU: the rest of the page is faster without it.
 */
const flags = [
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-gpu-compositing",
  `--disable-features=${withoutFeatures}`,
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** What the browser says of itself on a page's console, and no fault of the page. */
const itsOwn = [
  // Playwright, asked to.
  /^Service Worker registration blocked by Playwright/,
  // The software that puts the page together reads the canvas back.
  /GPU stall due to ReadPixels/,
];

/**
 * What a page complains of by a message on its console: an error or a warning that is not the browser's own.
 * @param {import("playwright").ConsoleMessage} message
 * @returns {string | null}
 */
export function complaint(message) {
  const text = message.text();
  const isOne = ["error", "warning"].includes(message.type()) && !itsOwn.some((own) => own.test(text));
  return isOne ? `${message.type()}: ${text}` : null;
}

/** @param {readonly string[]} more flags that only some need */
export async function launchChromium(more = []) {
  const executablePath = await findBrowser();
  if (!executablePath) throw new Error("There is no Chrome or Chromium; `npm test` finds or installs one.");
  // Chromium's sandbox refuses to run as root, which containers and CI machines mostly are.
  const asRoot = process.getuid?.() === 0;
  return chromium.launch({ executablePath, args: [...flags, ...more], chromiumSandbox: !asRoot });
}
