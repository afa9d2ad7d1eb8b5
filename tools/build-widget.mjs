// The widget, three times over: embed.html for frames, bough-plant.js as a module that loads its parts when they are
// wanted, and bough-widget.js, one script with everything inside. All lie in dist/site; none of it goes into the npm package.

import { join } from "node:path";
import { bundle } from "./bundle.mjs";
import { leanThree } from "./lean-three.mjs";
import { root, site } from "./paths.mjs";

const source = join(root, "web");
const element = join(source, "src", "element");

export async function buildWidget(outDir = site) {
  const shared = { root: source, base: "./" };
  const kept = { outDir, emptyOutDir: false, chunkSizeWarningLimit: Number.POSITIVE_INFINITY };
  await bundle({
    ...shared,
    plugins: [leanThree(), withoutGlobals()],
    build: {
      ...kept,
      assetsDir: "embed",
      // Its parts are few: to fetch them ahead would only take more code.
      modulePreload: false,
      rollupOptions: {
        input: { embed: join(source, "embed.html"), "bough-plant": join(element, "module.ts") },
        output: {
          entryFileNames: ({ name }) => (name === "bough-plant" ? "[name].js" : "embed/[name]-[hash].js"),
        },
      },
    },
  });
  await bundle({
    ...shared,
    plugins: wholeWidget(),
    build: {
      ...kept,
      lib: {
        entry: join(element, "one-file.ts"),
        formats: ["iife"],
        name: "bough",
        fileName: () => "bough-widget.js",
      },
      rollupOptions: { output: { codeSplitting: false } },
    },
  });
}

/** What makes one file of the element, with everything inside. */
export function wholeWidget() {
  return [leanThree(), withoutGlobals(), wasmInside(), plainLetters()];
}

/**
 * three tells the page of itself by a global, and complains where there are two of it. A guest does neither.
 * @returns {import("vite").Plugin}
 */
function withoutGlobals() {
  const registration =
    /if \( typeof window !== 'undefined' \) \{\s*if \( window\.__THREE__ \) \{[\s\S]*?= REVISION;\s*\}\s*\}/;
  return {
    name: "bough-without-globals",
    enforce: "pre",
    transform: (code, id) => {
      if (!code.includes("window.__THREE__ =")) return null;
      if (!registration.test(code)) throw new Error(`${id} makes its global in another way than before.`);
      return { code: code.replace(registration, ""), map: null };
    },
  };
}

/**
 * Writes all letters in ASCII: a page that does not say its encoding would read others wrongly.
 * @returns {import("vite").Plugin}
 */
function plainLetters() {
  return {
    name: "bough-plain-letters",
    generateBundle: (_, bundle) => {
      for (const file of Object.values(bundle)) {
        if (file.type !== "chunk") continue;
        file.code = file.code.replace(
          /[^\0-\x7f]/g,
          (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`,
        );
      }
    },
  };
}

/**
 * Puts the wasm inside the code, where the source names the file beside it.
 * @returns {import("vite").Plugin}
 */
function wasmInside() {
  return {
    name: "bough-wasm-inside",
    enforce: "pre",
    resolveId: (id) => (id === "./source.ts" ? join(element, "inside.ts") : null),
  };
}
