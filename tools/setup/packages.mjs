// Installs the node packages when they are missing or package-lock.json has changed since.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { npm } from "../commands.mjs";
import { root } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";

const stamp = join(root, "node_modules", ".bough-lock");

export async function installPackages() {
  const wanted = lockFingerprint();
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  await runCommand("installing node packages", [...npm(), "ci", "--no-audit", "--no-fund"], {
    remedy: "npm ci",
  });
  writeFileSync(stamp, wanted);
}

/** Some packages are compiled for one platform, so a folder shared between two machines is not up to date on both. */
function lockFingerprint() {
  const lock = readFileSync(join(root, "package-lock.json"));
  return `${process.platform} ${process.arch} ${createHash("sha256").update(lock).digest("hex")}`;
}
