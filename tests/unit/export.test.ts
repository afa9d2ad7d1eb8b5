/** What is taken away: read back by means that are not ours, or to the same numbers. */
import { readFileSync } from "node:fs";
import fc from "fast-check";
import { beforeAll, describe, expect, test } from "vitest";
import { bibtex, citation, paper, software } from "../../web/src/export/citation.ts";
import { documentOf, read } from "../../web/src/export/document.ts";
import { drawing } from "../../web/src/export/drawing.ts";
import { table } from "../../web/src/export/table.ts";
import { grow, init } from "../../web/src/package/node.ts";
import { presets, version } from "../../web/src/params/declaration.ts";
import { complete } from "../../web/src/params/params.ts";
import { initialState, presetState } from "../../web/src/params/state.ts";
import type { Plant } from "../../web/src/plant/plant.ts";
import { anyState } from "../states.ts";

let plant: Plant;
beforeAll(async () => {
  await init();
  plant = grow(complete(presets["figure-18a"]?.params ?? {}));
});

describe("the table", () => {
  test("reads back to the same numbers, each under a name with its unit", () => {
    const [head = "", ...rows] = table(plant).trimEnd().split("\r\n");
    const names = head.split(",");
    const column = (name: string) => rows.map((row) => Number(row.split(",")[names.indexOf(name)]));
    const { segments, polylines } = plant;
    expect(rows).toHaveLength(segments.parent.length);
    expect(rows.every((row) => row.split(",").length === names.length)).toBe(true);
    expect(column("parent")).toEqual([...segments.parent]);
    expect(column("birth (growth step)")).toEqual([...segments.birth]);
    expect(column("length (m)")).toEqual([...segments.length]);
    expect(column("bending moment (N m)")).toEqual([...segments.moment]);
    expect(column("rest curvature (1/m)")).toEqual([...segments.restCurvature]);
    expect(column("largest stress (Pa)")).toEqual([...segments.stress]);
    expect(column("end y (m)")).toEqual([...segments.point].map((point) => polylines.points[3 * point + 1]));
    // Each segment begins where the one that bears it ends.
    const [x, parent] = [column("end x (m)"), column("parent")];
    column("base x (m)").forEach((base, segment) => {
      const bearer = parent[segment] ?? -1;
      expect(base).toBe(bearer < 0 ? polylines.points[0] : x[bearer]);
    });
  });
});

describe("the drawing", () => {
  test("has a path for every axis, as long as the axis is in millimetres", () => {
    const paths = [...drawing(plant, "a < b & c").matchAll(/<path [^>]*d="M([^"]*)"/g)].map(([, line = ""]) =>
      line.split("L").map((point) => point.split(" ").map(Number)),
    );
    const { offsets, points } = plant.polylines;
    expect(paths).toHaveLength(offsets.length - 1);
    paths.forEach((line, axis) => {
      const first = offsets[axis] ?? 0;
      expect(line).toHaveLength((offsets[axis + 1] ?? 0) - first);
      const last = first + line.length - 1;
      for (const k of [0, 1]) {
        const drawn = (line.at(-1)?.[k] ?? 0) - (line[0]?.[k] ?? 0);
        const grown =
          1000 * ((points[3 * last + k] ?? 0) - (points[3 * first + k] ?? 0)) * (k === 1 ? -1 : 1);
        // Both ends are rounded to a hundred-thousandth of the whole, which is below 2 m.
        expect(Math.abs(drawn - grown)).toBeLessThan(0.02);
      }
    });
    expect(drawing(plant, "a < b & c")).toContain("<title>a &lt; b &amp; c</title>");
  });
});

describe("the document", () => {
  test("opens to the state that was saved, whatever that was", () => {
    fc.assert(
      fc.property(anyState, (state) => {
        const opened = read(documentOf(state));
        if (typeof opened === "string") throw new Error(opened);
        const { theme, lang } = initialState;
        expect({ ...initialState, ...opened.state, params: complete(opened.params as object) }).toEqual({
          ...state,
          theme,
          lang,
        });
      }),
      { numRuns: 200 },
    );
  });

  test("plain params, as programs write them, are one", () => {
    expect(read('{"axis":{"segments":12}}')).toEqual({
      params: { axis: { segments: 12 } },
      state: { preset: null, step: null },
    });
  });

  test.each([
    ["notJson", "n,l\n40,3"],
    ["notJson", ""],
    ["notJson", '{"axis":'],
    ["notAPlant", "[1, 2]"],
    ["notAPlant", "null"],
    ["notAPlant", '{"format":"somebody-else","edition":1}'],
    ["notAPlant", '{"format":"bough-plant"}'],
    [
      "newer",
      documentOf({ ...initialState, ...presetState("figure-8a") }).replace('"edition": 1', '"edition": 2'),
    ],
  ])("%s is said of %j", (refusal, text) => {
    expect(read(text)).toBe(refusal);
  });

  test("never throws, and takes only names and steps there are", () => {
    fc.assert(
      fc.property(fc.json(), fc.json(), (step, params) => {
        const opened = read(
          `{"format":"bough-plant","edition":1,"params":${params},"step":${step},"view":${step}}`,
        );
        if (typeof opened === "string") throw new Error(opened);
        expect(opened.state.step === null || Number.isInteger(opened.state.step)).toBe(true);
        expect(opened.state.view).toBeUndefined();
      }),
    );
  });
});

describe("the citation", () => {
  test("says what CITATION.cff says", () => {
    const cff = readFileSync("CITATION.cff", "utf8");
    expect(cff).toContain(`title: "${software.title}"`);
    expect(cff).toContain(`- name: ${software.authors}`);
    expect(cff).toContain(`title: ${paper.title}`);
    expect(cff).toContain(`year: ${paper.year}`);
    for (const [family, given] of paper.authors) {
      expect(cff).toMatch(new RegExp(`family-names: ${family}\\s+given-names: ${given}`));
    }
  });

  test("names the paper, Bough with its version, and the link to the very plant", () => {
    const link = "https://example.org/?v=1&preset=figure-8a";
    for (const text of [citation(link), bibtex(link)]) {
      for (const part of [paper.title, software.title, version, link, "Prusinkiewicz"])
        expect(text).toContain(part);
    }
    expect(bibtex(link).match(/^@\w+\{/gm)).toHaveLength(2);
  });
});
