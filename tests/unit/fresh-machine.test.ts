/** On a fresh machine set-up installs the packages: what starts before it may import none. */
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** Packages that a script imports before its first line runs, and by which file. */
function packagesBefore(script: string): string[] {
  const seen = new Set<string>();
  const found: string[] = [];
  const read = (file: string) => {
    if (seen.has(file)) return;
    seen.add(file);
    const source = readFileSync(file, "utf8");
    for (const [, from = ""] of source.matchAll(
      /^(?:import|export)\b[^;"]*?from "([^"]+)";|^import "([^"]+)";/gm,
    )) {
      if (from.startsWith(".")) read(join(dirname(file), from));
      else if (!from.startsWith("node:")) found.push(`${file.slice(root.length)}: ${from}`);
    }
  };
  read(join(root, script));
  expect(seen.size).toBeGreaterThan(1);
  return found;
}

const { scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));

it.each(["start", "test", "check", "build", "fix", "soak", "bench"])(
  "npm run %s begins without packages",
  (name) => {
    expect(packagesBefore(scripts[name].replace("node ", ""))).toEqual([]);
  },
);
