// What takes too long for every check: each shard is passed or not on its own, and leaves lines of evidence.

import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { cargo, nodeCommand } from "../commands.mjs";
import { matrix } from "../consumers/matrix.mjs";
import { runMatrix } from "../consumers/run-matrix.mjs";
import { hosts } from "../hosts/matrix.mjs";
import { packageFolder, root, rustCore } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";
import { installFromPyPi } from "../setup/peers.mjs";
import { leastRust } from "../setup/rust.mjs";
import { buildPlates, comparePlates, looks, platesFolder } from "../visual/plates.mjs";
import { haveSite } from "./built-site.mjs";
import { fuzz, targets } from "./fuzz.mjs";
import { mutantShards, tryShard } from "./mutants.mjs";

/**
 * @typedef {object} Shard
 * @property {string} job which file in docs/evidence it belongs to
 * @property {string} name
 * @property {() => Promise<string>} run what it found, in a few words
 */

/** @type {readonly Shard[]} */
export const shards = [
  ...matrix.map((consumer) => ({
    job: "consumers",
    name: consumer.name,
    run: async () => {
      await runMatrix([consumer]);
      return "";
    },
  })),
  ...hosts.map(({ name, run }) => ({ job: "course", name: `a course page in ${name}`, run })),
  { job: "course", name: "every link of the course, opened in the page", run: courseLinks },
  { job: "memory", name: "a million plants", run: memory },
  { job: "widgets", name: "thirty widgets and two dozen frames, five rounds of each", run: widgets },
  { job: "sweeps", name: "ten thousand plants on workers of Dask", run: daskSweep },
  { job: "rust", name: "the oldest Rust that is promised", run: oldestRust },
  ...Array.from({ length: 10 }, (_, part) => ({
    job: "links",
    name: `damaged links ${1000 * part} to ${1000 * part + 999}`,
    run: async () => {
      await buildPlates();
      const { openDamagedLinks } = await import("../../tests/soak/links.mjs");
      return openDamagedLinks(platesFolder, 1000 * part, 1000);
    },
  })),
  ...targets.map(([name, runs]) => ({ job: "fuzz", name, run: () => fuzz(name, runs) })),
  ...Array.from({ length: mutantShards }, (_, shard) => ({
    job: "mutants",
    name: `mutants, shard ${shard} of ${mutantShards}`,
    run: () => tryShard(shard),
  })),
  // The first paints every picture, which the processor does here: an action takes ten times as long.
  ...Array.from({ length: 12 }, (_, part) => ({
    job: "walks",
    name: `random actions, seed ${100 + part}`,
    run: () => (part === 0 ? walkAbout(100, 1000, true) : walkAbout(100 + part, 9000, false)),
  })),
  ...["en", "de", "fr", "es", "zh"].map((tag) => ({
    job: "languages",
    name: `every state of the page in ${tag}: axe, and texts that are cut off`,
    run: () => languages(tag),
  })),
  ...looks.map((look) => ({
    job: "visual",
    name: `every preset, ${look.screen} and ${look.theme}`,
    run: async () => {
      await buildPlates();
      return comparePlates(look, false);
    },
  })),
];

async function memory() {
  const entry = pathToFileURL(join(packageFolder, "src", "package", "node.js")).href;
  const script = join(root, "tests", "soak", "memory.mjs");
  const [calls, failing] = ["1000000", "100000"];
  const command = [process.execPath, "--expose-gc", script, entry, calls, failing];
  return runCommand("a million plants in one process", command);
}

async function widgets() {
  return soakTest("widgets and frames", "tests/element", {}, /at once|nodes, /);
}

async function courseLinks() {
  return soakTest("links of the course", "tests/browser/course-links", {}, /^course links: /);
}

/**
 * @param {number} seed
 * @param {number} actions
 * @param {boolean} painted
 */
async function walkAbout(seed, actions, painted) {
  const way = { BOUGH_ACTIONS: String(actions), BOUGH_PAINTED: painted ? "yes" : "no" };
  const env = { BOUGH_SEED: String(seed), ...way };
  return soakTest(`random actions, seed ${seed}`, "tests/browser/walk.soak.ts", env, /^seed \d+: /);
}

/** @param {string} tag */
async function languages(tag) {
  const env = { BOUGH_LANGUAGE: tag };
  return soakTest(`every state in ${tag}`, "tests/browser/language.soak.ts", env, /^\w\w: \d+ states/);
}

/**
 * Runs what is in Chromium, on the built site.
 * @param {string} what
 * @param {string} files of the tests
 * @param {Record<string, string>} env
 * @param {RegExp} telling which lines of what is printed are evidence
 */
async function soakTest(what, files, env, telling) {
  await haveSite();
  const soak = [...nodeCommand("vitest"), "run", "--project", "soak", files];
  const printed = await runCommand(what, soak, { limit: 18_000, env: { NO_COLOR: "1", ...env } });
  return printed
    .split("\n")
    .filter((line) => telling.test(line))
    .join("\n");
}

/** The recipe of examples/dask. */
async function daskSweep() {
  const python = await installFromPyPi(join(root, "examples", "dask"), "Dask");
  const build = cargo("build", ["--quiet", "--release", "--package", "bough-sweep"]);
  await runCommand("the native sweep", build, { limit: 600 });
  const binary = join(rustCore, "target", "release", "bough-sweep");
  const script = join(root, "tests", "soak", "dask_sweep.py");
  const printed = await runCommand("a sweep on Dask", [python, script, binary, "3"], { limit: 1800 });
  // Dask itself tells of the worker that is lost.
  return printed
    .split("\n")
    .filter((line) => !line.includes("distributed."))
    .join("\n");
}

/** In a target folder of its own: the check's stays warm. */
async function oldestRust() {
  const toolchain = `+${leastRust()}`;
  const folder = ["--target-dir", join(rustCore, "target", "oldest")];
  const [command = "", ...test] = cargo("test", ["--package", "bough-plant", ...folder]);
  await runCommand(`the core's tests with Rust ${leastRust()}`, [command, toolchain, ...test], {
    remedy: `rustup toolchain install ${leastRust()} --profile minimal`,
  });
  return `the core's tests pass with Rust ${leastRust()}`;
}
