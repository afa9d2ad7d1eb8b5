// The code blocks of README and docs, run as they stand, against the installed package. What a block prints is compared
// with its comments "// → …" or "# → …"; blocks of Rust are the doctests of rust-core/docs, blocks of Python parts of examples
// that soak runs.

import { cpSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { buildWidget } from "../build-widget.mjs";
import { cargo } from "../commands.mjs";
import { Obstacle } from "../obstacle.mjs";
import { root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";
import { requireEqual } from "./expectation.mjs";
import { serveFolder } from "./servers.mjs";

/**
 * @typedef {object} Block
 * @property {string} place file and line
 * @property {string} language
 * @property {string} code
 */

/**
 * @param {string} folder a consumer that has the package installed
 * @param {import("./visitor.mjs").Visitor} visitor
 */
export async function runSnippets(folder, visitor) {
  // As an author has it who copied the site.
  await buildWidget(folder);
  cpSync(join(root, "public"), folder, { recursive: true });
  const server = await serveFolder(folder);
  try {
    for (const [index, block] of blocks().entries()) {
      const name = `block-${index}.${block.language}`;
      if (block.language === "js") await runScript(block, folder, name);
      else if (block.language === "html") await visitPage(block, folder, name, server, visitor);
      else if (block.language === "sh" && block.code.includes("# → ")) await runShell(block, folder);
      else if (block.language === "sh") requireCommands(block);
      else if (block.language === "py") requireExample(block);
      else if (block.language === "rust") requireDoctest(block);
      else throw new Obstacle(`${block.place}: nothing here can run “${block.language}”.`);
    }
  } finally {
    server.close();
  }
}

/** Every code block of the documents. */
function blocks() {
  const docs = readdirSync(join(root, "docs")).map((file) => `docs/${file}`);
  const documents = [
    "README.md",
    "ARCHITECTURE.md",
    "examples/README.md",
    "rust-core/bough/README.md",
    ...docs,
  ].filter((file) => file.endsWith(".md"));
  return documents.flatMap(blocksOf);
}

/**
 * @param {string} file
 * @returns {Block[]}
 */
function blocksOf(file) {
  const text = readFileSync(join(root, file), "utf8");
  return [...text.matchAll(/^```(\w+)\n(.*?)^```$/gms)].map(({ 1: language = "", 2: code = "", index }) => {
    const line = text.slice(0, index).split("\n").length;
    return { place: `${file}:${line}`, language, code };
  });
}

/**
 * @param {Block} block
 * @param {string} folder
 * @param {string} name
 */
async function runScript({ place, code }, folder, name) {
  writeFileSync(join(folder, name), code);
  const printed = await runCommand(place, [process.execPath, name], { cwd: folder, limit: 60 });
  const promised = [...code.matchAll(/\/\/ → (.*)$/gm)].map(([, text]) => text);
  if (promised.length > 0) requireEqual(printed, promised.join("\n"));
}

/**
 * In a shell that finds the native binaries.
 * @param {Block} block
 * @param {string} folder
 */
async function runShell({ place, code }, folder) {
  await runCommand("the native sweep", cargo("build", ["--quiet", "--package", "bough-sweep"]));
  const env = { PATH: `${join(rustCore, "target", "debug")}${delimiter}${process.env.PATH}` };
  // What comes out at the end of a pipe is told, not how each part of it has ended.
  const printed = await runCommand(place, ["sh", "-c", `{ ${code}\n} 2>/dev/null`], {
    cwd: folder,
    env,
    limit: 60,
  });
  const promised = [...code.matchAll(/^# → (.*)$/gm)].map(([, text]) => text);
  requireEqual(printed, promised.join("\n"));
}

/**
 * Its Python is part of an example, which soak runs.
 * @param {Block} block
 */
function requireExample({ place, code }) {
  const example = readFileSync(join(root, "examples", "dask", "sweep.py"), "utf8");
  if (!example.includes(code.trim()))
    throw new Obstacle(`${place}: its Python is not that of examples/dask/sweep.py.`);
}

/**
 * @param {Block} block
 * @param {string} folder
 * @param {string} name
 * @param {import("./servers.mjs").Server} server
 * @param {import("./visitor.mjs").Visitor} visitor
 */
async function visitPage({ place, code }, folder, name, { address }, visitor) {
  const [, promised = ""] = /<!-- → (.*?) -->/.exec(code) ?? [];
  if (!promised) throw new Obstacle(`${place}: the page must say in a comment <!-- → … --> what it shows.`);
  // An element added by us tells the visitor when the promised text is there.
  const watch = `<script>
    new MutationObserver(() => {
      if (document.body?.innerText.trim() === ${JSON.stringify(promised)}) globalThis.report = "shown";
    }).observe(document, { childList: true, subtree: true, characterData: true });
  </script><link rel="icon" href="data:,">`;
  writeFileSync(join(folder, name), code.replace("<!doctype html>", `<!doctype html>${watch}`));
  await visitor.visit(`${address}${name}`);
}

/**
 * The doctests are the whole files that rust-core/docs names.
 * @param {Block} block
 */
function requireDoctest({ place }) {
  const [file = ""] = place.split(":");
  const doctests = readFileSync(join(root, "rust-core", "docs", "src", "lib.rs"), "utf8");
  if (doctests.includes(`/${file.replace("rust-core/", "")}"`)) return;
  throw new Obstacle(`${place}: its Rust is not tested; name the file in rust-core/docs/src/lib.rs.`);
}

/**
 * Commands are not run, most of them would never end, but they must exist.
 * @param {Block} block
 */
function requireCommands({ place, code }) {
  const { name, scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const known = [
    ...Object.keys(scripts).map((script) => `npm run ${script}`),
    "npm start",
    "npm test",
    `npm install ${name}`,
    "cargo build --release --package bough-sweep",
    `cargo add ${/^name = "(.+)"/m.exec(readFileSync(join(root, "rust-core/bough/Cargo.toml"), "utf8"))?.[1]}`,
  ];
  for (const line of code.split("\n")) {
    const command = line.replace(/#.*/, "").trim();
    const exists = known.some((one) => command === one || command.startsWith(`${one} `));
    if (command && !exists) throw new Obstacle(`${place}: “${command}” is no command of this project.`);
  }
}
