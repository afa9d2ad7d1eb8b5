/** Whatever JavaScript can make is a plant or one clear error, and leaves nothing behind. */
import fc from "fast-check";
import { afterEach, beforeAll, describe, expect, test } from "vitest";
import {
  BoughError,
  check,
  grow,
  history,
  init,
  type ParamsInput,
  presets,
  schema,
} from "../../web/src/package/node.ts";
import { parameters } from "../../web/src/params/declaration.ts";
import { fingerprint } from "../fingerprint.ts";

let plain = "";
beforeAll(async () => {
  await init();
  plain = fingerprint(grow({}));
});

afterEach(() => {
  // Nobody's objects have gained anything, and the next plant is what it was.
  expect(Object.keys(Object.prototype)).toEqual([]);
  expect(({} as Record<string, unknown>).polluted).toBeUndefined();
  expect(fingerprint(grow({}))).toBe(plain);
});

const groups = [...new Set(parameters.map(({ path }) => path.split(".")[0] ?? ""))];
const fields = parameters.map(({ path }) => path.split(".")[1] ?? "");

/** Names that lead to prototypes, among those of params. */
const name = fc.oneof(
  fc.constantFrom(...groups, ...fields),
  fc.constantFrom("__proto__", "constructor", "prototype", "toString", "valueOf", "then", "toJSON", ""),
  fc.string(),
);
const number = fc.oneof(
  fc.double(),
  fc.constantFrom(0, -0, 1, 40, 1e5, 1e308, 5e-324, Number.NaN, Number.POSITIVE_INFINITY),
);
const leaf = fc.oneof(
  number,
  fc.string(),
  fc.boolean(),
  fc.constant(null),
  fc.constantFrom("pipes", "newton", "stem"),
);
/** As JSON.parse makes them: with a key of its own that is called __proto__. */
const json = fc.letrec((tie) => ({
  value: fc.oneof({ maxDepth: 4 }, leaf, tie("object"), fc.array(tie("value"), { maxLength: 4 })),
  object: fc
    .array(fc.tuple(name, tie("value")), { maxLength: 6 })
    .map((entries) => `{${entries.map(([key, value]) => `${JSON.stringify(key)}:${text(value)}`).join()}}`)
    .map((written) => JSON.parse(written) as unknown),
})).value;

function text(value: unknown): string {
  return JSON.stringify(value) ?? "null";
}

/** Grows for a moment at most; what it throws must be the one error, saying what `check` says. */
function growOrExplain(given: unknown): void {
  const issues = check(given);
  try {
    const { report, polylines } = grow(given as ParamsInput, { deadline: 5 });
    expect(issues).toEqual([]);
    expect(["converged", "budget", "maxIterations", "nonFinite"]).toContain(report.status);
    expect(polylines.points.every(Number.isFinite)).toBe(true);
  } catch (error) {
    if (!(error instanceof BoughError)) throw error;
    expect(error.issues.map(({ message }) => message)).toEqual(issues.map(({ message }) => message));
    expect(error.issues.length).toBeGreaterThan(0);
  }
}

describe("any JSON", () => {
  test("is grown, or explained", () => {
    const params = fc.oneof(
      json,
      fc.dictionary(fc.constantFrom(...groups), fc.dictionary(fc.constantFrom(...fields), leaf)),
    );
    fc.assert(fc.property(params, growOrExplain), { numRuns: 800, seed: 14 });
  });

  test("with every value in its range is grown", () => {
    const within = fc.record(
      Object.fromEntries(
        parameters
          .filter(({ kind }) => kind === "number")
          .map(({ path, min, max }) => [
            path,
            fc.option(fc.double({ min, max, noNaN: true }), { nil: undefined }),
          ]),
      ),
    );
    fc.assert(
      fc.property(within, fc.integer({ min: 1, max: 12 }), (values, segments) => {
        const given: Record<string, Record<string, unknown>> = { axis: { segments } };
        for (const [path, value] of Object.entries(values)) {
          const [group = "", field = ""] = path.split(".");
          given[group] = { ...given[group], ...(value === undefined ? {} : { [field]: value }) };
        }
        growOrExplain(given);
      }),
      { numRuns: 500, seed: 14 },
    );
  });
});

