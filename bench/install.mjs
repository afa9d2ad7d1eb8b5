// What Bough is measured against: bench/node_modules and bench/.venv.

import { join } from "node:path";
import { root } from "../tools/paths.mjs";
import { installFromNpm, installFromPyPi } from "../tools/setup/peers.mjs";

const folder = join(root, "bench");

export async function installNodePeers() {
  await installFromNpm(folder, "the peers");
}

/** @returns {Promise<string>} the Python that has the peers */
export async function installPythonPeers() {
  return installFromPyPi(folder, "the peers");
}
