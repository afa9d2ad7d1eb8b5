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

/** The two that are made, and the crates they come from: what grows plants, and what is loaded only to study one. */
const bindings = { bough: "bough_wasm", "bough-analysis": "bough_analysis" };

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
  await runCommand("printing the parameters' declaration and types", xtask("declaration", generated));
  for (const [name, file] of Object.entries(bindings)) {
    await runCommand(
      `making the JavaScript glue of ${name}`,
      xtask("glue", join(compiled, `${file}.wasm`), glue, name),
    );
    for (const made of [`${name}.js`, `${name}.d.ts`]) copyFileSync(join(glue, made), join(generated, made));
    await optimise(join(glue, `${name}_bg.wasm`), join(generated, `${name}.wasm`));
  }
  writeFileSync(join(generated, "bough-base64.ts"), base64Module(readFileSync(wasm)));
  writeFileSync(stamp, `${toolchain.name} ${sources}`);
}

/** @param {string} sources */
function isUpToDate(sources) {
  const isThere = (/** @type {string} */ name) => existsSync(join(generated, `${name}.wasm`));
  if (!existsSync(stamp) || !Object.keys(bindings).every(isThere)) return false;
  const [way, made] = readFileSync(stamp, "utf8").split(" ");
  return made === sources && way === (forcedWay() ?? way);
}

/**
 * Each way has its own target folder: switching between them rebuilds nothing.
 * @param {import("./wasm-target.mjs").Toolchain} toolchain
 * @returns {Promise<string>} the folder of the compiled wasm
 */
async function compile({ name, cargo: executable, args, env }) {
  const folder = join(rustCore, "target", name);
  const packages = Object.values(bindings).flatMap((file) => ["--package", file.replace("_", "-")]);
  const what = ["--release", ...packages, "--target", target, "--target-dir", folder];
  await runCommand(`compiling the core to wasm (${name})`, cargo("build", [...what, ...args], executable), {
    env: { ...env, CARGO_ENCODED_RUSTFLAGS: rustFlags().join("\x1f") },
  });
  return join(folder, target, "release");
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

/**
 * @param {string} input
 * @param {string} output
 */
async function optimise(input, output) {
  const wasmOpt = nodeCommand("binaryen", "wasm-opt");
  await runCommand("optimising the wasm", [...wasmOpt, optimisation, ...features, input, "-o", output]);
}

/** For places that cannot load a second file: the same wasm as text, compressed to less than half. @param {Buffer} bytes */
function base64Module(bytes) {
  // Blocks of that size pack the wasm best.
  const text = gzipSync(bytes, { level: 9, memLevel: 7 }).toString("base64");
  return `// bough.wasm, gzip and base64.\nexport const wasmText: string =\n  "${text}";\n`;
}
