// A style sheet that stands alone, for pages that are built without a bundler.

import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

/**
 * The sheet with what it imports in place.
 * @param {string} file
 * @returns {string}
 */
export function stylesheet(file) {
  return readFileSync(file, "utf8").replace(/^@import "(.+)";$/gm, (_, other) =>
    stylesheet(join(dirname(file), other)),
  );
}
