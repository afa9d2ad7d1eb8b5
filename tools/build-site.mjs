// The site: static files in dist/site that can be served from any folder of any host.

import { join } from "node:path";
import { buildWidget } from "./build-widget.mjs";
import { bundle } from "./bundle.mjs";
import { nodeCommand } from "./commands.mjs";
import { root, site } from "./paths.mjs";
import { runCommand } from "./run-command.mjs";

export async function buildSite() {
  await runCommand("building the site", [...nodeCommand("vite"), "build"]);
  await buildWidget();
  await buildCourseScript();
  // It needs packages, which set-up may have to install before.
  const { buildDocs } = await import("./build-docs.mjs");
  await buildDocs();
}

/** As one plain script: pages that are opened from a folder can load no modules. */
async function buildCourseScript() {
  const entry = join(root, "web", "src", "course", "main.ts");
  await bundle({
    root: join(root, "web"),
    build: {
      outDir: join(site, "course"),
      emptyOutDir: false,
      lib: { entry, formats: ["iife"], name: "course", fileName: () => "course.js" },
    },
  });
}
