// The examples, built and run from the packed package, and what each must show.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { cargo, npm } from "../commands.mjs";
import { Obstacle } from "../obstacle.mjs";
import { runCommand } from "../run-command.mjs";
import { requireEqual } from "./expectation.mjs";
import { serveFolder } from "./servers.mjs";

/** @typedef {import("./matrix.mjs").Consumer} Consumer */

/** @type {readonly Consumer[]} */
export const examples = [
  { name: "example: Node script that prints CSV", isQuick: true, run: nodeCsv },
  { name: "sweeps of the package and of the native binary", isQuick: true, run: nativeSweep },
  page("three-wind", /50 plants, [\d,]+ triangles/, {
    built: "dist",
    isQuick: true,
    // Small, as WebGL is computed on the CPU here.
    viewport: { width: 320, height: 240 },
    more: requireWind,
  }),
  page("plain", /converged, its tip \d\.\d+ m out and/),
  page("vite", /converged after 40 growth steps/, { built: "dist", more: requireDrawn }),
  page("webpack", /converged after 40 growth steps/, { built: ".", more: requireDrawn }),
  page("worker", /At 9\.8 m\/s² the tip is \d\.\d+ m high \(worker\)/, {
    built: "dist",
    more: requireSlider,
  }),
  page("react", /birch: converged, tip 0\.34 m high/, { built: "dist", more: requireMoon }),
  page("heat-map", /651 plants, 0 problems/, { built: "dist", more: requireHeatMap }),
];

/**
 * An example in a browser.
 * @param {string} folder in examples
 * @param {RegExp} text that it shows in the end
 * @param {object} [options]
 * @param {string} [options.built] the folder that is served once it has been built
 * @param {boolean} [options.isQuick]
 * @param {import("playwright").ViewportSize} [options.viewport]
 * @param {(page: import("playwright").Page) => Promise<void>} [options.more]
 * @returns {Consumer}
 */
function page(folder, text, { built, isQuick = false, viewport, more } = {}) {
  return {
    name: `example: ${folder}`,
    isQuick,
    run: async ({ workshop, visitor }) => {
      const place = await workshop.installExample(folder);
      if (built) await runCommand("building", [...npm(), "run", "build"], { cwd: place, limit: 600 });
      const server = await serveFolder(join(place, built ?? "."));
      try {
        await visitor.watch(server.address, text, { viewport, more });
      } finally {
        server.close();
      }
    },
  };
}

/** @param {import("./matrix.mjs").Place} place */
async function nodeCsv({ workshop }) {
  const folder = await workshop.installExample("node-csv");
  const printed = await runCommand("a sweep in Node", [process.execPath, "sweep.js"], { cwd: folder });
  const [header = "", ...rows] = printed.trim().split("\n");
  requireEqual(header, "thickening,gravity,status,reach,height,baseMoment");
  const combinations = ["none", "pipes"].flatMap((way) =>
    [0, 1.62, 3.72, 9.81].map((g) => `${way},${g},converged`),
  );
  requireEqual(rows.map((row) => row.split(",").slice(0, 3).join()).join("\n"), combinations.join("\n"));
  const heights = rows.slice(0, 4).map((row) => Number(row.split(",")[4]));
  demand(
    heights.every((height, i) => i === 0 || height < (heights[i - 1] ?? 0)),
    `more gravity, less height: ${heights}`,
  );
}

/**
 * The same lines through the installed package's pool and through the native binary: the same numbers, to the last bit.
 * @param {import("./matrix.mjs").Place} place
 */
async function nativeSweep({ workshop }) {
  const folder = await workshop.installExample("node-csv");
  writeFileSync(join(folder, "lines.mjs"), packageSweep);
  const ofPackage = await runCommand("a sweep by the package", [process.execPath, "lines.mjs"], {
    cwd: folder,
  });
  const binary = cargo("run", ["--quiet", "--package", "bough-sweep", "--", join(folder, "plants.jsonl")]);
  // The exit status says that some lines are bad: a shell hears it, and this is compared below.
  const ofBinary = await runCommand("a sweep by the binary", [
    "sh",
    "-c",
    '"$@" 2>/dev/null; echo "exit status $?"',
    "sh",
    ...binary,
  ]);
  requireEqual(ofBinary, ofPackage);
  demand(ofPackage.trim().split("\n").length > 25, "too few rows");
}

/** Writes every preset and some bad params as lines, and prints what the native sweep should say of them. */
const packageSweep = `
import { writeFileSync } from "node:fs";
import { measureNames, presets, sweep } from "bough/worker";

const list = Object.values(presets).map(({ params }) => params);
list.push({ axis: { segments: 0 } }, { axis: 5 }, { loads: { tipForce: [1, 2] } }, { growth: { thickening: "no" } });
writeFileSync("plants.jsonl", list.map((params) => JSON.stringify(params)).join("\\n"));
const { rows, columns, status, problems } = await sweep(list);
for (let row = 0; row < rows; row++) {
  const problem = problems.find((one) => one.row === row);
  const issues = problem?.issues.map(({ code, path, message }) => ({ code, path, message }));
  const measures = measureNames.map((name) => [name, columns[name][row]]);
  const line = row + 1;
  console.log(JSON.stringify(problem ? { line, error: problem.message, issues } : { line, status: status[row], ...Object.fromEntries(measures) }));
}
console.log("exit status 1");
`;

/** @param {import("playwright").Page} page */
async function requireWind(page) {
  // Taken within a frame, right after it is drawn: a screenshot waits for more frames than software can draw in a minute.
  const picture = () =>
    page.evaluate(
      () =>
        new Promise((/** @type {(address: string) => void} */ resolve) => {
          requestAnimationFrame(() => {
            const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector("canvas"));
            const copy = document.createElement("canvas");
            [copy.width, copy.height] = [canvas.width, canvas.height];
            copy.getContext("2d")?.drawImage(canvas, 0, 0);
            resolve(copy.toDataURL());
          });
        }),
    );
  const first = await picture();
  // The wood has 100 kB; an empty canvas of this size has one.
  demand(first.length > 10_000, "nothing is drawn");
  await page.waitForTimeout(700);
  demand(first !== (await picture()), "nothing moves");
}

/** @param {import("playwright").Page} page */
async function requireDrawn(page) {
  const box = await page.locator("svg path").boundingBox();
  // It fills nine tenths of the picture, 480 by 360, in one direction.
  demand(box !== null && (box.height > 320 || box.width > 430), `the branch has ${JSON.stringify(box)}`);
}

/** @param {import("playwright").Page} page */
async function requireSlider(page) {
  await page.getByLabel("Gravity").fill("0");
  await page.getByText("At 0.0 m/s²").waitFor({ timeout: 30_000 });
}

/** @param {import("playwright").Page} page */
async function requireMoon(page) {
  await page.getByRole("button", { name: "To the Moon" }).click();
  await page.getByText(/birch: converged, tip 1\.\d\d m high/).waitFor({ timeout: 30_000 });
}

/** @param {import("playwright").Page} page */
async function requireHeatMap(page) {
  const colors = await page.locator("canvas").evaluate((canvas) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
    const pen = /** @type {HTMLCanvasElement} */ (canvas).getContext("2d");
    return new Set(new Uint32Array(pen?.getImageData(0, 0, width, height).data.buffer ?? [])).size;
  });
  demand(colors > 100, `only ${colors} colours`);
}

/**
 * @param {boolean} holds
 * @param {string} otherwise
 */
function demand(holds, otherwise) {
  if (!holds) throw new Obstacle(`It shows something else than it should: ${otherwise}.`);
}
