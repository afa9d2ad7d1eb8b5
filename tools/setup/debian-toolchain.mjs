// Debian's Rust for browsers' builds (rustc-web). It has no wasm target, but the sources of the standard library:
// cargo builds that as part of ours. That is a nightly feature, which RUSTC_BOOTSTRAP=1 opens in a stable compiler.

import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { Obstacle } from "../obstacle.mjs";
import { aptInstall, areInstalled, isDebian } from "./apt.mjs";
import { sysroot } from "./rustup-toolchain.mjs";

const packages = ["rustc-web", "cargo-web", "rust-web-src"];
const rustc = "/usr/bin/rustc";

export function debianIsReady() {
  return isDebian() && areInstalled(packages) && existsSync(linker().path);
}

export async function installDebianToolchain() {
  if (!isDebian())
    throw new Obstacle("BOUGH_WASM=debian works on Debian only.", { remedy: "BOUGH_WASM=rustup npm start" });
  await aptInstall("installing Debian's Rust for wasm", packages);
  const { path, package: lld } = linker();
  if (!existsSync(path) && lld) await aptInstall("installing Debian's wasm linker", [lld]);
}

/** @returns {import("./wasm-target.mjs").Toolchain} */
export function debianToolchain() {
  return {
    name: "debian",
    cargo: "/usr/bin/cargo",
    args: ["-Z", "build-std=std,panic_abort"],
    env: {
      RUSTC: rustc,
      RUSTC_BOOTSTRAP: "1",
      CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER: linker().path,
    },
  };
}

/** Debian's rustc comes without rust-lld. The one inside rustup's toolchain serves; else lld of the LLVM that rustc is built on. */
function linker() {
  const ofRustup = join(sysroot(), "lib", "rustlib", hostTriple(), "bin", "rust-lld");
  if (existsSync(ofRustup)) return { path: ofRustup };
  const llvm = /LLVM version: (\d+)/.exec(verboseVersion(rustc))?.[1];
  return { path: `/usr/bin/wasm-ld-${llvm}`, package: `lld-${llvm}` };
}

function hostTriple() {
  return /host: (\S+)/.exec(verboseVersion("rustc"))?.[1] ?? "";
}

/** @param {string} compiler */
function verboseVersion(compiler) {
  return spawnSync(compiler, ["-vV"], { encoding: "utf8" }).stdout ?? "";
}
