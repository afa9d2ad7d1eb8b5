import { readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parameters, presets } from "../../web/src/params/declaration.ts";
import { LINK_VERSION, read, reservedKeys, write } from "../../web/src/params/link.ts";
import { complete } from "../../web/src/params/params.ts";
import { initialState, presetState, type State } from "../../web/src/params/state.ts";
import { anyState, faults } from "../states.ts";

const figure8a: State = { ...initialState, ...presetState("figure-8a") };

describe("writing", () => {
  test("the default state is the version alone", () => {
    expect(write(initialState)).toBe("?v=1");
  });

  test("only what differs from the preset, under short keys, numbers at their shortest", () => {
    expect(write(figure8a)).toBe("?v=1&preset=figure-8a");
    const params = complete({ ...presets["figure-8a"]?.params, loads: { gravity: 3 } });
    expect(write({ ...figure8a, params })).toBe("?v=1&preset=figure-8a&g=3");
  });

  test("choices by name, flags as 1, vectors with commas, large numbers without a plus sign", () => {
    const params = complete({
      material: { youngsModulus: 1e15 },
      growth: { thickening: "pipes" },
      loads: { tipForce: [0.5, -1e-9, 1e12], removed: true },
      tropism: { strength: 1e-300 },
    });
    const link = write({ ...initialState, params, step: 7, view: "space", theme: "dark" });
    expect(link).toBe(
      "?v=1&ym=1000000000000000&tk=1e-300&th=pipes&tf=0.5,-1e-9,1000000000000&rm=1&step=7&view=space&theme=dark",
    );
    expect(read(link).state.params).toEqual(params);
  });

  test("full grown is said where the preset says otherwise", () => {
    expect(write({ ...figure8a, step: null })).toBe("?v=1&preset=figure-8a&step=full");
    expect(read("?v=1&preset=figure-8a&step=full").state.step).toBeNull();
    expect(read("?v=1&preset=figure-8a").state.step).toBe(10);
  });

  test("no parameter takes a reserved key, or a character that a query would have to encode", () => {
    const keys = parameters.map(({ key }) => key);
    expect(keys.filter((key) => reservedKeys.includes(key))).toEqual([]);
    const names = [...keys, ...Object.keys(presets), ...parameters.flatMap(({ options = [] }) => options)];
    expect(names.filter((name) => name !== encodeURIComponent(name))).toEqual([]);
  });
});

