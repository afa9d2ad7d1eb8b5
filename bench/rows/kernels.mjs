// The floor, one Newton iteration, and the static solve: native, wasm in Node, wasm in Chromium.

import { kernels } from "../hosts.mjs";
import { interleaved } from "../samples.mjs";

/** @param {import("../bench.mjs").Bench} bench */
export async function iterationRows(bench) {
  bench.table.heading(
    "One Newton iteration, over the floor loop (one sine, one cosine, ten flops a segment)",
  );
  const sizes = bench.quick ? [20, 1000] : [20, 100, 1000, 10_000, 100_000];
  const goals = { floor: "<= 2.5", native: "<= 1.2" };
  await overFloor(bench, { what: "Newton iteration", kernel: kernels.iteration, sizes, goals });
}

/** @param {import("../bench.mjs").Bench} bench */
export async function spaceRows(bench) {
  bench.table.heading("One Newton iteration of a tree in space, over the same floor loop");
  const sizes = bench.quick ? [1000] : [1000, 10_000, 100_000];
  const goals = { floor: "<= 25", native: "<= 1.5" };
  await overFloor(bench, { what: "iteration in space", kernel: kernels.iterationInSpace, sizes, goals });
}

/**
 * What one iteration takes a segment in all hosts. The goals are for 1000 segments.
 * @param {import("../bench.mjs").Bench} bench
 * @param {{ what: string, kernel: number, sizes: readonly number[], goals: { floor: string, native: string } }} row
 */
async function overFloor({ table, effort, hosts }, { what, kernel, sizes, goals }) {
  const [native] = hosts;
  for (const size of sizes) {
    const timers = hosts.flatMap((host) => [timer(host, kernels.floor, size), timer(host, kernel, size)]);
    const times = await interleaved(timers, effort);
    const samples = times.map((seconds, i) => perSegment(timers[i]?.found.segments ?? size)(seconds));
    for (const [i, host] of hosts.entries()) {
      const [floor = [], iteration = []] = samples.slice(2 * i, 2 * i + 2);
      const here = { who: host.name, unit: "s" };
      table.row({ what: `floor loop, ${size}, a segment`, samples: floor, ...here });
      const target = size === 1000 && host.name !== "wasm, Chromium" ? { target: goals.floor } : {};
      const over = [{ name: "floor", samples: floor, ...target }];
      const natively = {
        name: "native",
        samples: samples[1] ?? [],
        ...(size === 1000 ? { target: goals.native } : {}),
      };
      if (host !== native) over.push(natively);
      table.row({ what: `${what}, ${size}, a segment`, samples: iteration, ...here, over });
    }
  }
}

/** @param {import("../bench.mjs").Bench} bench */
export async function staticRows(bench) {
  bench.table.heading("Static solve, from the straight rod (50 degrees, q = 10) to a residual of 1e-6");
  for (const size of bench.quick ? [20, 1000] : [20, 100, 1000, 10_000, 100_000]) {
    await compare(bench, { what: `solve, ${size}`, kernel: kernels.solve, size });
    await compare(bench, { what: `grow({... static}), ${size}`, kernel: kernels.call, size });
  }
}

/** @param {import("../bench.mjs").Bench} bench */
export async function treeRows(bench) {
  bench.table.heading("Planar trees, from rest");
  for (const size of bench.quick ? [10_000] : [10_000, 100_000]) {
    const target = size === 100_000 ? "<= 6 ms" : "";
    await compare(bench, { what: "tree, solve", kernel: kernels.treeSolve, size, target });
    await compare(bench, { what: "tree, grow({... static})", kernel: kernels.treeCall, size });
  }
}

/** @param {import("../bench.mjs").Bench} bench */
export async function growthRows(bench) {
  bench.table.heading("Growth, every step in equilibrium to 1e-10");
  for (const size of bench.quick ? [20, 100] : [20, 100, 1000]) {
    await compare(bench, { what: `growth, ${size} steps`, kernel: kernels.growth, size });
    const target = size === 1000 ? "<= 6 ms, <= 1100 iterations" : "";
    await compare(bench, { what: `growth with pipes, ${size} steps`, kernel: kernels.pipes, size, target });
  }
}

/**
 * One kernel in all hosts, in turns; native is the measure of the others. A target is that of Chromium.
 * @param {import("../bench.mjs").Bench} bench
 * @param {{ what: string, kernel: number, size: number, target?: string }} row
 */
async function compare({ table, effort, hosts }, { what, kernel, size, target = "" }) {
  const timers = hosts.map((host) => timer(host, kernel, size));
  const [native = [], ...others] = await interleaved(timers, effort);
  for (const [i, samples] of [native, ...others].entries()) {
    const who = hosts[i]?.name ?? "";
    const over = i > 0 ? [{ name: "native", samples: native }] : [];
    const { segments = 0, iterations = 0 } = timers[i]?.found ?? {};
    const note = `${segments === size ? "" : `${segments} segments, `}iterations: ${iterations}`;
    table.row({ what, who, samples, unit: "s", over, note, target: who === "wasm, Chromium" ? target : "" });
  }
}

/**
 * A contender that prepares its kernel anew each time, for its host keeps one at a time, and runs it once to have warm buffers.
 * @param {import("../hosts.mjs").Host} host
 * @param {number} kernel
 * @param {number} size
 */
export function timer(host, kernel, size) {
  const found = { segments: 0, iterations: 0 };
  return {
    found,
    /** @param {number} rounds */
    async time(rounds) {
      found.segments = await host.prepare(kernel, size);
      await host.run(1);
      const { seconds, iterations } = await host.run(rounds);
      found.iterations = iterations;
      return seconds;
    },
  };
}

/** @param {number} segments */
function perSegment(segments) {
  return (/** @type {readonly number[]} */ samples) => samples.map((seconds) => seconds / segments);
}
