// The site: static files in dist/site that can be served from any folder of any host.

import { buildWidget } from "./build-widget.mjs";
import { nodeCommand } from "./commands.mjs";
import { runCommand } from "./run-command.mjs";

export async function buildSite() {
  await runCommand("building the site", [...nodeCommand("vite"), "build"]);
  await buildWidget();
}
