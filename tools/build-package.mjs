// The npm package: our TypeScript compiled file by file (Vite's library mode would inline the wasm), with the glue and
// the wasm beside it at the same relative places as in web/.

import { copyFileSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
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
  await stripComments();
  dropInnerTypes();
}

/** The comments are in the types, where editors look for them; twice they would be a tenth of the tarball. */
async function stripComments() {
  const { default: ts } = await import("typescript");
  const { ESNext: module } = ts.ModuleKind;
  const compilerOptions = { removeComments: true, module, target: ts.ScriptTarget.ESNext };
  for (const file of filesEndingWith(".js")) {
    writeFileSync(file, ts.transpileModule(readFileSync(file, "utf8"), { compilerOptions }).outputText);
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
