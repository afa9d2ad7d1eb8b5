// Compiles bench/native twice: natively with default features, and to wasm with the flags and the optimiser of the core's own build.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { nodeCommand } from "../tools/commands.mjs";
import { root } from "../tools/paths.mjs";
import { runCommand } from "../tools/run-command.mjs";
import { features, rustFlags } from "../tools/setup/core.mjs";
import { target } from "../tools/setup/rustup-toolchain.mjs";
import { findToolchain } from "../tools/setup/wasm-target.mjs";

const crate = join(root, "bench", "native");
const manifest = ["--locked", "--release", "--manifest-path", join(crate, "Cargo.toml")];
/** @returns {Promise<string>} the path of the program */
export async function compileNative() {
  const folder = join(crate, "target", "native");
  const build = ["cargo", "build", ...manifest, "--bin", "bough-bench", "--target-dir", folder];
  await runCommand("compiling the kernels", build, { env: { RUSTFLAGS: "" } });
  return join(folder, "release", process.platform === "win32" ? "bough-bench.exe" : "bough-bench");
}

/** @returns {Promise<string>} the path of the wasm */
export async function compileWasm() {
  const { name, cargo, args, env } = await findToolchain();
  const folder = join(crate, "target", name);
  const build = [cargo, "build", ...manifest, "--lib", "--target", target, "--target-dir", folder, ...args];
  await runCommand(`compiling the kernels to wasm (${name})`, build, {
    env: { ...env, CARGO_ENCODED_RUSTFLAGS: rustFlags().join("\x1f") },
  });
  const optimised = join(crate, "target", "kernels.wasm");
  mkdirSync(join(crate, "target"), { recursive: true });
  const wasm = join(folder, target, "release", "kernels.wasm");
  const wasmOpt = [...nodeCommand("binaryen", "wasm-opt"), "-O3", ...features, wasm, "-o", optimised];
  await runCommand("optimising them", wasmOpt);
  return optimised;
}
