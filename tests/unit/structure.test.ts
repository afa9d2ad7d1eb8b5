import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parameters } from "../../web/src/params/declaration.ts";
import { nearest } from "../../web/src/params/nearest.ts";
import { complete, defaults } from "../../web/src/params/params.ts";
import { structure } from "../../web/src/params/structure.ts";

const issuesOf = (input: unknown) => structure(input).issues;
const paths = parameters.map(({ path }) => path);

test("nothing given, nothing wrong: all defaults", () => {
  expect(structure({})).toEqual({ params: defaults, issues: [] });
  expect(structure({ axis: undefined, loads: { gravity: undefined } })).toEqual(structure({}));
  expect(structure(Object.create(null))).toEqual(structure({}));
});

test("what is given is taken, the rest is default", () => {
  const given = { axis: { segments: 3 }, loads: { tipForce: [1, 2, 0] as [number, number, number] } };
  expect(structure(given)).toEqual({ params: complete(given), issues: [] });
});

test("numbers of any size, NaN and Infinity too, are left to the core; negative zero is zero", () => {
  const { params, issues } = structure({
    axis: { radius: Number.NaN, elevation: -0 },
    loads: { gravity: Number.POSITIVE_INFINITY, tipForce: [-0, 1e308, 0] },
  });
  expect(issues).toEqual([]);
  expect(params.axis).toMatchObject({ radius: Number.NaN, elevation: 0 });
  expect(params.loads).toMatchObject({ gravity: Number.POSITIVE_INFINITY, tipForce: [0, 1e308, 0] });
});

describe("params that are no object", () => {
  test.each([null, undefined, 5, "axis", true, [], [{}], () => 1, Symbol("s"), 5n, new Map(), new Date(0)])(
    "%o",
    (given) => {
      const { params, issues } = structure(given);
      expect(issues).toMatchObject([{ code: "wrongType", path: "", value: given }]);
      expect(issues[0]?.message).toMatch(/^params must be an object with named values; it is .+\.$/);
      expect(params).toEqual(defaults);
    },
  );
});

test.each([
  [{ axis: 5 }, "wrongType", "axis", "axis must be an object with named values; it is 5."],
  [{ axis: null }, "wrongType", "axis", "axis must be an object with named values; it is null."],
  [
    { axis: { segments: "40" } },
    "wrongType",
    "axis.segments",
    'axis.segments must be a whole number from 1 to 100000; it is the text "40".',
  ],
  [
    { axis: { radius: null } },
    "wrongType",
    "axis.radius",
    "axis.radius must be a number from 1e-7 to 100 m; it is null.",
  ],
  [{ loads: { removed: 1 } }, "wrongType", "loads.removed", "loads.removed must be true or false; it is 1."],
  [
    { solver: { method: "guess" } },
    "notAnOption",
    "solver.method",
    'solver.method must be one of newton, euler; it is the text "guess".',
  ],
  [
    { solver: { method: 0 } },
    "wrongType",
    "solver.method",
    "solver.method must be one of newton, euler; it is 0.",
  ],
  [
    { loads: { tipForce: [1, 2] } },
    "wrongType",
    "loads.tipForce",
    "loads.tipForce must be three numbers, each from -1e12 to 1e12 N; it is a list of 2.",
  ],
  [{ loads: { tipForce: [1, "2", 3] } }, "wrongType", "loads.tipForce", "it is a list of 3."],
  [{ loads: { tipForce: { x: 1 } } }, "wrongType", "loads.tipForce", "it is an object."],
  [
    { axis: { segmnts: 3 } },
    "unknownKey",
    "axis.segmnts",
    "axis.segmnts is not a parameter; did you mean axis.segments?",
  ],
  [
    { axis: { gravity: 3 } },
    "unknownKey",
    "axis.gravity",
    "axis.gravity is not a parameter; did you mean loads.gravity?",
  ],
  [{ gravity: 3 }, "unknownKey", "gravity", "gravity is not a parameter; did you mean loads.gravity?"],
  [{ Axis: {} }, "unknownKey", "Axis", "Axis is not a parameter; did you mean axis?"],
  [
    { "axis.radius": 1 },
    "unknownKey",
    "axis.radius",
    "axis.radius must stand inside its group: {axis: {radius: …}}.",
  ],
  [{ qqqqqqqq: 3 }, "unknownKey", "qqqqqqqq", "qqqqqqqq is not a parameter; params may hold axis, material,"],
  [{ growth: { xyzzyxyzzy: 3 } }, "unknownKey", "growth.xyzzyxyzzy", "growth may hold thickening."],
  [JSON.parse('{"__proto__": {"axis": {}}}'), "unknownKey", "__proto__", "__proto__ is not a parameter"],
  [
    JSON.parse('{"axis": {"__proto__": 1}}'),
    "unknownKey",
    "axis.__proto__",
    "axis.__proto__ is not a parameter",
  ],
  [{ constructor: 1 }, "unknownKey", "constructor", "constructor is not a parameter"],
  [{ axis: { toString: 1 } }, "unknownKey", "axis.toString", "axis.toString is not a parameter"],
])("%o", (given, code, path, sentence) => {
  expect(issuesOf(given)).toMatchObject([{ code, path, message: expect.stringContaining(sentence) }]);
});

