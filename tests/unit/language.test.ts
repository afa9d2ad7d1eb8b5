/** Every language says everything: no key is missing, none is left over, and every value has its place. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, beforeAll, describe, expect, test } from "vitest";
import { help } from "../../web/generated/help.ts";
import { sourceOf } from "../../web/src/form/explanation.ts";
import { issueText } from "../../web/src/form/issue.ts";
import { quantityText } from "../../web/src/form/quantity.ts";
import { chinese } from "../../web/src/language/chinese.ts";
import { english } from "../../web/src/language/english.ts";
import { french } from "../../web/src/language/french.ts";
import { german } from "../../web/src/language/german.ts";
import { languageFor } from "../../web/src/language/load.ts";
import { adopt, pieces, say } from "../../web/src/language/say.ts";
import { spanish } from "../../web/src/language/spanish.ts";
import { check, init } from "../../web/src/package/node.ts";
import { declaredParameters, groupAndField, presets } from "../../web/src/params/declaration.ts";
import { languages } from "../../web/src/params/state.ts";

const dictionaries = { de: german, fr: french, es: spanish, zh: chinese } as const;
const tags = Object.keys(dictionaries) as (keyof typeof dictionaries)[];
const groups = new Set(declaredParameters.map(({ path }) => groupAndField(path)[0]));
const options = new Set(declaredParameters.flatMap(({ options = [] }) => options));
const places = (text: string) => [...text.matchAll(/\{\d\}/g)].map(([place]) => place).sort();

beforeAll(() => init());
afterEach(() => adopt("en", null));

test("there is a dictionary for every language but English", () => {
  expect(["auto", "en", ...tags].sort()).toEqual([...languages].sort());
});

test("every text of the catalogue is used, and no text twice", () => {
  const source = (folder: string): string =>
    readdirSync(folder, { withFileTypes: true })
      .filter(({ name }) => name !== "language")
      .map((entry) => {
        const path = join(folder, entry.name);
        return entry.isDirectory() ? source(path) : readFileSync(path, "utf8");
      })
      .join("\n");
  const code = source("web/src");
  expect(new Set(english).size).toBe(english.length);
  // The two tones of a theme are said by their names, and so is a name of "auto".
  expect(english.filter((text) => !code.includes(`"${text}"`))).toEqual([]);
});

describe.each(tags)("in %s", (tag) => {
  const { texts, parameters, presets: plates, names, issues, sources } = dictionaries[tag];

  test("every text has a translation with the same places for values", () => {
    expect(Object.keys(texts).sort()).toEqual([...english].sort());
    for (const text of english) {
      expect(texts[text].trim(), text).not.toBe("");
      expect(places(texts[text]), text).toEqual(places(text));
    }
  });

  test("every parameter, preset, group and option is named", () => {
    expect(Object.keys(parameters)).toEqual(declaredParameters.map(({ path }) => path));
    expect(Object.keys(plates)).toEqual(Object.keys(presets));
    expect(Object.keys(names).sort()).toEqual([...groups, ...options].sort());
    for (const words of [...Object.values(parameters), ...Object.values(plates)]) {
      expect(words.every((word) => word.trim() !== "")).toBe(true);
    }
  });

  test("the same number is in the help as in English: a translation forgets no range", () => {
    const numbers = (text: string) =>
      text
        .replaceAll(",", ".")
        .match(/\d+(\.\d+)?(e\d+)?/g)
        ?.sort() ?? [];
    for (const { path } of declaredParameters) {
      expect(numbers(parameters[path]?.[1] ?? ""), path).toEqual(numbers(help[path]?.[0] ?? "none"));
    }
  });

  test("every kind of issue has its sentence, with places that exist", () => {
    expect(Object.keys(issues).sort()).toEqual(Object.keys(german.issues).sort());
    for (const [key, pattern] of Object.entries(issues)) {
      expect(
        places(pattern).filter((place) => !/[0-3]/.test(place)),
        key,
      ).toEqual([]);
      expect(places(pattern), key).toEqual(places(german.issues[key] ?? ""));
    }
  });

  test("sources are said in the language", () => {
    adopt(tag, dictionaries[tag]);
    const english = ["section", "sections", "equation", "equations", "figures", "and"];
    expect(english.filter((word) => !(word in sources))).toEqual([]);
    for (const { path } of declaredParameters) {
      expect(sourceOf(path)).not.toMatch(
        tag === "fr" ? /\b(and|half)\b/ : /\b(section|equation|and|half)s?\b/i,
      );
    }
  });

  test.each([
    { axis: { segments: -1 } },
    { axis: { segments: 1.5, radius: Number.NaN } },
    { axis: { segments: 200000, segmentLength: "long" }, growth: { thickening: "fat" } },
    { axis: { segments: 100000 }, growth: { thickening: "pipes" } },
    { axis: { taper: 0 }, branching: { pattern: "bifurcation" } },
    { axis: { restTwist: 1, restCurvature: 1 }, solver: { method: "euler" } },
    { branching: { pattern: "bifurcation", generations: 15, girthRatio: 1e-5 } },
    { branching: { pattern: "bifurcation", generations: 30 } },
    { arrangement: { pattern: "stem", count: 1e5 }, axis: { segments: 100 } },
    { loads: { removed: 3 }, tropism: { azimuth: "east" } },
    { loads: { forces: [{ segment: 0, force: [0, 1, 0] }] }, arrangement: { pattern: "stem" } },
    { loads: { tipForce: [0, 1], forces: {} } },
    { axes: {}, solver: [] },
  ])("what the core finds is said without a word of English: %j", (params) => {
    const found = check(params);
    expect(found).not.toEqual([]);
    adopt(tag, dictionaries[tag]);
    for (const issue of found) {
      expect(issueText(issue)).not.toMatch(
        /\b(must|number|from|whole|one of|is not|would|the text|did you)\b/,
      );
      expect(issueText(issue)).not.toMatch(/\{\d\}|undefined/);
      expect(issueText(issue)).not.toBe(issue.message);
    }
  });

  test("numbers have the decimal mark of the language", () => {
    adopt(tag, dictionaries[tag]);
    expect(quantityText(0.0375, "m")).toBe(tag === "zh" ? "3.75 cm" : "3,75 cm");
    expect(quantityText(1.1e9, "Pa")).toBe(tag === "zh" ? "1.1 GPa" : "1,1 GPa");
  });
});

test("English is said as it is written, with values in their places", () => {
  expect(say("growth step {0} of {1}", 3, 40)).toBe("growth step 3 of 40");
  expect(pieces("growth step {0} of {1}", "a", "b")).toEqual(["growth step ", "a", " of ", "b", ""]);
  adopt("de", german);
  expect(say("growth step {0} of {1}", 3, 40)).toBe("Wachstumsschritt 3 von 40");
});

test.each([
  ["auto", ["de-AT", "en"], "de"],
  ["auto", ["nl", "fr-CA"], "fr"],
  ["auto", ["zh-Hans-CN"], "zh"],
  ["auto", ["ja"], "en"],
  ["auto", [], "en"],
  ["es", ["de"], "es"],
] as const)("%s with %j is %s", (wanted, own, language) => {
  expect(languageFor(wanted, own)).toBe(language);
});
