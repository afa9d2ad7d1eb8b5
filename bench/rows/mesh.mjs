// Meshes built a second, by Bough and by ez-tree, both bundled as for a page and run in one page of Chromium, in turns.

import { join } from "node:path";
import { build } from "vite";
import { root } from "../../tools/paths.mjs";
import { installNodePeers } from "../install.mjs";
import { interleaved } from "../samples.mjs";
import { loadPackage } from "../shipped.mjs";

/** @param {import("../bench.mjs").Bench} bench */
export async function meshRows({ table, effort, browser }) {
  table.heading("Meshes built, vertices a second, in Chromium: positions, normals, texture places, indices");
  await installNodePeers();
  const { grow } = await loadPackage();
  const fork = { branching: { pattern: "bifurcation", generations: 7 }, axis: { segments: 7 } };
  const tree = plain(grow(fork));
  const axis = plain(grow({ axis: { segments: 200 } }));
  const page = await browser.newPage();
  try {
    const contenders = await page.evaluateHandle(
      async ({ code, plants }) => {
        /** @type {typeof import("../mesh/contenders.mjs")} */
        const built = await import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
        return [built.ezTree(), ...built.boughs(...plants)];
      },
      { code: await bundle(), plants: /** @type {const} */ ([tree, axis]) },
    );
    const count = await contenders.evaluate((list) => list.map((make) => make()));
    const timers = count.map((_, i) => ({
      time: (/** @type {number} */ rounds) =>
        contenders.evaluate(
          (list, [which = 0, times = 1]) => {
            const start = performance.now();
            for (let round = 0; round < times; round++) list[which]?.();
            return (performance.now() - start) / 1000;
          },
          [i, rounds],
        ),
    }));
    const samples = await interleaved(timers, { ...effort, least: Math.max(effort.least, 0.05) });
    const speeds = samples.map((seconds, i) => seconds.map((value) => (count[i] ?? 0) / value / 1e6));
    const [ez = []] = speeds;
    table.row({
      what: `ez-tree's default tree, ${count[0]} vertices`,
      who: "ez-tree, no leaves",
      samples: ez,
      unit: "M/s",
    });
    const cases = ["tree of 255 axes", "the same, as few corners as ez-tree's", "axis of 200 segments"];
    for (const [i, what] of cases.entries()) {
      const own = speeds[i + 1] ?? [];
      const target = i === 1 ? {} : { target: ">= 10" };
      const over = [{ name: "ez-tree", samples: ez, ...target }];
      table.row({
        what,
        who: "Bough, Tubes",
        samples: own,
        unit: "M/s",
        over,
        note: `${count[i + 1]} vertices`,
      });
    }
  } finally {
    await page.close();
  }
}

/** @returns {Promise<string>} the contenders in one module */
async function bundle() {
  const folder = join(root, "bench");
  const built = await build({
    configFile: false,
    root: folder,
    logLevel: "error",
    build: { write: false, lib: { entry: join(folder, "mesh", "contenders.mjs"), formats: ["es"] } },
  });
  const [first] = [built].flat();
  const chunk = first && "output" in first ? first.output[0] : undefined;
  if (!chunk) throw new Error("Vite has bundled nothing.");
  return chunk.code;
}

/** A plant as lists, which cross into the page. @param {import("../shipped.mjs").Shape} plant */
function plain({ polylines, segments, report }) {
  const lists = (/** @type {Record<string, ArrayLike<number>>} */ arrays) =>
    Object.fromEntries(Object.entries(arrays).map(([name, array]) => [name, Array.from(array)]));
  return { polylines: lists({ ...polylines }), segments: lists(segments), steps: report.steps };
}
