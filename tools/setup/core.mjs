// Builds the core for the page: Rust -> wasm -> glue -> wasm-opt, and what is printed from the declaration of the
// parameters. Everything lands in web/generated/, with a fingerprint of what it was made from: a second run is quick.

import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { buildXtask, cargo, nodeCommand, xtask } from "../commands.mjs";
import { generated, root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";
import { fingerprintOf } from "./fingerprint.mjs";
import { requireRust } from "./rust.mjs";
import { target } from "./rustup-toolchain.mjs";
import { findToolchain, forcedWay } from "./wasm-target.mjs";

const glue = join(rustCore, "target", "glue");
const wasm = join(generated, "bough.wasm");
const stamp = join(generated, ".made-from");

const optimisation = "-O3";
/** What rustc uses of WebAssembly's later features; wasm-opt may use no others. */
export const features = [
  "--enable-simd",
  "--enable-bulk-memory",
  "--enable-sign-ext",
  "--enable-nontrapping-float-to-int",
  "--enable-mutable-globals",
  "--enable-reference-types",
];

export async function buildCore() {
  const sources = fingerprintOf([rustCore, join(root, "tools", "setup"), join(root, "package-lock.json")]);
  if (isUpToDate(sources)) return;
  requireRust();
  mkdirSync(generated, { recursive: true });
  rmSync(stamp, { force: true });
  const toolchain = await findToolchain();
  const compiled = await compile(toolchain);
  await runCommand("compiling the build tool", buildXtask());
  await runCommand("making the JavaScript glue", xtask("glue", compiled, glue));
  await runCommand("printing the parameters' declaration and types", xtask("declaration", generated));
  for (const file of ["bough.js", "bough.d.ts"]) copyFileSync(join(glue, file), join(generated, file));
  await optimise(join(glue, "bough_bg.wasm"));
  writeFileSync(join(generated, "bough-base64.ts"), base64Module(readFileSync(wasm)));
  writeFileSync(stamp, `${toolchain.name} ${sources}`);
}

/** @param {string} sources */
function isUpToDate(sources) {
  if (!existsSync(stamp) || !existsSync(wasm)) return false;
  const [way, made] = readFileSync(stamp, "utf8").split(" ");
  return made === sources && way === (forcedWay() ?? way);
}

/**
 * Each way has its own target folder: switching between them rebuilds nothing.
 * @param {import("./wasm-target.mjs").Toolchain} toolchain
 * @returns {Promise<string>} the path of the compiled wasm
 */
async function compile({ name, cargo: executable, args, env }) {
  const folder = join(rustCore, "target", name);
  const what = ["--release", "--package", "bough-wasm", "--target", target, "--target-dir", folder];
  await runCommand(`compiling the core to wasm (${name})`, cargo("build", [...what, ...args], executable), {
    env: { ...env, CARGO_ENCODED_RUSTFLAGS: rustFlags().join("\x1f") },
  });
  return join(folder, target, "release", "bough_wasm.wasm");
}

/**
 * SIMD yes, relaxed SIMD no: it may differ between machines. Inlining little saves 4 kB of the compressed wasm, and costs
 * nothing: what the hot loops call is marked. Paths of this machine have no place in a published file.
 */
export function rustFlags() {
  const cargoHome = process.env.CARGO_HOME ?? join(homedir(), ".cargo");
  return [
    "-Ctarget-feature=+simd128,+bulk-memory",
    "-Cllvm-args=-inline-threshold=25",
    `--remap-path-prefix=${root}=bough`,
    `--remap-path-prefix=${cargoHome}=cargo`,
  ];
}

/** @param {string} input */
async function optimise(input) {
  const wasmOpt = nodeCommand("binaryen", "wasm-opt");
  await runCommand("optimising the wasm", [...wasmOpt, optimisation, ...features, input, "-o", wasm]);
}

/** For places that cannot load a second file: the same wasm as text, compressed to less than half. @param {Buffer} bytes */
function base64Module(bytes) {
  const text = gzipSync(bytes, { level: 9 }).toString("base64");
  return `// bough.wasm, gzip and base64.\nexport const wasmText: string =\n  "${text}";\n`;
}
