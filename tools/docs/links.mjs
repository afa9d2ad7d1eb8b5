// Whether every link of the built docs leads somewhere: files, and places in them. Links to other hosts must be https.

import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { Obstacle } from "../obstacle.mjs";

/**
 * @param {string} site the whole site, as docs link to what is beside them
 * @param {string} folder of the docs in it
 * @returns {number} how many links there are
 */
export function checkLinks(site, folder) {
  const files = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((file) =>
    file.endsWith(".html"),
  );
  const broken = [];
  let count = 0;
  for (const file of files.map((name) => join(folder, name))) {
    const html = readFileSync(file, "utf8");
    for (const [, address = ""] of html.matchAll(/\b(?:href|src)="([^"]*)"/g)) {
      count++;
      const problem = problemOf(file, address.replaceAll("&amp;", "&"), site);
      if (problem) broken.push(`${relative(site, file)}: ${address} ${problem}`);
    }
  }
  if (broken.length > 0)
    throw new Obstacle(`${broken.length} of ${count} links are broken.`, { output: broken.join("\n") });
  return count;
}

/**
 * @param {string} file
 * @param {string} address
 * @param {string} site
 */
function problemOf(file, address, site) {
  if (/^[a-z]+:/i.test(address))
    return URL.canParse(address) && address.startsWith("https:") ? "" : "is no https address";
  const [path = "", place = ""] = address.split("#");
  const target = path === "" ? file : join(dirname(file), decodeURIComponent(path));
  if (relative(site, target).startsWith("..")) return "leaves the site";
  if (!existsSync(target) || !statSync(target).isFile()) return "does not exist";
  if (place === "") return "";
  return readFileSync(target, "utf8").includes(` id="${decodeURIComponent(place)}"`)
    ? ""
    : "has no such place";
}
