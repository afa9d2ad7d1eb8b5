import { describe, expect, it } from "vitest";
import { legend, paintOf } from "../../web/src/geometry/legend.ts";
import { type Measured, rangeOf, shadesOf } from "../../web/src/geometry/shade.ts";
import type { Axes } from "../../web/src/geometry/tube.ts";
import { handMade } from "./plants.ts";

/** Four segments with values of their own. */
function plant(values: Partial<Record<"moment" | "stress" | "curvature", number[]>>): Axes {
  const made = handMade({
    points: Array.from({ length: 5 }, (_, k) => [k, 0, 0]),
    radii: [0.1, 0.1, 0.1, 0.1, 0.1],
  });
  const arrays = Object.fromEntries(Object.entries(values).map(([k, v]) => [k, Float64Array.from(v)]));
  return { ...made, segments: { ...made.segments, ...arrays } };
}

const bent = plant({
  moment: [-0.042, -0.02, 0.01, 0],
  stress: [3.2e6, 2e6, 1e6, 0],
  curvature: [-2, -1, 0.5, 0],
});

describe("the legend", () => {
  it("is none for the plant's own bark", () => {
    expect(legend(bent, "bark")).toBeNull();
    expect(paintOf(bent, "bark")).toBeNull();
  });

  it("of a signed value has zero in its middle, and real units", () => {
    const { title, unit, min, max, ticks } = legend(bent, "moment") ?? {};
    expect({ title, unit, min, max }).toEqual({
      title: "Bending moment",
      unit: "mN m",
      min: -0.042,
      max: 0.042,
    });
    expect(ticks?.map(({ text }) => text)).toEqual(["−40", "−20", "0", "20", "40"]);
    expect(ticks?.[2]?.offset).toBeCloseTo(0.5, 12);
  });

  it.each([
    ["stress", "MPa", ["0", "1", "2", "3"]],
    ["curvature", "1/m", ["−2", "−1", "0", "1", "2"]],
    ["age", "steps", ["0", "1", "2", "3"]],
  ] as const)("of %s counts in %s", (color, unit, texts) => {
    const key = legend(bent, color);
    expect(key?.unit).toBe(unit);
    expect(key?.ticks.map(({ text }) => text)).toEqual(texts);
  });

  it("reaches over the plant and the grown one", () => {
    const grown = plant({ stress: [8e6, 0, 0, 0] });
    expect(legend(bent, "stress", grown)?.max).toBe(8e6);
    expect(legend(grown, "stress", bent)?.max).toBe(8e6);
  });

  it.each(["moment", "stress", "curvature"] as const)(
    "of a plant without %s is whole all the same",
    (color) => {
      const key = legend(plant({}), color);
      expect(key?.max).toBe(1);
      expect(key?.ticks.length).toBeGreaterThanOrEqual(3);
    },
  );

  it.each([1e-9, 0.07, 0.95, 1, 1.5, 3, 9.99, 123, 6e7])(
    "of values up to %s has 3 to 7 round ticks inside",
    (most) => {
      for (const color of ["stress", "moment"] as const) {
        const key = legend(plant({ [color]: [most, 0, 0, 0] }), color);
        expect(key?.ticks.length).toBeGreaterThanOrEqual(3);
        expect(key?.ticks.length).toBeLessThanOrEqual(7);
        for (const { offset } of key?.ticks ?? []) {
          expect(offset).toBeGreaterThanOrEqual(-1e-9);
          expect(offset).toBeLessThanOrEqual(1 + 1e-9);
        }
      }
    },
  );
});

describe("colours", () => {
  /** Lightness in CIELAB, 0 to 100. */
  function lightness(css: string): number {
    const [r = 0, g = 0, b = 0] = [1, 3, 5].map((at) => {
      const value = Number.parseInt(css.slice(at, at + 2), 16) / 255;
      return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
    });
    const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return 116 * Math.cbrt(y) - 16;
  }

  it.each(["stress", "age"] as const)(
    "of %s get lighter in even steps: they can be told apart without hue",
    (color) => {
      const steps = (legend(bent, color)?.stops ?? []).map(({ css }) => lightness(css));
      const rises = steps.slice(1).map((value, i) => value - (steps[i] ?? 0));
      for (const rise of rises) {
        expect(rise).toBeGreaterThan(6);
        expect(rise).toBeLessThan(14);
      }
    },
  );

  it.each(["moment", "curvature"] as const)(
    "of %s are lightest at zero, and equally light to both sides",
    (color) => {
      const steps = (legend(bent, color)?.stops ?? []).map(({ css }) => lightness(css));
      for (let i = 0; i < 4; i++) {
        expect(steps[i + 1]).toBeGreaterThan(steps[i] ?? 100);
        expect(Math.abs((steps[i] ?? 0) - (steps[8 - i] ?? 0))).toBeLessThan(4);
      }
    },
  );
});

describe("shades", () => {
  const shades = (color: Measured) => shadesOf(color, bent, rangeOf(color, [bent]));

  it("are places in the range", () => {
    expect([...shades("moment").values]).toEqual(
      [0, 11 / 42, 26 / 42, 0.5].map((v) => expect.closeTo(v, 12)),
    );
    expect([...shades("stress").values]).toEqual([1, 0.625, 0.3125, 0].map((v) => expect.closeTo(v, 12)));
    expect([...shades("age").values]).toEqual([1, 2 / 3, 1 / 3, 0].map((v) => expect.closeTo(v, 12)));
  });

  it("at a free tip are those of no load, where the value is a load", () => {
    expect(shades("moment").free).toBe(0.5);
    expect(shades("stress").free).toBe(0);
    expect(shades("curvature").free).toBeNull();
    expect(shades("age").free).toBeNull();
  });

  it("are numbers between 0 and 1 even of values that are not", () => {
    const broken = plant({ stress: [Number.NaN, Number.POSITIVE_INFINITY, -1, 2] });
    expect(rangeOf("stress", [broken]).max).toBe(2);
    for (const value of shadesOf("stress", broken, { min: 0, max: 2 }).values) {
      expect(value).toBeGreaterThanOrEqual(0);
      expect(value).toBeLessThanOrEqual(1);
    }
  });
});
