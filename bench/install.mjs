// What Bough is measured against, installed when it is first needed: bench/node_modules and bench/.venv, by the locked versions.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { npm } from "../tools/commands.mjs";
import { root } from "../tools/paths.mjs";
import { runCommand } from "../tools/run-command.mjs";

const folder = join(root, "bench");
const environment = join(folder, ".venv");

export async function installNodePeers() {
  await once(join(folder, "package-lock.json"), join(folder, "node_modules", ".made-from"), async () => {
    const install = [...npm(), "ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    await runCommand("installing the peers from npm", install, { cwd: folder });
  });
}

/** @returns {Promise<string>} the Python that has the peers */
export async function installPythonPeers() {
  const python = join(environment, process.platform === "win32" ? "Scripts/python.exe" : "bin/python");
  const requirements = join(folder, "requirements.txt");
  await once(requirements, join(environment, ".made-from"), async () => {
    await runCommand("making a Python environment", ["python3", "-m", "venv", environment]);
    const install = [python, "-m", "pip", "install", "--quiet", "--requirement", requirements];
    await runCommand("installing the peers from PyPI", install);
  });
  return python;
}

/**
 * @param {string} lock
 * @param {string} stamp
 * @param {() => Promise<void>} install
 */
async function once(lock, stamp, install) {
  const wanted = createHash("sha256").update(readFileSync(lock)).digest("hex");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  await install();
  writeFileSync(stamp, wanted);
}
