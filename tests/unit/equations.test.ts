import { expect, test } from "vitest";
import { equations } from "../../web/src/form/equations.ts";
import { parameterAt, parameters } from "../../web/src/params/declaration.ts";

test("every equation belongs to a parameter that exists", () => {
  expect(Object.keys(equations).filter((path) => !parameterAt(path))).toEqual([]);
});

test("every parameter of the form has the equation that it enters", () => {
  expect(parameters.map(({ path }) => path).filter((path) => !equations[path])).toEqual([]);
});

test.each(Object.entries(equations))(
  "the equation of %s is whole MathML, with a caption",
  (_, { caption, mathml }) => {
    expect(caption).toMatch(/^[A-Z].+[^.]$/);
    expect(mathml).toMatch(/^<math xmlns="[^"]+" display="block">.*<\/math>$/);
    const open: string[] = [];
    for (const [tag, closes, name = "", isEmpty] of mathml.matchAll(/<(\/?)([a-z]+)[^>]*?(\/?)>/g)) {
      if (closes) expect(open.pop(), tag).toBe(name);
      else if (!isEmpty) open.push(name);
    }
    expect(open).toEqual([]);
    // Content for reading only: nothing that loads, runs or styles.
    expect(mathml).not.toMatch(/style=|on[a-z]+=|href|<script/);
  },
);