describe("repairing", () => {
  test.each([
    [
      "g=-1",
      "outOfRange",
      'loads.gravity is "-1" in the link; it must be a number from 0 to 1e6 m/s2, so 0 is taken.',
    ],
    ["g=1e999", "outOfRange", "so 1e6 is taken."],
    ["g=abc", "unreadable", "so 9.81 is taken."],
    ["g=", "unreadable", "so 9.81 is taken."],
    ["g=NaN", "unreadable", "so 9.81 is taken."],
    ["g=0x10", "unreadable", "so 9.81 is taken."],
    ["n=40.6", "notInteger", "so 41 is taken."],
    ["n=1e9", "outOfRange", "so 100000 is taken."],
    ["th=bark", "unreadable", "one of none, pipes, so none is taken."],
    ["rm=yes", "unreadable", "true or false, so false is taken."],
    ["tf=1,2", "unreadable", "so 0,0,0 is taken."],
    ["tf=1,2,3,4", "unreadable", "so 0,0,0 is taken."],
    ["tf=1,2,1e13", "outOfRange", "so 1,2,1000000000000 is taken."],
    ["colour=red", "unknownKey", "The link's colour means nothing here and is ignored."],
    [
      "preset=figure-99",
      "unknownPreset",
      "There is no preset figure-99; the default plant is taken instead.",
    ],
    ["preset=__proto__", "unknownPreset", "There is no preset __proto__"],
    ["step=0", "outOfRange", "a whole number from 1 to 40, so step 1 is shown."],
    ["step=41", "outOfRange", "so step 40 is shown."],
    ["step=old", "unreadable", "so the full-grown plant is shown."],
    ["view=sideways", "unreadable", "one of plane, space, so plane is taken."],
    ["v=2", "version", "The link is of version 2, which is not known here; it is read as version 1."],
    ["g=1&g=2&g=3", "repeated", "The link gives g more than once; the last one, 3, is taken."],
  ])("?%s is repaired, and said", (query, code, sentence) => {
    const { state, notices } = read(query);
    expect(notices).toMatchObject([{ code, message: expect.stringContaining(sentence) }]);
    expect(faults(state)).toEqual([]);
  });

  test("of a repeated key the last counts", () => {
    expect(read("?g=1&g=2").state.params.loads.gravity).toBe(2);
  });

  test("a plus sign that was not encoded is still one", () => {
    expect(read("?ym=1e+9")).toMatchObject({
      state: { params: { material: { youngsModulus: 1e9 } } },
      notices: [],
    });
  });

  test("keys of the page around are no mistake", () => {
    expect(read("?lang=de&ui=compact&pin=1&step=full").notices).toEqual([]);
  });

  test("a preset's step beyond a shorter axis is its last", () => {
    expect(read("?preset=figure-8c&n=20").state.step).toBe(20);
  });

  test("a thousand unknown keys are one short notice", () => {
    const query = Array.from({ length: 1000 }, (_, index) => `k${index}=1`).join("&");
    const { notices } = read(query);
    expect(notices).toHaveLength(1);
    expect(notices[0]?.message.length).toBeLessThan(200);
  });
});

test("10,000 random states survive exactly", () => {
  fc.assert(
    fc.property(anyState, (state) => {
      const { state: reopened, notices } = read(write(state));
      expect(notices).toEqual([]);
      expect(reopened).toStrictEqual(state);
    }),
    { numRuns: 10_000, seed: 8 },
  );
});

test("10,000 damaged links end in a valid state, with a sentence for all that was changed", () => {
  const piece = fc.oneof(
    fc.string({ unit: "binary", maxLength: 4 }),
    fc.constantFrom(
      "&",
      "=",
      "%",
      "%E0%A4",
      "+",
      ",",
      "-",
      "e",
      "1e999",
      "NaN",
      "&g=",
      "&__proto__=1",
      "&n=-0",
    ),
  );
  const damaged = fc
    .record({ state: anyState, from: fc.nat(200), drop: fc.nat(20), piece, end: fc.nat(300) })
    .map(({ state, from, drop, piece, end }) => {
      const link = write(state);
      return `${link.slice(0, from)}${piece}${link.slice(from + drop)}`.slice(0, end);
    });
  fc.assert(
    fc.property(damaged, (link) => {
      const { state, notices } = read(link);
      expect(faults(state)).toEqual([]);
      expect(notices.filter(({ message }) => !/^\S.*\.$/s.test(message))).toEqual([]);
      // What was repaired once needs no repair again.
      expect(read(write(state))).toStrictEqual({ state, notices: [] });
    }),
    { numRuns: 10_000, seed: 8 },
  );
});

/** One link a line, with what it must mean. Add lines; a line that was released never changes. */
const kept = readFileSync(new URL("links-v1.jsonl", import.meta.url), "utf8")
  .trimEnd()
  .split("\n")
  .map((line): { link: string; state: object } => JSON.parse(line));

test.each(kept)("$link keeps its meaning for ever", ({ link, state }) => {
  expect(read(link)).toMatchObject({ state, notices: [] });
});

test("the links kept are of the present version, and name every preset", () => {
  expect(LINK_VERSION).toBe(1);
  const named = kept.map(({ link }) => new URLSearchParams(link).get("preset"));
  expect(Object.keys(presets).filter((id) => !named.includes(id))).toEqual([]);
});
