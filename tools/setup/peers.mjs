// Programs of other people that Bough is tried or measured with, installed when they are first needed, by the locked versions
// of a folder: into its node_modules and its .venv.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { npm } from "../commands.mjs";
import { runCommand } from "../run-command.mjs";

/**
 * What package-lock.json of the folder names.
 * @param {string} folder
 * @param {string} what for people
 * @returns {Promise<string>} where the packages are
 */
export async function installFromNpm(folder, what) {
  const packages = join(folder, "node_modules");
  await once(join(folder, "package-lock.json"), join(packages, ".made-from"), async () => {
    const install = [...npm(), "ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    await runCommand(`installing ${what} from npm`, install, { cwd: folder });
  });
  return packages;
}

/**
 * What requirements.txt of the folder names.
 * @param {string} folder
 * @param {string} what for people
 * @returns {Promise<string>} the Python that has them
 */
export async function installFromPyPi(folder, what) {
  const environment = join(folder, ".venv");
  const python = join(environment, process.platform === "win32" ? "Scripts/python.exe" : "bin/python");
  const requirements = join(folder, "requirements.txt");
  await once(requirements, join(environment, ".made-from"), async () => {
    await runCommand("making a Python environment", ["python3", "-m", "venv", environment]);
    const install = [python, "-m", "pip", "install", "--quiet", "--requirement", requirements];
    await runCommand(`installing ${what} from PyPI`, install);
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