test("every problem at once: parameters in declared order, then unknown keys, each with its value and range", () => {
  const wrong = Object.fromEntries(paths.map((path) => [path, Symbol(path)]));
  const given: Record<string, Record<string, unknown>> = { extra: {} };
  for (const path of paths.toReversed()) {
    const [group = "", field = ""] = path.split(".");
    given[group] ??= {};
    given[group][field] = wrong[path];
  }
  const issues = issuesOf(given);
  expect(issues.map(({ path }) => path)).toEqual([...paths, "extra"]);
  for (const { kind, path, min, max } of parameters) {
    const issue = issues.find((candidate) => candidate.path === path);
    expect(issue?.value).toBe(wrong[path]);
    expect(issue?.message).toContain(path);
    if (kind !== "choice" && kind !== "flag") expect(issue).toMatchObject({ min, max });
  }
});

describe("hostile values", () => {
  const cyclic: Record<string, unknown> = {};
  cyclic.axis = cyclic;
  const throwing = {
    get axis(): never {
      throw new Error("no axis for you");
    },
  };
  const revoked = Proxy.revocable({}, {});
  revoked.revoke();
  const refusing = new Proxy({}, { ownKeys: () => [][0] as never });

  test("a cycle is a wrong value, not a fall", () => {
    expect(issuesOf(cyclic)).toMatchObject([{ code: "unknownKey", path: "axis.axis" }]);
    expect(issuesOf({ axis: { segments: cyclic } })).toMatchObject([
      { code: "wrongType", path: "axis.segments" },
    ]);
  });

  test("a getter that throws is said to be unreadable", () => {
    expect(issuesOf(throwing)).toMatchObject([
      { code: "unreadable", path: "axis", message: "axis cannot be read: no axis for you." },
    ]);
  });

  test("a revoked or lying proxy is, too", () => {
    expect(issuesOf(revoked.proxy)).toMatchObject([{ code: "unreadable", path: "" }]);
    expect(issuesOf({ axis: { radius: revoked.proxy } })).toMatchObject([
      { code: "wrongType", path: "axis.radius" },
    ]);
    expect(issuesOf({ loads: { tipForce: revoked.proxy } })).toMatchObject([{ code: "wrongType" }]);
    expect(issuesOf(refusing)).toMatchObject([{ code: "unreadable", path: "" }]);
  });

  test("a million unknown keys, or one of a million letters, are told in few words", () => {
    const many = Object.fromEntries(Array.from({ length: 1_000_000 }, (_, index) => [`key${index}`, index]));
    const issues = issuesOf(many);
    expect(issues).toHaveLength(51);
    expect(issues.at(-1)?.message).toBe("999950 more keys are unknown.");
    const [long] = issuesOf({ axis: { ["x".repeat(1_000_000)]: 1, radius: "y".repeat(1_000_000) } });
    expect(long?.message.length).toBeLessThan(200);
  });

  test("nothing that JavaScript can make throws, or leaves params incomplete", () => {
    const groups = [...new Set(paths.map((path) => path.split(".")[0] ?? ""))];
    const fields = paths.map((path) => path.split(".")[1] ?? "");
    const anything = fc.anything({
      withBigInt: true,
      withDate: true,
      withMap: true,
      withSparseArray: true,
      withTypedArray: true,
      withNullPrototype: true,
    });
    const group = fc.oneof(anything, fc.dictionary(fc.constantFrom(...fields), anything));
    const params = fc.oneof(anything, fc.dictionary(fc.constantFrom(...groups), group));
    fc.assert(
      fc.property(params, (given) => {
        const { params, issues } = structure(given);
        expect(structure(params)).toEqual({ params, issues: [] });
        expect(issues.filter(({ message }) => !message.endsWith(".") && !message.endsWith("?"))).toEqual([]);
      }),
      { numRuns: 2000, seed: 8 },
    );
  });
});

test("the nearest name has the fewest typing errors, and is near", () => {
  expect(nearest("Elevatoin", ["elevation", "radius"])).toBe("elevation");
  expect(nearest("length", ["segmentLength", "lengthRatio"])).toBeUndefined();
  expect(nearest("", ["ab"])).toBeUndefined();
});
