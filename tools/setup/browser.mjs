// A Chromium for the browser tests: one that is here, else Debian's package, else playwright's download.

import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { nodeCommand } from "../commands.mjs";
import { Obstacle } from "../obstacle.mjs";
import { runCommand } from "../run-command.mjs";
import { aptInstall, isDebian, isRoot } from "./apt.mjs";

const commands = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const applications = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  join(process.env.PROGRAMFILES ?? "", "Google", "Chrome", "Application", "chrome.exe"),
];

/** @returns {Promise<string | undefined>} path of the browser's executable */
export async function findBrowser() {
  const { CHROME_PATH: chosen, PATH: path = "" } = process.env;
  if (chosen) {
    if (existsSync(chosen)) return chosen;
    throw new Obstacle(`CHROME_PATH is “${chosen}”, and there is no such file.`);
  }
  const onPath = path.split(delimiter).flatMap((folder) => commands.map((command) => join(folder, command)));
  return [...onPath, ...applications, await downloadedBrowser()].find(existsSync);
}

export async function requireBrowser() {
  if (await findBrowser()) return;
  if (isDebian() && isRoot()) {
    await aptInstall("installing Chromium for the browser tests", ["chromium"]);
    return;
  }
  const install = [...nodeCommand("playwright"), "install", "chromium"];
  await runCommand("downloading Chromium for the browser tests", install, {
    limit: 300,
    remedy: isDebian() ? "sudo apt-get install chromium" : "install Chrome, or set CHROME_PATH to one",
  });
}

/** Imported when it is needed: this file is read before the node packages are there. */
async function downloadedBrowser() {
  const { chromium } = await import("playwright");
  return chromium.executablePath();
}
