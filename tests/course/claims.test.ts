/** Every number and claim of the edition, against the core. */
import { beforeAll, describe, expect, it } from "vitest";
import { init } from "../../web/src/package/node.ts";
import { claims } from "./claims.ts";
import { chapters, prose } from "./text.ts";

beforeAll(() => init());

/** Numbers that name things: equations, figures, chapters, years, and indices and exponents in formulas. */
const names = [
  /\(\d+(?: to \d+)?\)/g,
  /\b[Ee]quations? \d+(?: and \d+)?/g,
  /\b[Ff]igures? \d+(?: [a-d]\b)?/g,
  /\b(?:chapter|recursion|segment) \d+/g,
  /\b(?:1881|1927|1998)\b/g,
  /\$[^$]*\$/g,
];

/** Formulas that state a number: these must be claimed. */
const stated = /\$[^$]*= ?\d[^$]*\$/g;

describe.each([...chapters.keys()])("chapter %s", (chapter) => {
  it("says what the core computes", () => {
    const text = prose(chapter);
    for (const claim of claims[chapter]?.() ?? []) {
      const [phrase, holds] = typeof claim === "string" ? [claim, true] : claim;
      expect.soft(text).toContain(phrase);
      expect.soft(holds, phrase).toBe(true);
    }
  });

  it("says no number that is not checked", () => {
    let text = prose(chapter);
    for (const claim of claims[chapter]?.() ?? []) {
      text = text.replace(typeof claim === "string" ? claim : claim[0], " ✓ ");
    }
    expect(
      [...text.matchAll(stated)].map(([formula]) => formula).filter((one) => one !== "$T_0 = 0$"),
    ).toEqual([]);
    for (const name of names) text = text.replace(name, " ");
    expect(text.match(/[^.?!]*\d[^.?!]*/g) ?? []).toEqual([]);
  });
});
