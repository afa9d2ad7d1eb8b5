/**
 * The same params give the same plant to the last bit: natively, in Node's wasm, and as recorded.
 *
 * To change the record on purpose (a better solver, say), write it anew and say why in CHANGELOG.md:
 * `cargo run --release --quiet --manifest-path rust-core/Cargo.toml --example fingerprints > tests/contract/fingerprints.txt`
 */
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { history, init, presets } from "../../web/src/package/node.ts";
import { fingerprint } from "../fingerprint.ts";

const recorded = readFileSync(new URL("fingerprints.txt", import.meta.url), "utf8");

beforeAll(() => init());

test("wasm in Node grows every preset as recorded", () => {
  const lines = Object.entries(presets).flatMap(([id, { params, step = Number.POSITIVE_INFINITY }]) => {
    const solver = { ...params.solver, discretization: "paper" as const };
    const asDeclared = fingerprint(history(params).at(step));
    const asInPaper = fingerprint(history({ ...params, solver }).at(step));
    return [`${id} ${asDeclared}\n`, `${id}/paper ${asInPaper}\n`];
  });
  expect(lines.join("")).toBe(recorded);
});

test("the native core grows every preset as recorded", { timeout: 600_000 }, () => {
  const manifest = new URL("../../rust-core/Cargo.toml", import.meta.url).pathname;
  const run = ["run", "--release", "--quiet", "--locked", "--manifest-path", manifest];
  const { stdout, stderr } = spawnSync(
    "cargo",
    [...run, "--package", "bough-plant", "--example", "fingerprints"],
    {
      encoding: "utf8",
    },
  );
  expect(stdout, stderr).toBe(recorded);
});

test("the fingerprint sees the last bit of every array", () => {
  const plant = history({ axis: { segments: 3 } }).at(3);
  const before = fingerprint(plant);
  for (const array of [...Object.values(plant.polylines), ...Object.values(plant.segments)]) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    bytes[0] = (bytes[0] ?? 0) ^ 1;
    expect(fingerprint(plant)).not.toBe(before);
    bytes[0] ^= 1;
  }
  expect(fingerprint(plant)).toBe(before);
});
