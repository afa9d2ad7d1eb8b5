import { describe, expect, test } from "vitest";
import { help } from "../../web/generated/help.ts";
import { declaredParameters, groupAndField } from "../../web/src/params/declaration.ts";
import { schema } from "../../web/src/params/schema.ts";

interface Groups {
  [group: string]: { properties: Record<string, object>; additionalProperties: boolean };
}

const groups = schema.properties as Groups;

test("has every parameter, and allows nothing else", () => {
  const paths = Object.entries(groups).flatMap(([group, { properties }]) =>
    Object.keys(properties).map((field) => `${group}.${field}`),
  );
  expect(paths.toSorted()).toEqual(declaredParameters.map(({ path }) => path).toSorted());
  for (const { additionalProperties } of [schema as unknown as Groups[string], ...Object.values(groups)]) {
    expect(additionalProperties).toBe(false);
  }
});

test.each(declaredParameters)("$path has its default, its range, and words", (parameter) => {
  const [group, field] = groupAndField(parameter.path);
  const found = groups[group]?.properties[field];
  expect(found).toMatchObject({
    default: parameter.default,
    title: parameter.label,
    description: expect.stringContaining(help[parameter.path]?.[0] ?? "no help"),
  });
  if (parameter.unit) expect(found).toMatchObject({ description: expect.stringMatching(/Unit: .+\.$/) });
});

describe("a parameter that is", () => {
  test.each([
    ["a number", "loads.gravity", { type: "number", minimum: 0, maximum: 1e6 }],
    ["a whole number", "axis.segments", { type: "integer", minimum: 1, maximum: 1e5 }],
    ["a choice", "growth.thickening", { enum: ["none", "pipes"] }],
    ["a flag", "loads.removed", { type: "boolean" }],
    ["a vector", "loads.tipForce", { type: "array", minItems: 3, maxItems: 3 }],
  ])("%s", (_, path, expected) => {
    const [group, field] = groupAndField(path);
    expect(groups[group]?.properties[field]).toMatchObject(expected);
  });
});
