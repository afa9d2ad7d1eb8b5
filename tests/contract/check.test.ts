/** What the core and the page say of bad input, together. */
import { beforeAll, describe, expect, test } from "vitest";
import { History } from "../../web/src/engine/core.ts";
import { BoughError, check, grow, type Issue, init, type ParamsInput } from "../../web/src/package/node.ts";
import { groupAndField, type Parameter, parameters, version } from "../../web/src/params/declaration.ts";
import { defaults, flatten } from "../../web/src/params/params.ts";
import { wanted } from "../../web/src/params/wording.ts";
import { fingerprint } from "../fingerprint.ts";

beforeAll(() => init());

/** Params with one value, of any type. */
function having(path: string, value: unknown): ParamsInput {
  const [group, field] = groupAndField(path);
  return { [group]: { [field]: value } };
}

function issuesOf(params: unknown): readonly Issue[] {
  try {
    grow(params as ParamsInput);
    return [];
  } catch (error) {
    if (error instanceof BoughError) return error.issues;
    throw error;
  }
}

test("the defaults that are declared are the core's own", () => {
  const own = new History(new Float64Array(0));
  const declared = new History(flatten(defaults));
  for (const history of [own, declared]) history.seek(history.steps, Number.POSITIVE_INFINITY);
  expect(own.shape()).toEqual(declared.shape());
  expect(check({})).toEqual([]);
  expect(check(defaults)).toEqual([]);
  expect(version).toMatch(/^\d+\.\d+\.\d+/);
});

test.each(parameters)("the page words $path as the core does", (parameter) => {
  const nothing = parameter.kind === "vector" ? [Number.NaN, 0, 0] : Number.NaN;
  const [found] = check(having(parameter.path, nothing));
  expect(found?.message).toMatch(`${parameter.path} must be ${wanted(parameter)}; it is `);
  const [misshapen] = check(having(parameter.path, []));
  expect(misshapen?.message).toBe(`${parameter.path} must be ${wanted(parameter)}; it is a list of 0.`);
});

describe("every code", () => {
  test.each<[Issue["code"], string, unknown, string]>([
    [
      "wrongType",
      "axis.radius",
      "5 mm",
      'axis.radius must be a number from 1e-7 to 100 m; it is the text "5 mm".',
    ],
    ["unknownKey", "axis.color", 1, "axis.color is not a parameter; axis may hold segments,"],
    ["notAnOption", "growth.thickening", "bark", 'it is the text "bark".'],
    [
      "notFinite",
      "loads.gravity",
      Number.NaN,
      "loads.gravity must be a number from 0 to 1e6 m/s2; it is NaN.",
    ],
    ["outOfRange", "loads.gravity", -1, "loads.gravity must be a number from 0 to 1e6 m/s2; it is -1."],
    ["notInteger", "axis.segments", 2.5, "axis.segments must be a whole number from 1 to 100000; it is 2.5."],
  ])("%s", (code, path, value, sentence) => {
    const issues = check(having(path, value));
    expect(issues).toMatchObject([{ code, path, value, message: expect.stringContaining(sentence) }]);
    expect(issuesOf(having(path, value))).toEqual(issues);
  });

  test("unsupported: the paper's relaxation is planar", () => {
    const [issue] = check({ loads: { tipForce: [0, 0, 1] }, solver: { method: "euler" } });
    expect(issue).toMatchObject({ code: "unsupported", path: "solver.method", value: "euler" });
    expect(check({ loads: { tipForce: [0, 0, 1] } })).toEqual([]);
  });

  test("a number that may be left open is a number or null", () => {
    expect(check({ tropism: { azimuth: null } })).toEqual([]);
    expect(check({ tropism: { azimuth: 90 } })).toEqual([]);
    for (const value of [Number.NaN, Number.POSITIVE_INFINITY, 1e6, "north"]) {
      expect(check(having("tropism.azimuth", value))).toMatchObject([{ path: "tropism.azimuth", value }]);
    }
  });

  test("tooLarge: the sentence says what would fit", () => {
    const [issue] = check({ axis: { segments: 100_000 }, growth: { thickening: "pipes" } });
    expect(issue).toMatchObject({ code: "tooLarge", path: "axis.segments", value: 100_000 });
    const most = issue?.max ?? 0;
    expect(issue?.message).toContain(String(most));
    expect(check({ axis: { segments: most }, growth: { thickening: "pipes" } })).toEqual([]);
  });

  test("unreadable", () => {
    const throwing = Object.defineProperty({}, "axis", {
      enumerable: true,
      get: () => {
        throw new Error("no");
      },
    });
    expect(check(throwing)).toMatchObject([{ code: "unreadable", path: "axis" }]);
  });
});

describe("a bad number", () => {
  const numeric = parameters.filter(({ kind }) => kind === "number" || kind === "integer");

  test.each(numeric)("$path, outside its range or not finite", (parameter) => {
    for (const value of badNumbers(parameter)) {
      const [issue, ...others] = issuesOf(having(parameter.path, value));
      const { path, min, max } = parameter;
      expect(issue).toMatchObject({
        path,
        value,
        min,
        max,
        message: expect.stringContaining(wanted(parameter)),
      });
      expect(others).toEqual([]);
    }
  });

  test("in a vector is told with the whole vector", () => {
    const vector = [0, Number.NEGATIVE_INFINITY, Number.NaN];
    expect(check(having("loads.tipForce", vector))).toMatchObject([
      { code: "notFinite", value: vector, message: expect.stringMatching(/it is -?inf/i) },
      { code: "notFinite", value: vector, message: expect.stringMatching(/it is NaN\.$/) },
    ]);
  });
});

function badNumbers({ min, max }: Parameter): number[] {
  const outside = [0, -1, 1e9, 1e308, -1e308, Number.MIN_VALUE].filter((value) => value < min || value > max);
  return [...outside, Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
}

test("all problems at once, in declared order, whoever found them", () => {
  const issues = issuesOf({
    leaves: 12,
    solver: { tolerance: 0, method: "guess" },
    loads: { gravity: Number.POSITIVE_INFINITY, removed: "yes", tipForce: [0, 0, 1] },
    axis: { segments: 1e9, radius: 1e308, segmentLength: null, colour: "green" },
  });
  expect(issues.map(({ code, path }) => `${code} ${path}`)).toEqual([
    "outOfRange axis.segments",
    "wrongType axis.segmentLength",
    "outOfRange axis.radius",
    "notFinite loads.gravity",
    "wrongType loads.removed",
    "notAnOption solver.method",
    "outOfRange solver.tolerance",
    "unknownKey leaves",
    "unknownKey axis.colour",
  ]);
});

test("combinations are judged only when every value is one", () => {
  expect(check({ loads: { tipForce: [0, 0, 1] }, axis: { radius: "thick" } })).toMatchObject([
    { code: "wrongType", path: "axis.radius" },
  ]);
});

test("after a hundred calls that fail a good one works", () => {
  const before = fingerprint(grow({}));
  const bad = [
    null,
    "axis",
    { axis: 1 },
    { axis: { segments: Number.NaN } },
    { material: { shearModulusRatio: 0 } },
  ];
  for (let call = 0; call < 100; call++) expect(issuesOf(bad[call % bad.length])).not.toEqual([]);
  expect(fingerprint(grow({}))).toBe(before);
});
