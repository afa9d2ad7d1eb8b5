// The same rod by everybody: time beside error.

import { readFileSync } from "node:fs";
import { kept } from "../cache.mjs";
import { kernels } from "../hosts.mjs";
import { continuum, peers } from "../peers.mjs";
import { interleaved } from "../samples.mjs";
import { digits } from "../table.mjs";
import { timer } from "./kernels.mjs";

const reference = JSON.parse(readFileSync(new URL("../reference.json", import.meta.url), "utf8"));

/** @type {Record<string, Record<number, string>>} */
const targets = {
  "SciPy, banded Newton": { 100: ">= 100", 1000: ">= 20" },
  "the same, tuned": { 100: ">= 100", 1000: ">= 20" },
  "MuJoCo, hinges, tuned": { 20: ">= 100", 100: ">= 100", 1000: ">= 100" },
};

/** @param {import("../bench.mjs").Bench} bench */
export async function peerRows(bench) {
  const { table, hosts, quick } = bench;
  const [, wasm] = hosts;
  table.heading(
    "Peers on the same rod: 50 degrees, q = 10, residual 1e-6; error = how far the tip is off, over the length",
  );
  for (const size of quick ? [20, 100] : [20, 100, 1000, 10_000]) {
    await wasm.prepare(kernels.solve, size);
    const { iterations } = await wasm.run(1);
    const own = await interleaved([timer(wasm, kernels.solve, size)], bench.effort);
    const note = `error ${digits(errorOf(await wasm.tip()))}; iterations: ${iterations}`;
    table.row({ what: `rod of ${size}`, who: "Bough, wasm, Node", samples: own[0] ?? [], unit: "s", note });
    for (const peer of peers) {
      if (quick && peer.slow) continue;
      if (peer.sizes.includes(size)) await peerRow(bench, peer, size, size);
      else table.row({ what: `rod of ${size}`, who: peer.name, note: `not tried: ${peer.beyond}` });
    }
  }
  await continuumRow(bench);
}

/**
 * Against a solver of the continuous rod: with so many segments that the error is no larger than its.
 * @param {import("../bench.mjs").Bench} bench
 */
async function continuumRow(bench) {
  const [, wasm] = bench.hosts;
  const coarse = 1000;
  await wasm.prepare(kernels.solve, coarse);
  await wasm.run(1);
  const error = errorOf(await wasm.tip());
  for (const mesh of continuum.sizes) {
    await peerRow(bench, continuum, mesh, ({ tip }) => Math.ceil(coarse * Math.sqrt(error / errorOf(tip))));
  }
}

/**
 * @param {import("../bench.mjs").Bench} bench
 * @param {import("../peers.mjs").Peer} peer
 * @param {number} size
 * @param {number | ((answer: import("../peers.mjs").Answer) => number)} match with how many segments Bough does the same
 */
async function peerRow({ table, effort, hosts, fresh }, peer, size, match) {
  const [, wasm] = hosts;
  const what = typeof match === "number" ? `rod of ${size}` : "the continuous rod, at the same error";
  try {
    const { solve, close } = await peer.start();
    try {
      /** @type {import("../peers.mjs").Answer | undefined} */
      let answer;
      /** @type {string | undefined} */
      let day;
      const time = async (/** @type {number} */ rounds) => {
        answer = await solve(size, rounds);
        return answer.seconds;
      };
      let segments = size;
      /** @type {number[][]} */
      let samples;
      if (peer.slow) {
        ({ result: answer, day } = await kept(peer.script, `${peer.name} ${size}`, fresh, async () => {
          // The first call may compile.
          if (peer.script.endsWith(".py")) await solve(size, 1);
          return solve(size, 1);
        }));
        samples = [[answer.seconds], ...(await interleaved([timer(wasm, kernels.solve, size)], effort))];
      } else {
        await time(1);
        segments = typeof match === "number" || !answer ? size : match(answer);
        samples = await interleaved([{ time }, timer(wasm, kernels.solve, segments)], effort);
      }
      const [theirs = [], ours = []] = samples;
      const goal = targets[peer.name]?.[size];
      const name = segments === size ? "Bough" : `Bough with ${segments} segments`;
      const over = { name, samples: ours, ...(goal ? { target: goal } : {}) };
      const note = answer ? `${wordsFor(answer)}${day ? `; measured ${day}` : ""}` : "";
      table.row({ what, who: peer.name, samples: theirs, unit: "s", over: [over], note });
    } finally {
      close();
    }
  } catch (error) {
    const reason = error instanceof Error ? error.message.split("\n")[0] : String(error);
    table.row({ what, who: peer.name, note: `failed: ${reason}` });
  }
}

/** @param {import("../peers.mjs").Answer} answer */
function wordsFor({ tip, steps, residual, speed, rests }) {
  const words = [`error ${digits(errorOf(tip))}`, `${steps} steps`];
  if (residual !== undefined) words.push(`residual ${digits(residual)}`);
  if (speed !== undefined) words.push(`tip still moves at ${digits(speed)}`);
  if (rests === false) words.push("not at rest when time was up");
  return words.join("; ");
}

/** @param {readonly [number, number]} tip */
function errorOf([x, y]) {
  const [exactX, exactY] = reference.tips[50];
  return Math.hypot(x - exactX, y - exactY);
}
