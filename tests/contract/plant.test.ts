/** What `grow` and `history` return: the shapes of contract and declaration, numbers of the paper's physics. */
import fc from "fast-check";
import { beforeAll, describe, expect, test } from "vitest";
import {
  check,
  grow,
  history,
  init,
  type Params,
  type Plant,
  presets,
  schema,
  version,
} from "../../web/src/package/node.ts";
import { defaults, stepsOf } from "../../web/src/params/params.ts";
import { fingerprint } from "../fingerprint.ts";
import { anyParams } from "../states.ts";

beforeAll(() => init());

/** The tip of the main axis. */
function tip({ polylines: { points, offsets } }: Plant): number[] {
  const end = 3 * (offsets[1] ?? 0);
  return [...points.subarray(end - 3, end)];
}

/** What the contract says of the arrays of any plant. */
function expectShapes({ polylines, segments }: Plant): void {
  const points = polylines.radii.length;
  const axes = polylines.offsets.length - 1;
  const count = segments.parent.length;
  expect(polylines.points).toBeInstanceOf(Float64Array);
  expect(polylines.points).toHaveLength(3 * points);
  expect(polylines.offsets).toBeInstanceOf(Uint32Array);
  expect([polylines.offsets[0], polylines.offsets[axes]]).toEqual([0, points]);
  expect(count).toBe(points - axes);
  const reals = { ...polylines, ...segments } as Record<string, unknown>;
  for (const name of [
    "radii",
    "length",
    "radius",
    "mass",
    "moment",
    "twistMoment",
    "curvature",
    "restCurvature",
    "stress",
  ])
    expect(reals[name]).toBeInstanceOf(Float64Array);
  for (const name of ["point", "axis", "order", "birth"]) expect(reals[name]).toBeInstanceOf(Uint32Array);
  expect(segments.parent).toBeInstanceOf(Int32Array);
  const { rotation, ...rest } = segments;
  expect(rotation).toHaveLength(4 * count);
  for (const array of Object.values(rest)) expect(array).toHaveLength(count);
  expect([...segments.parent].every((parent, segment) => parent >= -1 && parent < segment)).toBe(true);
}

describe("the default plant", () => {
  test("has the arrays that the contract promises", () => {
    const plant = grow({});
    expectShapes(plant);
    expect(plant.segments.parent).toHaveLength(40);
    expect([...plant.polylines.offsets]).toEqual([0, 41]);
    expect([...plant.segments.birth]).toEqual(Array.from({ length: 40 }, (_, segment) => segment + 1));
  });

  test("says how it was solved, and what made it", () => {
    const { report, params, version: made } = grow({ loads: { gravity: 3 } });
    expect(report).toEqual({
      status: "converged",
      stable: true,
      unstableSince: null,
      steppingError: null,
      selfBuckling: null,
      safetyFactor: expect.any(Number),
      breaksFirst: 0,
      residual: expect.any(Number),
      worstStepResidual: expect.any(Number),
      iterations: expect.any(Number),
      steps: 40,
      gravityNumber: expect.closeTo((4 * 1000 * 3 * 1.5 ** 3) / (1e9 * 0.005 ** 2), 9),
    });
    expect(report.residual).toBeLessThanOrEqual(1e-10);
    const stress = grow({ loads: { gravity: 3 } }).segments.stress[0] ?? 0;
    expect(report.safetyFactor).toBe(params.material.modulusOfRupture / stress);
    expect(params).toEqual({ ...defaults, loads: { ...defaults.loads, gravity: 3 } });
    expect(made).toBe(version);
  });

  test("is the caller's own: nothing in it refers to wasm memory", () => {
    const plant = grow({});
    const before = fingerprint(plant);
    for (let call = 0; call < 20; call++) grow({ axis: { segments: 200 } });
    expect(fingerprint(plant)).toBe(before);
    const buffers = [...Object.values(plant.polylines), ...Object.values(plant.segments)].map(
      ({ buffer }) => buffer,
    );
    expect(new Set(buffers).size).toBe(buffers.length);
    structuredClone(plant, { transfer: buffers });
  });
});

