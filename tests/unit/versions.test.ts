import { expect, test } from "vitest";
import { requireNode } from "../../tools/setup/node-version.mjs";
import { isAtLeast, nodeWillDo, parseVersion } from "../../tools/setup/versions.mjs";

test("versions are read as tools print them", () => {
  expect(parseVersion("v20.19.1")).toEqual([20, 19]);
  expect(parseVersion("cargo 1.95.0 (f2d3ce0bd 2026-03-21)")).toEqual([1, 95]);
  expect(parseVersion("unknown")).toBeUndefined();
});

test("versions compare by number, not by letter", () => {
  expect(isAtLeast("1.100.0", "1.85")).toBe(true);
  expect(isAtLeast("1.85.0", "1.85")).toBe(true);
  expect(isAtLeast("1.84.1", "1.85")).toBe(false);
  expect(isAtLeast("2.0.0", "1.85")).toBe(true);
  expect(isAtLeast("unknown", "1.85")).toBe(false);
});

test.each(["v20.19.0", "v20.20.2", "v22.12.0", "v24.1.0"])("Node %s will do", (version) => {
  expect(nodeWillDo(version)).toBe(true);
});

test.each(["v12.22.0", "v18.20.4", "v20.18.3", "v21.7.0", "v22.11.0"])("Node %s is too old", (version) => {
  expect(nodeWillDo(version)).toBe(false);
  expect(() => requireNode(version)).toThrow(`this is Node ${version}`);
});
