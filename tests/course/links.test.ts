/** Every link of the course leads somewhere, and every state is the one that its text names. */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { courseFolder } from "../../tools/course/pages.mjs";
import { quantityText } from "../../web/src/form/quantity.ts";
import { parameters, presetNamed } from "../../web/src/params/declaration.ts";
import { read, write } from "../../web/src/params/link.ts";
import { sameValue, stepsOf, valueAt } from "../../web/src/params/params.ts";
import { initialState, presetState } from "../../web/src/params/state.ts";
import { figures, links, pages, stateLinks } from "./text.ts";

/** How a text may name what it sets without the number, or with the number and without its unit. */
const words: Readonly<Record<string, RegExp>> = {
  "branching.exponent": /exponent/,
  "loads.removed": /loads taken off/,
  "tropism.strength": /per metre/,
};

/** A preset's figure: "13 c". */
const figureOf = (preset: string) => preset.replace(/^figure-(\d+)(.*)$/, "$1 $2").trim();

describe("links to states", () => {
  it.each(stateLinks)("$page: $text: $query", ({ text, query }) => {
    const { state, notices } = read(query);
    expect(notices, "it is read without a notice").toEqual([]);
    expect(write(state), "it is as the page writes it").toBe(`?${query}`);
    if (text === "Open it in Bough") return;
    const spoken = text.toLowerCase();
    const start = presetState(state.preset);
    let rest = spoken.replace(/figure \d+( [a-d]\b)?/g, "");
    for (const { path, unit } of parameters) {
      const value = valueAt(state.params, path);
      if (sameValue(value, valueAt(start.params, path))) continue;
      const number =
        typeof value === "number" ? [quantityText(value, unit), millimetres(value, unit), String(value)] : [];
      const said = number.find((one) => one !== "" && rest.includes(one)) ?? "";
      if (typeof value === "number") expect(said, `${path} is said`).not.toBe("");
      if (words[path]) expect(spoken).toMatch(words[path]);
      rest = rest.replace(said, "");
    }
    rest = rest.replace(String(start.step ?? stepsOf(state.params)), "");
    if (start.params.tropism.strength > 0) rest = rest.replace(String(start.params.tropism.strength), "");
    expect(rest, "no number is said that is not so").not.toMatch(/\d/);
    if (state.color !== initialState.color) expect(spoken).toContain(state.color);
    if (state.view !== initialState.view) expect(spoken).toContain("in space");
    if (state.style !== initialState.style) expect(spoken).toContain("rods and springs");
  });

  it("name their figure, or stand in a row that does", () => {
    for (const page of pages.keys()) {
      let present = "";
      for (const { text, query } of stateLinks.filter((link) => link.page === page)) {
        const { preset } = read(query).state;
        if (text === "Open it in Bough" || preset === null) continue;
        const title = presetNamed(preset)?.title.toLowerCase() ?? "";
        const [number = ""] = figureOf(preset).split(" ");
        const named = [`figure ${figureOf(preset)}`, `figure ${number}`, title].some((name) =>
          text.toLowerCase().includes(name),
        );
        expect(named || present === number || page === "index.html", `${page}: ${text}`).toBe(true);
        present = number;
      }
    }
  });
});

describe("other links", () => {
  const own = links.filter(({ address }) => !/^(https:|\.\.\/\?)/.test(address));
  it.each(own)("$page: $address", ({ page, address }) => {
    const [file = "", id] = address.split("#");
    // The docs are the site's other half, and built with it.
    const known =
      pages.has(file) || ["", "../index.html", "../docs/index.html", "../bough-widget.js"].includes(file);
    expect(known).toBe(true);
    if (id) expect(pages.get(file || page)).toContain(`id="${id}"`);
  });
});

it.each([...pages])("%s has every id once", (_, html) => {
  const ids = [...html.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id);
  expect(ids).toEqual([...new Set(ids)]);
});

describe("figures", () => {
  it.each([...figures.values()])(
    "$id has a poster, controls that exist, and a link that is read",
    (figure) => {
      const { state, notices } = read(figure.link.slice(1));
      expect(notices).toEqual([]);
      expect(write(state)).toBe(figure.link);
      const paths = parameters.map(({ path }) => path);
      expect(figure.fields.split(" ").filter((path) => !paths.includes(path))).toEqual([]);
      expect(existsSync(join(courseFolder, "posters", `${figure.id}.webp`))).toBe(true);
    },
  );
});

function millimetres(value: number, unit: string): string {
  return unit === "m" ? `${Math.round(value * 1e6) / 1e3} mm` : "";
}
