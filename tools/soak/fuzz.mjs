// Fuzzing of the core: libFuzzer over the targets in rust-core/fuzz, started from the corpus that the tests replay.

import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";

const folder = join(rustCore, "fuzz");
const target = hostTarget();
const corpora = join(root, "dist", "fuzz");

/** What each target's inputs are, and how many of them are run: more than 20 million in all. */
export const targets = /** @type {const} */ ([
  ["space", 500_000],
  ["grips", 1_200_000],
  ["ages", 1_200_000],
  ["mirror", 1_000_000],
  ["forks", 1_200_000],
  ["extremes", 2_000_000],
  ["values", 2_500_000],
  ["bytes", 11_000_000],
]);

/** Coverage as stable compilers know it: only the C++ of the fuzzer's runtime is not Rust. */
const instrumented = [
  "--cfg fuzzing",
  "-Cpasses=sancov-module",
  "-Cllvm-args=-sanitizer-coverage-level=3",
  "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
  "-Cllvm-args=-sanitizer-coverage-pc-table",
].join(" ");

/**
 * What counts as hanging, s: by the clock while it runs, where a busy machine may stop the fuzzer in the midst of an input; and
 * for the inputs that were slow so, alone.
 */
const [stopped, hanging, again] = [30, 1, 3];

/**
 * Runs one target so many times. It fails at the first broken promise, panic, or input that takes longer than a second.
 * @param {string} name
 * @param {number} runs
 * @returns {Promise<string>} executions, time, coverage
 */
export async function fuzz(name, runs) {
  const build = ["cargo", "build", "--locked", "--release", "--target", target, "--bin", name];
  const env = { RUSTFLAGS: instrumented };
  await runCommand(`building the fuzz target ${name}`, build, { cwd: folder, env });
  const corpus = unpacked(name);
  const fuzzer = join(folder, "target", target, "release", name);
  const options = [
    `-runs=${runs}`,
    `-timeout=${stopped}`,
    `-report_slow_units=${hanging}`,
    "-max_len=900",
    "-use_counters=0",
    "-reduce_inputs=0",
    "-print_final_stats=1",
    `-artifact_prefix=${join(corpora, `${name}-`)}`,
  ];
  const started = performance.now();
  const report = `${join(corpora, name)}.log`;
  // libFuzzer reports on its error output.
  const output = await runCommand(`fuzzing ${name}`, [fuzzer, corpus, ...options], { limit: 36_000 });
  writeFileSync(report, output);
  const seconds = (performance.now() - started) / 1000;
  const executions = Number(/number_of_executed_units: (\d+)/.exec(output)?.[1]);
  await hurryAgain(name, fuzzer);
  const covered = [...output.matchAll(/cov: (\d+)/g)].at(-1)?.[1];
  if (!(executions >= runs)) throw new Error(`${name}: ${executions} runs of ${runs}`);
  return `${executions} executions in ${Math.round(seconds)} s, ${covered} branches of the core and its checks reached, none over 1 s, 0 findings`;
}

/** Runs each input that was slow alone, a few times: one that hangs does so whenever it is run. */
async function hurryAgain(/** @type {string} */ name, /** @type {string} */ fuzzer) {
  const slow = readdirSync(corpora).filter((file) => file.startsWith(`${name}-slow-unit-`));
  for (const file of slow) {
    const path = join(corpora, file);
    const output = await runCommand(`${file} again`, [fuzzer, `-runs=${again}`, path], { limit: 600 });
    const seconds = Number(/Executed .* in (\d+) ms/.exec(output)?.[1]) / 1000 / again;
    if (!(seconds < hanging)) throw new Error(`${name}: ${path} takes ${seconds} s`);
    rmSync(path);
  }
}

/** The committed corpus as the files that libFuzzer reads, beside what earlier runs have found. */
function unpacked(/** @type {string} */ name) {
  const corpus = join(corpora, name);
  mkdirSync(corpus, { recursive: true });
  const lines = readFileSync(join(rustCore, "bough", "tests", "corpus", `${name}.txt`), "utf8")
    .trim()
    .split("\n");
  lines.forEach((line, index) => {
    writeFileSync(join(corpus, `kept-${index}`), Buffer.from(line, "hex"));
  });
  return corpus;
}

function hostTarget() {
  const cpu = process.arch === "arm64" ? "aarch64" : "x86_64";
  return process.platform === "darwin" ? `${cpu}-apple-darwin` : `${cpu}-unknown-linux-gnu`;
}
