// Debian's packages, by apt-get: only on Debian and only as root; otherwise the command for a person to run.

import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { Obstacle } from "../obstacle.mjs";
import { runCommand } from "../run-command.mjs";

/** Not Ubuntu and other children: their packages differ (Ubuntu's chromium is a snap). */
export function isDebian() {
  try {
    return /^ID="?debian"?$/m.test(readFileSync("/etc/os-release", "utf8"));
  } catch {
    return false;
  }
}

export function isRoot() {
  return process.getuid?.() === 0;
}

/** @param {readonly string[]} packages */
export function areInstalled(packages) {
  const { stdout } = spawnSync("dpkg-query", ["--status", ...packages], { encoding: "utf8" });
  return (stdout?.match(/^Status: install ok installed$/gm) ?? []).length === packages.length;
}

/**
 * @param {string} purpose
 * @param {readonly string[]} packages
 * @param {boolean} [mayInstall]
 */
export async function aptInstall(purpose, packages, mayInstall = isRoot()) {
  if (areInstalled(packages)) return;
  const names = packages.join(" ");
  if (!mayInstall) {
    throw new Obstacle(`${purpose} takes root, to install Debian's packages ${names}.`, {
      remedy: `sudo apt-get install ${names}`,
    });
  }
  const options = { env: { DEBIAN_FRONTEND: "noninteractive" }, remedy: `apt-get install ${names}` };
  const install = ["apt-get", "install", "--yes", "--no-install-recommends", ...packages];
  try {
    await runCommand(purpose, install, options);
  } catch {
    // A new machine has no package lists yet, an old one has stale ones.
    await runCommand("refreshing Debian's package lists", ["apt-get", "update"], options);
    await runCommand(purpose, install, options);
  }
}
