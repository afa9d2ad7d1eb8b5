// The files of a recipe, as web/course/recipes.md prints them: what is tried is what a reader copies.

import { readFileSync } from "node:fs";
import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { courseFolder } from "../course/pages.mjs";
import { Obstacle } from "../obstacle.mjs";

/**
 * @param {string} name of the recipe
 * @returns {Map<string, string>} content by path
 */
export function recipe(name) {
  const text = readFileSync(join(courseFolder, "recipes.md"), "utf8");
  const blocks = text.matchAll(/^```\w+ (\w+)\/(\S+)\n(.*?)^```$/gms);
  const own = [...blocks].filter(([, recipe]) => recipe === name);
  if (own.length === 0) throw new Obstacle(`There is no recipe ${name}.`);
  return new Map(own.map(([, , file = "", content = ""]) => [file, content]));
}

/**
 * Lays the files of a recipe into a folder.
 * @param {string} name
 * @param {string} folder
 */
export async function layOut(name, folder) {
  for (const [file, content] of recipe(name)) {
    await mkdir(dirname(join(folder, file)), { recursive: true });
    await writeFile(join(folder, file), content);
  }
}
