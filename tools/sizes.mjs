// What visitors and users download, compressed, against its budget.

import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { gzipSync } from "node:zlib";
import { npm } from "./commands.mjs";
import { Obstacle } from "./obstacle.mjs";
import { packageFolder, root, site } from "./paths.mjs";

export function checkSizes() {
  if (!existsSync(join(site, "index.html")) || !existsSync(packageFolder)) {
    throw new Obstacle("There is nothing to measure yet.", { remedy: "npm run build" });
  }
  const wasm = compressed(wasmFiles().filter((file) => !isForStudy(file)));
  const embed = ["embed.html", ...reachedBy(["embed.html"], staticImport)];
  const widget = reachedBy(["bough-plant.js"], anyImport);
  // Rods in space, which bend and twist, made the wasm a third larger, and weather, leaves and strength 6 kB more; eight at a time 4.
  const rows = [
    { what: "wasm", size: wasm, wished: 40, most: 92 },
    {
      what: "explorer up to the first plant",
      size: wasm + compressed(initialFiles()),
      wished: 255,
      most: 271,
    },
    {
      what: "wasm that studies a plant, when wanted",
      size: compressed(wasmFiles().filter(isForStudy)),
      wished: 60,
      most: 86,
    },
    { what: "embed before activation", size: compressed(embed), wished: 15, most: 15 },
    { what: "module widget with three and wasm", size: wasm + compressed(widget), wished: 215, most: 255 },
    { what: "one-file bough-widget.js", size: compressed(["bough-widget.js"]), wished: 235, most: 259 },
    // Wished before there were an element and bough/three in it (now a fifth), and for a wasm of 40 kB, which ships twice.
    { what: "npm tarball", size: tarballSize(), wished: 150, most: 278 },
  ];
  console.log(tableRow("kB, compressed", "size", "wished", "at most"));
  for (const { what, size, wished, most } of rows) {
    console.log(tableRow(what, (size / 1000).toFixed(1), String(wished), String(most)));
  }
  const tooLarge = rows.filter(({ size, most }) => size > most * 1000).map(({ what }) => what);
  if (tooLarge.length > 0) throw new Obstacle(`Over budget: ${tooLarge.join(", ")}.`);
}

/** @param {[what: string, ...numbers: string[]]} cells */
function tableRow(...[what, ...numbers]) {
  return what.padEnd(40) + numbers.map((number) => number.padStart(9)).join("");
}

/** The page, what its tags load (Vite lists there every script that is imported statically), and the worker that grows. */
function initialFiles() {
  const page = readFileSync(join(site, "index.html"), "utf8");
  const tagged = [...page.matchAll(/<(?:script|link)\b[^>]*?(?:src|href)="\.\/([^"]+\.(?:js|css))"/g)];
  const workers = assets().filter((file) => /worker.*\.js$/.test(file));
  return ["index.html", ...tagged.map(([, file = ""]) => file), ...workers];
}

/** How a built file names the code that it loads: with it, or at any time. */
const staticImport =
  /(?:<script\b[^>]*?src=|<link\b[^>]*?href=|\bfrom|\bimport)\s*["'`](\.[^"'`]+\.(?:js|css))["'`]/g;
const anyImport = new RegExp(`${staticImport.source}|\\bimport\\(["'\`](\\.[^"'\`]+)["'\`]\\)`, "g");

/**
 * The code that some files lead to.
 * @param {readonly string[]} entries
 * @param {RegExp} how
 */
function reachedBy(entries, how) {
  const reached = new Set(entries);
  for (const file of reached) {
    for (const [, together, later] of readFileSync(join(site, file), "utf8").matchAll(how)) {
      reached.add(join(dirname(file), together ?? later ?? ""));
    }
  }
  return [...reached].filter((file) => !file.endsWith(".html"));
}

/** @param {string} file */
function isForStudy(file) {
  return file.includes("analysis");
}

function wasmFiles() {
  return assets().filter((file) => file.endsWith(".wasm"));
}

function assets() {
  return readdirSync(join(site, "assets")).map((file) => join("assets", file));
}

/** @param {readonly string[]} files of the site */
function compressed(files) {
  return files.reduce((sum, file) => sum + gzipSync(readFileSync(join(site, file)), { level: 9 }).length, 0);
}

function tarballSize() {
  const [command = "", ...args] = [...npm(), "pack", "--dry-run", "--json"];
  const { stdout } = spawnSync(command, args, { cwd: root, encoding: "utf8" });
  return JSON.parse(stdout)[0].size;
}
