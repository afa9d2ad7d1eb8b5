// Every step of the check: what must hold before a change is done. What later steps need is built by earlier ones; what
// needs node packages is imported when its turn comes, as set-up may have to install them first.

import { buildPackage } from "./build-package.mjs";
import { buildSite } from "./build-site.mjs";
import { buildTool, cargo, crate, nodeCommand, rustfmt, xtask } from "./commands.mjs";
import { runCommand } from "./run-command.mjs";
import { checkSizes } from "./sizes.mjs";

/**
 * @typedef {object} Step
 * @property {string} name as in `npm run check -- --only <name>,<name>`
 * @property {boolean} isTest part of `npm test`
 * @property {() => Promise<void>} run
 */

/** @type {readonly Step[]} */
export const steps = [
  step("format", async () => {
    await runCommand("format of the Rust", rustfmt("--check"));
    await runCommand("format of everything else", [...biome(), "check", "--linter-enabled=false"]);
  }),
  step("lint", async () => {
    await runCommand("clippy", cargo("clippy", ["--workspace", "--all-targets", "--", "--deny", "warnings"]));
    await runCommand("biome, import directions included", [...biome(), "lint", "--error-on-warnings"]);
  }),
  step("types", async () => {
    await runCommand("types of the page", [...tsc(), "--project", "tsconfig.json"]);
    await runCommand("types of the npm package", [...tsc(), "--project", "tsconfig.package.json"]);
    await runCommand("types of tools and tests", [...tsc(), "--project", "tsconfig.tools.json"]);
  }),
  step("reference", async () => {
    await runCommand("docs/parameters.md is up to date", xtask("reference", "--check", "docs/parameters.md"));
    const { checkApiReference } = await import("./api-reference.mjs");
    checkApiReference();
  }),
  testStep("rust", async () => {
    const ofTheCore = ["--workspace", "--exclude", "xtask", "--no-fail-fast"];
    await runCommand("tests of the core", cargo("test", ofTheCore), { show: true });
    await runCommand("tests of the build tool", cargo("test", buildTool), { show: true });
  }),
  testStep("unit", async () => {
    await runCommand("unit and contract tests", [...vitest(), "--project", "unit"], { show: true });
  }),
  testStep("site", buildSite),
  testStep("package", buildPackage),
  step("publish", async () => {
    await runCommand("publint", [...nodeCommand("publint"), "--strict"]);
    // The package is for ES modules only, so there is nothing to find for CommonJS; and a wasm has no types.
    const options = ["--pack", ".", "--profile", "esm-only", "--exclude-entrypoints", "bough.wasm"];
    await runCommand("are the types wrong?", [...nodeCommand("@arethetypeswrong/cli", "attw"), ...options]);
    await runCommand("the crate as it would be published", cargo("package", crate));
    const strictly = { env: { RUSTDOCFLAGS: "--deny warnings" } };
    await runCommand(
      "the crate's reference",
      cargo("doc", ["--no-deps", "--package", "bough-plant"]),
      strictly,
    );
  }),
  testStep("consumers", async () => {
    const { matrix } = await import("./consumers/matrix.mjs");
    const { runMatrix } = await import("./consumers/run-matrix.mjs");
    await runMatrix(matrix.filter(({ isQuick }) => isQuick));
  }),
  testStep("browser", async () => {
    await runCommand("browser tests", [...vitest(), "--project", "browser"], { show: true });
  }),
  step("sizes", async () => checkSizes()),
];

/**
 * @param {string} name
 * @param {() => Promise<void>} run
 * @returns {Step}
 */
function step(name, run) {
  return { name, isTest: false, run };
}

/**
 * @param {string} name
 * @param {() => Promise<void>} run
 * @returns {Step}
 */
function testStep(name, run) {
  return { name, isTest: true, run };
}

function biome() {
  return nodeCommand("@biomejs/biome", "biome");
}

function tsc() {
  return [...nodeCommand("typescript", "tsc"), "--noEmit"];
}

function vitest() {
  return [...nodeCommand("vitest"), "run"];
}
