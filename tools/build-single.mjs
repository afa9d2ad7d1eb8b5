// npm run build:single: the explorer as one HTML file, dist/single/bough.html. It works from a memory stick by a double click:
// scripts, styles, pictures and the wasm are inside, and its policy allows just the one script and the one style that it has.

import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { bundle } from "./bundle.mjs";
import { leanThree } from "./lean-three.mjs";
import { orExplain } from "./obstacle.mjs";
import { generated, root } from "./paths.mjs";
import { setUp } from "./setup.mjs";

const source = join(root, "web");
const shared = join(root, "public");

/**
 * Builds it; the path of the file.
 * @param {string} folder
 */
export async function buildSingle(folder = join(root, "dist", "single")) {
  const { script, style } = await joined();
  const html = page(script, style);
  mkdirSync(folder, { recursive: true });
  const file = join(folder, "bough.html");
  writeFileSync(file, html);
  return file;
}

/** All of the page's code in one script, all of its style in one sheet. */
async function joined() {
  const built = await bundle({
    root: source,
    plugins: [leanThree(), inside("./thumbnails.ts", pictures), inside("./analysis-place.ts", analysis)],
    build: {
      write: false,
      modulePreload: false,
      cssCodeSplit: false,
      rolldownOptions: {
        input: join(source, "src", "explorer", "single.ts"),
        output: { codeSplitting: false },
      },
    },
  });
  const files = [built].flat().flatMap((one) => ("output" in one ? one.output : []));
  const scripts = files.filter((file) => file.type === "chunk").map(({ code }) => code);
  const sheets = files.flatMap((file) =>
    file.type === "asset" && file.fileName.endsWith(".css") ? [file.source] : [],
  );
  const [script, ...others] = scripts;
  if (script === undefined || others.length > 0)
    throw new Error(`There are ${scripts.length} scripts in the single file.`);
  // Imported where the tag in index.html links it.
  const page = await bundle({
    root: source,
    build: { write: false, rolldownOptions: { input: join(source, "src", "style", "page.css") } },
  });
  const main = [page].flat().flatMap((one) => ("output" in one ? one.output : []));
  const base = main.flatMap((file) =>
    file.type === "asset" && file.fileName.endsWith(".css") ? [file.source] : [],
  );
  return {
    // Neither may end its own tag.
    script: script.trim().replaceAll("</script", "<\\/script"),
    style: [...base, ...sheets].join("\n").trim(),
  };
}

/**
 * @param {string} script
 * @param {string} style
 */
function page(script, style) {
  const icon = `data:image/svg+xml;base64,${readFileSync(join(shared, "favicon.svg")).toString("base64")}`;
  const policy = [
    "default-src 'none'",
    `script-src '${hashOf(script)}' 'wasm-unsafe-eval'`,
    `style-src '${hashOf(style)}'`,
    "img-src data: blob:",
    "base-uri 'none'",
    "form-action 'none'",
    "require-trusted-types-for 'script'",
    "trusted-types lit-html",
  ].join("; ");
  /** @type {readonly (readonly [what: RegExp, by: string])[]} */
  const changes = [
    [/content="default-src[^"]*"/, `content="${policy}"`],
    [/href="favicon\.svg"/, `href="${icon}"`],
    [/ *<link rel="(?:manifest|apple-touch-icon)"[^>]*>\n/g, ""],
    [/<link rel="stylesheet"[^>]*>/, `<style>${style}</style>`],
    [/ *<script type="module"[^>]*><\/script>\n/, ""],
    [/<\/body>/, `<script type="module">${script}</script>\n  </body>`],
  ];
  let html = readFileSync(join(source, "index.html"), "utf8");
  for (const [what, by] of changes) {
    if (html.search(what) < 0) throw new Error(`index.html has no ${what} any more.`);
    html = html.replace(what, () => by);
  }
  return html;
}

/** @param {string} text */
function hashOf(text) {
  return `sha256-${createHash("sha256").update(text).digest("base64")}`;
}

/**
 * Puts a module that is made here in the place of one that names files beside the page.
 * @param {string} place as it is imported
 * @param {() => string} made
 * @returns {import("vite").Plugin}
 */
function inside(place, made) {
  const name = `\0bough-inside-${place}`;
  return {
    name: `bough-inside-${place}`,
    enforce: "pre",
    resolveId: (id) => (id === place ? name : null),
    load: (id) => (id === name ? made() : null),
  };
}

/** The gallery's pictures themselves. */
function pictures() {
  const folder = join(shared, "presets");
  const all = readdirSync(folder).map((file) => [
    file.replace(/\.webp$/, ""),
    `data:image/webp;base64,${readFileSync(join(folder, file)).toString("base64")}`,
  ]);
  return `const all = ${JSON.stringify(Object.fromEntries(all))};
    export const thumbnailOf = (id) => all[id ?? "default"] ?? "";`;
}

/** The wasm that studies a plant, as the core's is in `bough-base64.ts`; it works in the page's own thread. */
function analysis() {
  const packed = gzipSync(readFileSync(join(generated, "bough-analysis.wasm")), { level: 9 });
  return `import { unpacked } from ${JSON.stringify(join(source, "src", "engine", "inline.ts"))};
    export const analysisSource = () => unpacked("${packed.toString("base64")}");
    export const openAnalysisWorker = () => null;`;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  await orExplain(async () => {
    await setUp();
    console.log(await buildSingle());
  });
}
