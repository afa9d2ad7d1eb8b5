// Command lines, as arrays: no shell reads them, so spaces in paths and Windows need no care.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root, rustCore } from "./paths.mjs";

/**
 * The command of an installed package, run with this very Node, whatever is on the PATH.
 * @param {string} packageName
 * @param {string} [command] when it differs from the package's name
 */
export function nodeCommand(packageName, command = packageName) {
  const folder = join(root, "node_modules", packageName);
  const { bin } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  return [process.execPath, join(folder, typeof bin === "string" ? bin : bin[command])];
}

const manifest = ["--manifest-path", join(rustCore, "Cargo.toml")];

/**
 * Cargo.lock is the truth: what it does not name is an error, not an update.
 * @param {string} command
 * @param {readonly string[]} args
 * @param {string} [executable]
 */
export function cargo(command, args, executable = "cargo") {
  return [executable, command, "--locked", ...manifest, ...args];
}

/** @param {readonly string[]} args */
export function rustfmt(...args) {
  return ["cargo", "fmt", "--all", ...manifest, ...args];
}

export const buildTool = ["--package", "xtask", "--profile", "xtask"];

/** Compiles the build tool, so that using it later takes no time. */
export function buildXtask() {
  return cargo("build", buildTool);
}

/** @param {readonly string[]} args */
export function xtask(...args) {
  return cargo("run", ["--quiet", ...buildTool, "--", ...args]);
}

/** The npm that started us, else the one on the PATH: on Windows that is a script, which cannot be spawned. */
export function npm() {
  const { npm_execpath: script } = process.env;
  return script ? [process.execPath, script] : ["npm"];
}

/** The core's crate by its published name. What is not committed yet is packaged too. */
export const crate = ["--package", "bough-plant", "--allow-dirty"];
