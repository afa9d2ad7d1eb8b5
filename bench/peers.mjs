// The peers, each with the sizes that it can do, as contenders that answer with their shape.

import { join } from "node:path";
import { root } from "../tools/paths.mjs";
import { dialogue } from "./hosts.mjs";
import { installNodePeers, installPythonPeers } from "./install.mjs";

/**
 * @typedef {object} Answer
 * @property {number} seconds
 * @property {[number, number]} tip
 * @property {number} [residual] largest torque left over, relative to the largest
 * @property {number} [speed] of the tip at the end
 * @property {boolean} [rests]
 * @property {number} steps
 *
 * @typedef {object} Peer
 * @property {string} name
 * @property {string} script
 * @property {readonly number[]} sizes
 * @property {string} [beyond] why it has no others
 * @property {boolean} slow whether it is timed once, and kept
 * @property {() => Promise<{ solve: (segments: number, rounds: number) => Promise<Answer>, close: () => void }>} start
 */

const scripts = join(root, "bench", "peers");

/** @type {readonly Peer[]} */
export const peers = [
  python("SciPy, banded Newton", "scipy_newton.py", [20, 100, 1000, 10_000], false),
  python("the same, tuned", "scipy_newton.py", [20, 100, 1000, 10_000], false, ["tuned"]),
  {
    ...python("MuJoCo, hinges, tuned", "mujoco_chain.py", [20, 100, 1000], false),
    beyond: "its mass matrix has n^2/2 entries",
  },
  {
    ...python("PyElastica", "elastica_rod.py", [20, 100], true),
    beyond: "takes n times as many steps, each n times as long: hours",
  },
  {
    name: "Rapier, impulse joints",
    script: join(scripts, "rapier.mjs"),
    sizes: [20, 100, 1000],
    beyond: "has failed at 1000",
    slow: true,
    async start() {
      await installNodePeers();
      const { rapier } = await import("./peers/rapier.mjs");
      return { solve: async (segments) => rapier(segments, 60), close() {} };
    },
  },
];

/** On the continuous rod: its sizes are those of its first mesh. */
export const continuum = python("SciPy, solve_bvp", "scipy_bvp.py", [20], false);

/**
 * @param {string} name
 * @param {string} file
 * @param {readonly number[]} sizes
 * @param {boolean} slow
 * @param {readonly string[]} [args]
 * @returns {Peer}
 */
function python(name, file, sizes, slow, args = []) {
  const script = join(scripts, file);
  const start = async () => {
    const { ask, close } = dialogue(await installPythonPeers(), [script, ...args]);
    const solve = async (/** @type {number} */ segments, /** @type {number} */ rounds) => {
      const answer = JSON.parse(await ask(`${segments} ${rounds}`));
      if (answer.failed) throw new Error(answer.failed);
      return answer;
    };
    return { solve, close };
  };
  return { name, script, sizes, slow, start };
}
