/** The engine over the real core, in this thread; `tests/browser` has it in a worker. */
import { afterEach, beforeAll, describe, expect, test, vi } from "vitest";
import * as glue from "../../web/generated/bough.js";
import { type Engine, threadEngine } from "../../web/src/engine/engine.ts";
import { grow, history, init } from "../../web/src/package/node.ts";
import { fingerprint } from "../fingerprint.ts";

beforeAll(() => init());
afterEach(() => {
  vi.restoreAllMocks();
});

/** Takes a good part of a second. */
const large = { axis: { segments: 3000, segmentLength: 0.0005 } };

test("grows the plant that grow grows, at any age", async () => {
  const engine = threadEngine();
  const ages = history({});
  expect(fingerprint(await engine.plant({}))).toBe(fingerprint(grow({})));
  for (const step of [7, 39, 1, 40]) {
    expect(fingerprint(await engine.plant({}, step))).toBe(fingerprint(ages.at(step)));
  }
  expect((await engine.plant({}, 1000)).report.steps).toBe(40);
});

test("checks as check does, and rejects bad params with the same list", async () => {
  const engine = threadEngine();
  const bad = { axis: { segments: -1, colour: "green" } };
  const issues = await engine.check(bad);
  expect(issues.map(({ code }) => code)).toEqual(["outOfRange", "unknownKey"]);
  await expect(engine.plant(bad)).rejects.toMatchObject({ name: "BoughError", issues });
  await expect(engine.plant({ axis: { restTwist: 1 }, solver: { method: "euler" } })).rejects.toMatchObject({
    issues: [{ code: "unsupported", path: "solver.method" }],
  });
});

test("leaves its thread room to breathe, and tells how far it is", async () => {
  const shares: number[] = [];
  // Counted, not timed: however fast the machine is, others get their turn in every slice. A timer would wait 1 ms for its own,
  // and the first slices take less.
  const turns: number[] = [];
  let turn = 0;
  const take = () => {
    turn++;
    waiting = setImmediate(take);
  };
  let waiting = setImmediate(take);
  const onProgress = (share: number) => {
    shares.push(share);
    turns.push(turn);
  };
  await threadEngine().plant(large, null, { onProgress });
  clearImmediate(waiting);
  expect(shares.length).toBeGreaterThan(5);
  expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  expect(shares.every((share) => share > 0 && share < 1)).toBe(true);
  expect(new Set(turns).size).toBe(turns.length);
});

test("the newest request wins: the older one ends long before it would be done", async () => {
  const engine = threadEngine();
  const older = engine.plant(large);
  const newer = engine.plant({}, 3);
  await expect(older).rejects.toMatchObject({ name: "AbortError" });
  expect((await newer).report.steps).toBe(3);
});

test("an abort ends the work, and the next request is answered", async () => {
  const engine = threadEngine();
  const aborter = new AbortController();
  const aborted = engine.plant(large, null, { signal: aborter.signal, onProgress: () => aborter.abort() });
  await expect(aborted).rejects.toMatchObject({ name: "AbortError" });
  expect((await engine.plant({})).report.steps).toBe(40);
});

describe("a trap in the wasm", () => {
  /** Makes the next step of growth reach outside the memory of the real instance. */
  function sabotage(): void {
    const { history_seek } = glue.initSync({ module: new ArrayBuffer(0) });
    vi.spyOn(glue.History.prototype, "seek").mockImplementationOnce((step, budget) => {
      return history_seek(0x7fff_fff0, step, budget) !== 0;
    });
  }
  const sentence = /^The computation broke off: the memory ran out, or this is a fault of Bough \(.+\)\./;

  test("rejects with a sentence, and the next request is answered", async () => {
    const engine: Engine = threadEngine();
    const before = fingerprint(await engine.plant({}));
    sabotage();
    await expect(engine.plant({}, 3)).rejects.toThrow(sentence);
    expect(fingerprint(await engine.plant({}))).toBe(before);
  });

  test("throws the sentence, and histories made before go on", () => {
    const ages = history({});
    const before = fingerprint(ages.at(30));
    sabotage();
    expect(() => grow({})).toThrow(sentence);
    expect(fingerprint(ages.at(30))).toBe(before);
    ages.dispose();
  });

  // Needs the glue's reset function; without it the instance that trapped is used on.
  test.runIf("__wbg_reset_state" in glue)("makes way for a fresh instance", () => {
    const memory = () => glue.initSync({ module: new ArrayBuffer(0) }).memory;
    const before = memory();
    sabotage();
    expect(() => grow({})).toThrow(sentence);
    expect(memory()).not.toBe(before);
  });
});
