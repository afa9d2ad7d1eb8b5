// What makes the site work without a network after the first visit: a service worker that keeps every file of the explorer.
// A Vite plugin; the list of files is the build's own, and the name of the cache is a hash of what is in them.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join, sep } from "node:path";
import { root } from "./paths.mjs";

const shared = join(root, "public");
const template = join(root, "tools", "offline", "service-worker.js");

/** @returns {import("vite").Plugin} */
export function offline() {
  return {
    name: "bough-offline",
    enforce: "post",
    apply: "build",
    generateBundle(_, bundle) {
      const files = readdirSync(shared, { recursive: true, withFileTypes: true })
        .filter((entry) => entry.isFile())
        .map(({ parentPath, name }) => join(parentPath, name));
      // The course is read elsewhere: its figures are none of the explorer's files.
      const built = Object.values(bundle).filter(({ fileName }) => !/^course\/|\.map$/.test(fileName));
      const hash = createHash("sha256");
      for (const file of files) hash.update(readFileSync(file));
      for (const file of built) hash.update(file.type === "chunk" ? file.code : file.source);
      const names = [
        ...built.map(({ fileName }) => fileName),
        ...files.map((file) => file.slice(shared.length + 1).replaceAll(sep, "/")),
      ];
      const source = readFileSync(template, "utf8")
        .replace('"FILES"', JSON.stringify(["./", ...names.sort()]))
        .replace("VERSION", hash.digest("hex").slice(0, 16));
      this.emitFile({ type: "asset", fileName: "service-worker.js", source });
    },
  };
}
