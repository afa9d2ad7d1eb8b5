import { expect, test } from "vitest";
import { flatLength, parameters } from "../../web/src/params/declaration.ts";
import {
  complete,
  defaults,
  flatten,
  sameParams,
  stepsOf,
  valueAt,
  withValue,
} from "../../web/src/params/params.ts";

test("every path of the declaration leads to its default", () => {
  for (const { path, default: declared } of parameters) expect(valueAt(defaults, path)).toEqual(declared);
});

test("a change makes new params and leaves the old ones, and what did not change, as they were", () => {
  const changed = withValue(defaults, "loads.gravity", 3);
  expect(changed.loads.gravity).toBe(3);
  expect(defaults.loads.gravity).not.toBe(3);
  expect(changed.axis).toBe(defaults.axis);
  expect(sameParams(changed, defaults)).toBe(false);
});

test("a change to the same value is no change", () => {
  expect(withValue(defaults, "loads.tipForce", [0, 0, 0])).toBe(defaults);
});

test("a path that does not exist is a programming error", () => {
  expect(() => valueAt(defaults, "loads.levity")).toThrow("There is no parameter loads.levity.");
  expect(() => withValue(defaults, "levity", 1)).toThrow(TypeError);
});

test("the flat form holds every value at its offset: choices by index, flags as 0 and 1", () => {
  const params = complete({
    axis: { segments: 7 },
    growth: { thickening: "pipes" },
    loads: { tipForce: [1, 2, 0], removed: true },
  });
  const flat = flatten(params);
  const at = (path: string) => {
    const { offset, width } = parameters.find((parameter) => parameter.path === path) ?? {
      offset: -1,
      width: 0,
    };
    return [...flat.subarray(offset, offset + width)];
  };
  expect(flat).toHaveLength(flatLength);
  expect(at("axis.segments")).toEqual([7]);
  expect(at("growth.thickening")).toEqual([1]);
  expect(at("loads.tipForce")).toEqual([1, 2, 0]);
  expect(at("loads.removed")).toEqual([1]);
  expect(at("solver.tolerance")).toEqual([1e-10]);
});

test("growth takes the segments of every generation", () => {
  const axis = { segments: 12 };
  expect(stepsOf(complete({ axis, branching: { generations: 5 } }))).toBe(12);
  const branching = { pattern: "bifurcation", generations: 5, lengthRatio: 0.5 } as const;
  expect(stepsOf(complete({ axis, branching }))).toBe(12 + 6 + 3 + 2 + 1 + 1);
});
