// The site for shards that open it, built anew only when its sources have changed: other shards may be reading it.

import { existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { buildSite } from "../build-site.mjs";
import { root, site } from "../paths.mjs";
import { fingerprintOf } from "../setup/fingerprint.mjs";

const file = join(root, "dist", "soak-site.json");
// Not the docs: shards add evidence to them, and open none.
const sources = ["rust-core", "web", "public", "tools", "vite.config.ts", "package-lock.json"];

export async function haveSite() {
  const fingerprint = fingerprintOf(
    sources.map((path) => join(root, path)),
    { tests: true },
  );
  if (existsSync(file) && readFileSync(file, "utf8") === stamp(fingerprint)) return;
  await buildSite();
  writeFileSync(file, stamp(fingerprint));
}

/**
 * Whoever else builds the site makes another stamp of it.
 * @param {string} fingerprint
 */
function stamp(fingerprint) {
  const page = join(site, "index.html");
  return JSON.stringify({ fingerprint, built: existsSync(page) ? statSync(page).mtimeMs : null });
}
