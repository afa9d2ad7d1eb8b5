/** Memory over many calls; `npm run soak` has the same with a million of them. */
import { beforeAll, expect, test } from "vitest";
import * as glue from "../../web/generated/bough.js";
import { BoughError, grow, history, init, type ParamsInput } from "../../web/src/package/node.ts";
import { fingerprint } from "../fingerprint.ts";

beforeAll(() => init());

/** Bytes of the wasm's memory, which never shrinks. */
function memory(): number {
  return glue.initSync({ module: new ArrayBuffer(0) }).memory.buffer.byteLength;
}

test("twenty thousand plants leave no memory behind", () => {
  const params = { axis: { segments: 12 }, growth: { thickening: "pipes" } } as const;
  grow(params);
  const before = memory();
  for (let call = 0; call < 20_000; call++) grow({ ...params, loads: { gravity: call / 1000 } });
  expect(memory()).toBe(before);
});

test("a thousand large ones neither, nor histories that are disposed of half-way", () => {
  const params = { axis: { segments: 100 }, growth: { thickening: "pipes" } } as const;
  grow(params);
  const before = memory();
  for (let call = 0; call < 1000; call++) {
    const ages = history({ ...params, loads: { gravity: call / 100 } });
    ages.at(60);
    ages.dispose();
  }
  expect(memory()).toBe(before);
});

test("ten thousand calls that fail leave none either, and the next good one works", () => {
  const good = fingerprint(grow({}));
  const before = memory();
  const bad: unknown[] = [null, "axis", { axis: 1 }, { axis: { segments: Number.NaN } }, { leaves: {} }];
  let failed = 0;
  for (let call = 0; call < 10_000; call++) {
    try {
      grow(bad[call % bad.length] as ParamsInput);
    } catch (error) {
      if (error instanceof BoughError && error.issues.length > 0) failed++;
    }
  }
  expect(failed).toBe(10_000);
  expect(memory()).toBe(before);
  expect(fingerprint(grow({}))).toBe(good);
});