test("a heavy rod ends where the continuous elastica does: 45 degrees, q = 5", () => {
  const [gravity, density, radius, segments] = [9.81, 1000, 0.01, 320];
  // q = 4 rho g L^3 / (E r^2), with L = 1 m.
  const youngsModulus = (4 * density * gravity) / (5 * radius ** 2);
  const plant = grow({
    axis: { segments, segmentLength: 1 / segments, radius, elevation: 45 },
    material: { youngsModulus, density },
    loads: { gravity },
  });
  expect(plant.report.gravityNumber).toBeCloseTo(5, 9);
  // High-order collocation on the continuous rod: 0.958215138913, 0.170536858575.
  const [x = 0, y = 0, z] = tip(plant);
  expect(Math.hypot(x - 0.958215138913, y - 0.170536858575)).toBeLessThan(2e-5);
  expect(z).toBe(0);
});

test.each(Object.entries(presets))(
  "preset %s grows, converges, and keeps to the contract",
  (_, { params, step }) => {
    expect(check(params)).toEqual([]);
    const plant = history(params).at(step ?? Number.POSITIVE_INFINITY);
    expectShapes(plant);
    expect(plant.report).toMatchObject({ status: "converged" });
    expect([...plant.polylines.points].every(Number.isFinite)).toBe(true);
  },
);

test("the schema is one of the params that grow takes", () => {
  expect(schema).toMatchObject({
    $schema: "https://json-schema.org/draft/2020-12/schema",
    additionalProperties: false,
    properties: {
      axis: { properties: { segments: { type: "integer", minimum: 1, default: defaults.axis.segments } } },
    },
  });
});

describe("history", () => {
  const params = {
    axis: { segments: 30 },
    growth: { thickening: "pipes" },
    tropism: { strength: 5 },
  } as const;

  test("gives every age bit for bit alike, in whatever order it is asked for", () => {
    const forward = [...history(params)].map(fingerprint);
    expect(forward).toHaveLength(30);
    expect(new Set(forward).size).toBe(30);
    const jumping = history(params);
    for (let visit = 0; visit < 200; visit++) {
      const step = 1 + ((visit * 17) % 30);
      expect(fingerprint(jumping.at(step))).toBe(forward[step - 1]);
    }
    expect(fingerprint(grow(params))).toBe(forward[29]);
  });

  test("takes a step outside as the nearest inside, a fraction as the step below", () => {
    const ages = history(params);
    const steps = [-1, 0, 2.9, 31, 2 ** 32 + 3, Number.POSITIVE_INFINITY].map(
      (step) => ages.at(step).report.steps,
    );
    expect(steps).toEqual([1, 1, 2, 30, 30, 30]);
  });

  test.each([Number.NaN, "5", null, undefined])("a step of %o is an issue", (step) => {
    const sentence = /^step must be a number from 1 to 30; it is .+\.$/;
    expect(() => history(params).at(step as number)).toThrow(sentence);
  });

  test("of bad params lists what is wrong at once", () => {
    expect(() => history({ axis: { segments: 0 } })).toThrow("axis.segments must be a whole number");
  });

  test("that was disposed of says so, and may be disposed of twice", () => {
    const ages = history(params);
    ages.dispose();
    ages.dispose();
    expect(() => ages.at(1)).toThrow("This history was disposed of.");
  });

  test("takes as many steps as were foretold", () => {
    fc.assert(
      fc.property(anyParams(defaults), (given: Params) => {
        fc.pre(check(given).length === 0);
        const ages = history(given);
        expect(ages.steps).toBe(stepsOf(given));
        ages.dispose();
      }),
      { numRuns: 500, seed: 8 },
    );
  });
});
