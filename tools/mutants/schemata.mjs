// All mutants of the core in one build (rust-core/mutants says how): three thousand builds take a day, one takes a minute.

import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { cargo } from "../commands.mjs";
import { root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";

/**
 * @typedef {object} Mutant
 * @property {number} id
 * @property {string} name file, line, column and what is changed
 * @property {string} genre
 *
 * @typedef {object} Placed where a mutant is in the rewritten file, in bytes
 * @property {number} id
 * @property {string} file
 * @property {number} start
 * @property {number} end
 *
 * @typedef {object} Span
 * @property {string} file_name
 * @property {number} byte_start
 * @property {number} byte_end
 * @property {{ span: Span } | null} expansion
 *
 * @typedef {object} Schemata
 * @property {readonly Mutant[]} mutants those that compile
 * @property {readonly Mutant[]} unviable those that do not
 * @property {readonly Mutant[]} unswitchable in constants, and iterators as values
 * @property {readonly string[]} binaries of the tests
 */

const folder = join(root, "dist", "mutants");
const core = join(folder, "core");

/** Where the tests are run. */
export const testFolder = join(core, "bough");

const env = { CARGO_TARGET_DIR: join(folder, "target"), RUSTFLAGS: "-Awarnings" };
const ofCrate = ["--package", "bough-plant", "--profile", "mutants", "--message-format", "json"];

/** @returns {Promise<Schemata>} */
export async function buildSchemata() {
  mkdirSync(folder, { recursive: true });
  const maker = ["--package", "mutants", "--profile", "xtask"];
  await runCommand("compiling the maker of mutants", cargo("build", maker));
  const all = await listMutants();
  const unswitchable = new Set(
    all.filter(({ name, genre }) => genre === "FnValue" && name.includes("-> impl ")),
  );
  /** @type {Set<Mutant>} */
  const unviable = new Set();
  // One kind of error hides the next: types are checked before borrows.
  for (;;) {
    const mutants = all.filter((mutant) => !unswitchable.has(mutant) && !unviable.has(mutant));
    const placed = await place(mutants);
    const { errors, isDone: compiles } = compile(["check", "--lib"]);
    if (compiles) {
      const { binaries, isDone } = compile(["test", "--no-run", "--lib", "--tests"]);
      if (!isDone) throw new Error("The tests do not compile with the mutants in the core.");
      return { mutants, unviable: [...unviable], unswitchable: [...unswitchable], binaries };
    }
    const left = mutants.length;
    for (const { message, spans } of errors) {
      for (const { id } of placed.filter((one) => spans.some((span) => isWithin(span, one)))) {
        const mutant = /** @type {Mutant} */ (all[id]);
        // The switch is no constant, whatever the mutant is.
        (message.includes("non-const function `on`") ? unswitchable : unviable).add(mutant);
      }
    }
    const after = all.filter((mutant) => !unswitchable.has(mutant) && !unviable.has(mutant)).length;
    if (after === left) throw new Error(`An error that is of no mutant: ${errors[0]?.message}`);
  }
}

/** What there is to change, by cargo-mutants; rust-core/.cargo/mutants.toml says in which files. */
async function listMutants() {
  const command = ["cargo", "mutants", "--package", "bough-plant", "--list", "--json"];
  const remedy = "cargo install cargo-mutants --locked";
  const printed = await runCommand("listing the mutants", command, { cwd: rustCore, remedy });
  /** @type {readonly Omit<Mutant, "id">[]} */
  const listed = JSON.parse(printed);
  return listed.map((mutant, id) => ({ ...mutant, id }));
}

/**
 * A copy of the core with these mutants in it.
 * @param {readonly Mutant[]} mutants
 * @returns {Promise<readonly Placed[]>}
 */
async function place(mutants) {
  rmSync(core, { recursive: true, force: true });
  cpSync(rustCore, core, { recursive: true, filter: (path) => !/[/\\](target|fuzz)$/.test(path) });
  const [list, map] = [join(folder, "list.json"), join(folder, "map.json")];
  writeFileSync(list, JSON.stringify(mutants));
  await runCommand("placing the mutants", [join(rustCore, "target", "xtask", "mutants"), list, core, map]);
  return JSON.parse(readFileSync(map, "utf8"));
}

/** @param {readonly string[]} how */
function compile(how) {
  const [command = "", ...rest] = how;
  const args = [command, "--locked", ...rest, ...ofCrate];
  const options = { cwd: core, env: { ...process.env, ...env }, maxBuffer: 2 ** 30 };
  const { stdout, status } = spawnSync("cargo", args, options);
  const lines = String(stdout).split("\n");
  const said = lines.filter((line) => line.startsWith("{")).map((line) => JSON.parse(line));
  /** @type {readonly { message: string, level: string, spans: readonly Span[] }[]} */
  const messages = said.filter(({ reason }) => reason === "compiler-message").map(({ message }) => message);
  return {
    isDone: status === 0,
    errors: messages.filter(({ level, spans }) => level === "error" && spans.length > 0),
    binaries: said.map(({ executable }) => executable).filter((path) => typeof path === "string"),
  };
}

/**
 * What a macro expands to is where the macro is called.
 * @param {Span} span
 * @param {Placed} place
 * @returns {boolean}
 */
function isWithin(span, place) {
  const isHere =
    span.file_name.endsWith(place.file) && place.start <= span.byte_start && span.byte_end <= place.end;
  return isHere || (span.expansion !== null && isWithin(span.expansion.span, place));
}