describe("prototypes", () => {
  test.each([
    '{"__proto__": {"polluted": true}}',
    '{"constructor": {"prototype": {"polluted": true}}}',
    '{"axis": {"__proto__": {"polluted": true, "segments": 3}}}',
    '{"axis": {"constructor": {"prototype": {"polluted": true}}}}',
    '{"loads": {"forces": [{"__proto__": {"segment": 1, "force": [1, 1, 0]}}]}}',
  ])("%s pollutes nothing", (written) => {
    const given = JSON.parse(written);
    expect(check(given).length).toBeGreaterThan(0);
    expect(() => grow(given)).toThrow(BoughError);
  });

  test("inherited values do not count", () => {
    expect(fingerprint(grow(Object.create({ axis: { segments: 3 } })))).toBe(plain);
  });

  test("a polluted page does not bend the plant", () => {
    const prototype = Object.prototype as Record<string, unknown>;
    try {
      for (const key of ["segments", "min", "max", "axis", "gravity"]) prototype[key] = 3;
      const plant = grow({ axis: { elevation: 50 } });
      expect(fingerprint(plant)).toBe(plain);
    } finally {
      for (const key of ["segments", "min", "max", "axis", "gravity"]) delete prototype[key];
    }
  });
});

describe("objects that work against their reader", () => {
  test("each value is read once: what was checked is what grows", () => {
    let reads = 0;
    const given = {
      axis: {
        get segments() {
          reads++;
          return reads === 1 ? 3 : 1e9;
        },
      },
    };
    expect(grow(given).segments.length).toHaveLength(3);
    expect(reads).toBe(1);
    const forces = [{ segment: 1, force: [0, 1, 0] as [number, number, number] }];
    let asked = 0;
    Object.defineProperty(forces[0], "segment", {
      get: () => (asked++ === 0 ? 1 : Number.NaN),
      enumerable: true,
    });
    expect(grow({ loads: { forces } }).report.status).toBe("converged");
  });

  test("a getter that calls Bough while Bough reads it", () => {
    const given = {
      get axis() {
        grow({ axis: { segments: 5 } });
        check({ axis: 7 });
        return { segments: history({ axis: { segments: 4 } }).steps };
      },
    };
    expect(fingerprint(grow(given))).toBe(fingerprint(grow({ axis: { segments: 4 } })));
  });

  test("a getter that throws, a cycle, a revoked proxy", () => {
    const cyclic: Record<string, unknown> = {};
    cyclic.axis = { segments: cyclic };
    const { proxy, revoke } = Proxy.revocable({}, {});
    revoke();
    const throwing = {
      get loads(): never {
        throw { toString: () => "not even an error" };
      },
    };
    for (const given of [cyclic, proxy, throwing, { loads: proxy }, { loads: { tipForce: proxy } }]) {
      expect(() => grow(given as ParamsInput)).toThrow(BoughError);
    }
  });

  test("texts of 64 million signs, as keys and as values", () => {
    const huge = "9".repeat(2 ** 26);
    for (const given of [huge, { [huge]: 1 }, { axis: { [huge]: 1 } }, { axis: { segments: huge } }]) {
      const start = performance.now();
      const issues = check(given);
      expect(issues).toHaveLength(1);
      expect(issues[0]?.message.length).toBeLessThan(300);
      expect(performance.now() - start).toBeLessThan(2000);
    }
  });

  test("lists with holes, of any length, of typed arrays", () => {
    for (const tipForce of [
      new Array(3),
      new Float64Array(3),
      { length: 3, 0: 1, 1: 1, 2: 0 },
      new Array(2 ** 32 - 1),
    ]) {
      expect(check({ loads: { tipForce } })).toMatchObject([{ code: "wrongType", path: "loads.tipForce" }]);
    }
    expect(check({ loads: { forces: new Array(2) } })).toMatchObject([{ path: "loads.forces" }]);
  });
});

describe("what was given away", () => {
  test("arrays of a plant may be detached, resized and overwritten: the next plant is its own", () => {
    const ages = history({});
    const first = ages.at(40);
    const arrays = [...Object.values(first.polylines), ...Object.values(first.segments)];
    for (const array of arrays.slice(0, 4)) structuredClone(array.buffer, { transfer: [array.buffer] });
    for (const array of arrays.slice(4)) array.fill(7);
    expect(arrays[0]).toHaveLength(0);
    expect(fingerprint(ages.at(40))).toBe(plain);
    expect(fingerprint(ages.at(40))).toBe(plain);
  });

  test("presets and defaults are nobody's to change, though they are parts of what plants give away", () => {
    expect(isDeeplyFrozen(presets)).toBe(true);
    const { params } = grow({});
    expect(() => {
      params.loads.tipForce[1] = 5;
    }).toThrow(TypeError);
    params.axis.segments = 3;
    (schema as Record<string, unknown>).properties = {};
    expect(check({ axis: { segments: 0 } })).toHaveLength(1);
  });
});

function isDeeplyFrozen(value: unknown): boolean {
  if (typeof value !== "object" || value === null) return true;
  return Object.isFrozen(value) && Object.values(value).every(isDeeplyFrozen);
}
