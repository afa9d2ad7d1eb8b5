// The Rust on the PATH, with the wasm target that rustup adds to it (or that a distribution packaged with it).

import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { runCommand } from "../run-command.mjs";

export const target = "wasm32-unknown-unknown";

const add = ["rustup", "target", "add", target];

export function sysroot() {
  return spawnSync("rustc", ["--print", "sysroot"], { encoding: "utf8" }).stdout?.trim() ?? "";
}

export function hasTarget() {
  return existsSync(join(sysroot(), "lib", "rustlib", target, "lib"));
}

export async function addTarget() {
  // Long enough for a slow line (about 25 MB), short enough to turn to another way.
  await runCommand("downloading the wasm target with rustup", add, { limit: 90, remedy: add.join(" ") });
}

/** @returns {import("./wasm-target.mjs").Toolchain} */
export function rustupToolchain() {
  return { name: "rustup", cargo: "cargo", args: [], env: {} };
}
