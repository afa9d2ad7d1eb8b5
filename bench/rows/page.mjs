// What the page costs a person's machine, and what it downloads.

import { spawn } from "node:child_process";
import { join } from "node:path";
import { buildSite } from "../../tools/build-site.mjs";
import { root } from "../../tools/paths.mjs";
import { digits } from "../table.mjs";

/** @param {import("../bench.mjs").Bench} bench */
export async function pageRows({ table }) {
  table.heading("The page, built, in Chromium without a GPU");
  const { lines, code } = await run(join(root, "bench", "page.mjs"));
  for (const line of lines.filter((text) => text.startsWith("{"))) {
    const { name, median, min, max, unit } = JSON.parse(line);
    const spread = `${digits(min)} .. ${digits(max)}`;
    table.note(`${name.padEnd(67)} ${digits(median).padStart(9)} ${spread.padStart(21)} ${unit}`);
  }
  if (code !== 0) throw new Error(lines.at(-1));
}

/** @param {import("../bench.mjs").Bench} bench */
export async function sizeRows({ table }) {
  table.heading("Sizes, compressed");
  await buildSite();
  const { lines } = await run(join(root, "tools", "check.mjs"), "--only", "sizes");
  const figures = /^(kB,|Over budget|.+\d\.\d +\d+ +\d+$)/;
  for (const line of lines.filter((text) => figures.test(text))) table.note(line);
}

/**
 * What a script prints.
 * @param {string} script
 * @param {...string} args
 */
async function run(script, ...args) {
  const child = spawn(process.execPath, [script, ...args], { cwd: root, stdio: ["ignore", "pipe", "pipe"] });
  let output = "";
  for (const stream of [child.stdout, child.stderr]) {
    stream.setEncoding("utf8").on("data", (text) => {
      output += text;
    });
  }
  const code = await new Promise((resolve) => child.on("close", resolve));
  return { lines: output.trim().split("\n"), code };
}
