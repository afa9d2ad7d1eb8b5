// Makes a fresh clone ready: node packages, the core as wasm, and for tests a browser. Each part is quick when nothing changed.

import { requireBrowser } from "./setup/browser.mjs";
import { buildCore } from "./setup/core.mjs";
import { requireNode } from "./setup/node-version.mjs";
import { installPackages } from "./setup/packages.mjs";

export async function setUp() {
  requireNode();
  await installPackages();
  await buildCore();
}

export async function setUpForTests() {
  await setUp();
  await requireBrowser();
}
