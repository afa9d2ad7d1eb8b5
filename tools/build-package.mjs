// The npm package: our TypeScript compiled file by file (Vite's library mode would inline the wasm), with the glue and
// the wasm beside it at the same relative places as in web/. Only the views' parts are put together: nobody imports them
// one by one, and together they take a third less. What the element and bough/three share is there once.

import {
  copyFileSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { bundle } from "./bundle.mjs";
import { nodeCommand } from "./commands.mjs";
import { generated, packageFolder, root } from "./paths.mjs";
import { runCommand } from "./run-command.mjs";

export async function buildPackage() {
  rmSync(packageFolder, { recursive: true, force: true });
  const tsc = nodeCommand("typescript", "tsc");
  await runCommand("building the npm package", [...tsc, "--project", "tsconfig.package.json"]);
  for (const file of ["bough.js", "bough.wasm"]) {
    copyFileSync(join(generated, file), join(packageFolder, "generated", file));
  }
  await joinViews();
  await minifyModules();
  dropInnerTypes();
}

/** The parts of the views that no other entry imports; the core's stay where they are, so that there is but one core. */
const ownParts = ["element", "form", "geometry", "language", "scene", "three"];
/** Whose folders hold entries. */
const views = ["element", "three"];

/** The element in parts (what every page needs at once, and what is loaded once a plant is wanted), and bough/three. */
async function joinViews() {
  const source = join(packageFolder, "src");
  const joined = join(packageFolder, "joined");
  const isOwn = (/** @type {string} */ id) => ownParts.includes(relative(source, id).split(sep)[0] ?? "");
  await bundle({
    root: packageFolder,
    plugins: [
      {
        name: "bough-one-core",
        enforce: "pre",
        async resolveId(id, importer) {
          const found = id.startsWith(".") ? await this.resolve(id, importer, { skipSelf: true }) : null;
          // All parts lie side by side: the path between two of them is the same from every file.
          return found && !isOwn(found.id) ? { id, external: true } : null;
        },
      },
    ],
    build: {
      outDir: joined,
      lib: {
        entry: Object.fromEntries(views.map((name) => [name, join(source, name, "index.js")])),
        formats: ["es"],
      },
      rollupOptions: {
        external: /^three(\/|$)/,
        output: { entryFileNames: "[name]/index.js", chunkFileNames: "scene/[name].js" },
      },
    },
  });
  for (const file of filesEndingWith(".js")) if (isOwn(file)) rmSync(file);
  for (const folder of readdirSync(joined)) {
    for (const file of readdirSync(join(joined, folder))) {
      mkdirSync(join(source, folder), { recursive: true });
      renameSync(join(joined, folder, file), join(source, folder, file));
    }
  }
  rmSync(joined, { recursive: true });
}

/** Nobody reads the code in a package, and comments are in the types, where editors look for them. */
async function minifyModules() {
  const { minifySync } = await import("vite");
  for (const file of filesEndingWith(".js")) {
    const { code, errors } = minifySync(file, readFileSync(file, "utf8"), { module: true, mangle: true });
    if (errors.length > 0) throw new Error(`${file} cannot be minified: ${errors[0]?.message}`);
    writeFileSync(file, code);
  }
}

/** Types that no entry leads to are of no use to anybody. */
function dropInnerTypes() {
  const { exports } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const entries = Object.values(exports).flatMap(({ types = [] }) => types);
  const reached = new Set(entries.map((/** @type {string} */ entry) => join(root, entry)));
  for (const file of reached) {
    const imports = readFileSync(file, "utf8").matchAll(/from "(\..*?)\.ts"/g);
    for (const [, path] of imports) reached.add(join(dirname(file), `${path}.d.ts`));
  }
  for (const file of filesEndingWith(".d.ts")) if (!reached.has(file)) rmSync(file);
}

/** @param {string} ending */
function filesEndingWith(ending) {
  const files = readdirSync(packageFolder, { recursive: true, encoding: "utf8" });
  return files.filter((file) => file.endsWith(ending)).map((file) => join(packageFolder, file));
}
