// Runs one command: says what it is for and that it still lives, keeps its output out of sight unless it fails, and
// says how long it took. Commands run in the root of the repository, if nothing else is said.

import { spawn } from "node:child_process";
import { Obstacle } from "./obstacle.mjs";
import { root } from "./paths.mjs";

/**
 * @typedef {object} Options
 * @property {string} [cwd] the folder to run in
 * @property {NodeJS.ProcessEnv} [env] added to this process's environment; undefined removes a variable
 * @property {number} [limit] seconds after which the command is ended, an hour if none is given
 * @property {string} [remedy] what a person may do when it fails
 * @property {boolean} [show] let its output through, for commands whose output is the point (tests)
 */

/**
 * @param {string} purpose what a person reads while it runs
 * @param {readonly string[]} commandLine
 * @param {Options} [options]
 * @returns {Promise<string>} what it printed (empty with `show`)
 */
export async function runCommand(purpose, commandLine, options = {}) {
  const { cwd = root, env, limit = 3600, remedy, show = false } = options;
  const [command = "", ...args] = commandLine;
  const progress = show ? plainHeading(purpose) : startProgress(purpose);
  const child = spawn(command, args, {
    cwd,
    env: { ...process.env, ...env },
    stdio: ["ignore", show ? "inherit" : "pipe", show ? "inherit" : "pipe"],
  });
  const unbind = endTogether(child);
  let output = "";
  for (const stream of [child.stdout, child.stderr]) {
    stream?.setEncoding("utf8").on("data", (text) => {
      output += text;
      progress.note(lastLine(text));
    });
  }
  const failure = await failureOf(child, limit);
  unbind();
  progress.end(failure === undefined);
  if (failure) throw new Obstacle(`${purpose}: ${commandLine.join(" ")} ${failure}.`, { output, remedy });
  return output;
}

/**
 * What ends this process ends the command: a signal to this process alone would leave it running. What the command itself
 * began is its own to end.
 * @param {import("node:child_process").ChildProcess} child
 * @returns {() => void} takes that back
 */
function endTogether(child) {
  /** @type {NodeJS.Signals[]} */
  const signals = ["SIGINT", "SIGTERM", "SIGHUP"];
  const end = (/** @type {NodeJS.Signals} */ signal) => {
    child.kill(signal);
    // Nobody listens to it any more, so it does what it does by itself.
    process.kill(process.pid, signal);
  };
  for (const signal of signals) process.once(signal, end);
  return () => {
    for (const signal of signals) process.off(signal, end);
  };
}

/**
 * How the command failed, once it has ended; undefined when it did not.
 * @param {import("node:child_process").ChildProcess} child
 * @param {number} limit
 * @returns {Promise<string | undefined>}
 */
function failureOf(child, limit) {
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      child.kill();
      resolve(`took longer than ${limit} s`);
    }, limit * 1000);
    const end = (/** @type {string | undefined} */ failure) => {
      clearTimeout(timer);
      resolve(failure);
    };
    child.on("error", (error) => end(`could not start: ${error.message}`));
    child.on("close", (code, signal) =>
      end(code === 0 ? undefined : `ended with ${signal ?? `exit code ${code}`}`),
    );
  });
}

/** @param {string} text */
export function lastLine(text) {
  const lines = text.trim().split(/[\r\n]+/);
  return lines.at(-1) ?? "";
}

/** @param {number} seconds */
export function inSeconds(seconds) {
  return `${seconds.toFixed(1)} s`;
}

/** @param {number} started by performance.now() */
export function secondsSince(started) {
  return (performance.now() - started) / 1000;
}

/** @param {string} purpose */
function plainHeading(purpose) {
  console.log(`\n▸ ${purpose}`);
  return { note() {}, end() {} };
}

/**
 * A line that moves on a terminal; elsewhere (CI logs) a sign of life every 20 seconds.
 * @param {string} purpose
 */
function startProgress(purpose) {
  const { isTTY, columns = 80 } = process.stdout;
  const started = performance.now();
  let latest = "";
  const show = () => {
    const text = `  … ${purpose}, ${Math.round(secondsSince(started))} s  ${latest}`;
    if (isTTY) process.stdout.write(`\r\x1b[2K${text.slice(0, columns - 1)}`);
    else console.log(text);
  };
  const ticking = setInterval(show, isTTY ? 200 : 20_000);
  return {
    /** @param {string} line */
    note(line) {
      latest = line;
    },
    /** @param {boolean} good */
    end(good) {
      clearInterval(ticking);
      if (isTTY) process.stdout.write("\r\x1b[2K");
      console.log(`${good ? "✓" : "✗"} ${purpose} (${inSeconds(secondsSince(started))})`);
    },
  };
}
