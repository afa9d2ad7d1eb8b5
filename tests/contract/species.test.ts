/** docs/species.md says what the presets of real plants have, and what comes out: here it is measured again. */
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import { measure } from "../../web/src/geometry/measure.ts";
import { grow, history, init, presets } from "../../web/src/package/node.ts";

const page = readFileSync(new URL("../../docs/species.md", import.meta.url), "utf8");
const species = Object.keys(presets).filter((id) => !id.startsWith("figure-"));

/** The rows of the table with this first heading and so many columns of numbers, by preset. */
function table(second: string): Map<string, string[]> {
  const lines = page.split("\n");
  const head = lines.findIndex((line) => line.startsWith(`| preset | ${second} `));
  const rows = lines.slice(head + 2, lines.indexOf("", head));
  return new Map(
    rows.map((row) => {
      const [id = "", ...cells] = row
        .split("|")
        .slice(1, -1)
        .map((cell) => cell.trim());
      return [id, cells];
    }),
  );
}

const values = table("length (m)");
const outcomes = table("out (m)");

beforeAll(() => init());

test("both tables have every species, and nothing else", () => {
  expect([...values.keys()]).toEqual(species);
  expect([...outcomes.keys()]).toEqual(species);
});

/** A number in as many decimals as another is printed with. */
const printed = (value: number, like: string) =>
  value.toFixed(like.split(".")[1]?.length ?? 0).replace(/^-(0\.?0*)$/, "$1");

describe.each(species)("%s", (id) => {
  const { params = {}, step = Number.POSITIVE_INFINITY } = presets[id] ?? {};
  const plant = () => history(params).at(step);

  test("has the values that are said", () => {
    const { params, polylines, ...grown } = plant();
    const { axis, length } = measure({ params, polylines, ...grown });
    const radius = polylines.radii[polylines.offsets[axis] ?? 0] ?? 0;
    const { youngsModulus, density, modulusOfRupture } = params.material;
    const is = [length, 2e3 * radius, youngsModulus / 1e9, density, modulusOfRupture / 1e6];
    const said = values.get(id) ?? [];
    expect(is.map((value, column) => printed(value, said[column] ?? ""))).toEqual(said);
  });

  test("comes out as is said, in stable equilibrium and unbroken", () => {
    const grown = plant();
    const { tip, tipElevation } = measure(grown);
    const { report } = grown;
    expect(report).toMatchObject({ status: "converged", stable: true, unstableSince: null });
    expect(report.safetyFactor).toBeGreaterThan(1);
    const out = Math.hypot(tip[0], tip[2]);
    const is = [out, tip[1], grown.params.axis.elevation, tipElevation, report.safetyFactor ?? 0];
    const said = outcomes.get(id) ?? [];
    expect(is.map((value, column) => printed(value, said[column] ?? ""))).toEqual(said);
  });
});

test("the apple branch rises again by less than it sank", () => {
  const { params = {} } = presets["apple-fruit"] ?? {};
  const height = (loads: object) => measure(grow({ ...params, loads: { ...params.loads, ...loads } })).tip[1];
  const [bare, laden, picked] = [height({ tipMass: 0 }), height({}), height({ picked: true })];
  expect(Math.round(100 * (bare - laden))).toBe(16);
  expect(Math.round(100 * (picked - laden))).toBe(1);
});

test("wheat breaks between 14 and 15 m/s", () => {
  const { params = {} } = presets.wheat ?? {};
  const safety = (wind: number) => grow({ ...params, loads: { ...params.loads, wind } }).report.safetyFactor;
  expect(safety(14)).toBeGreaterThan(1);
  expect(safety(15)).toBeLessThan(1);
});
