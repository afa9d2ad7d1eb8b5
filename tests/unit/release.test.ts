/** What must agree before a version is published. */
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { version } from "../../web/src/params/declaration.ts";

function read(file: string): string {
  return readFileSync(new URL(`../../${file}`, import.meta.url), "utf8");
}

const manifest = JSON.parse(read("package.json"));

test("one version everywhere", () => {
  expect(manifest.version).toBe(version);
  expect(read("rust-core/Cargo.toml")).toContain(`\nversion = "${version}"\n`);
  expect(read("CITATION.cff")).toContain(`\nversion: ${version}\n`);
  expect(read("CHANGELOG.md")).toMatch(
    new RegExp(`^## (Unreleased|${version.replaceAll(".", "\\.")}\\b)`, "m"),
  );
});

test("the Rust and the Node that README asks for are those that the manifests ask for", () => {
  const [, rust] = /^rust-version = "(.+)"$/m.exec(read("rust-core/Cargo.toml")) ?? [];
  expect(read("README.md")).toContain(`Rust ${rust} or later`);
  expect(read("rust-core/bough/README.md")).toContain(`Minimum Rust: ${rust}`);
  expect(read("README.md")).toContain(`Node ${manifest.engines.node.replace(">=", "")} or later`);
});

test("nothing is installed with the package, and nothing runs when it is", () => {
  expect(manifest).not.toHaveProperty("dependencies");
  // Only the element draws with three: who wants it says so.
  expect(Object.keys(manifest.peerDependencies)).toEqual(["three"]);
  expect(manifest.peerDependenciesMeta).toEqual({ three: { optional: true } });
  expect(
    Object.keys(manifest.scripts).filter((name) => /^(pre|post)?(install|prepare|pack)/.test(name)),
  ).toEqual([]);
});

test("types come first in every export", () => {
  for (const target of Object.values<string | Record<string, string>>(manifest.exports)) {
    if (typeof target === "object") expect(Object.keys(target)[0]).toBe("types");
  }
});
