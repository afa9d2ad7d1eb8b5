import { describe, expect, it } from "vitest";
import { numberText, quantityText, read } from "../../web/src/form/quantity.ts";
import { travelOf } from "../../web/src/form/travel.ts";
import { nameOf } from "../../web/src/form/words.ts";
import { parameters } from "../../web/src/params/declaration.ts";

describe("a quantity for reading", () => {
  it.each([
    [1.1e9, "Pa", "1.1 GPa"],
    [3.5316e8, "Pa", "353 MPa"],
    [0.0375, "m", "3.75 cm"],
    [0.005, "m", "5 mm"],
    [0.01, "m", "1 cm"],
    [1500, "m", "1.5 km"],
    [-0.724, "m", "-72.4 cm"],
    [2e-6, "m", "2 µm"],
    [6.43e-7, "m", "0.643 µm"],
    [50, "deg", "50°"],
    [9.81, "m/s2", "9.81 m/s²"],
    [0.25, "kg", "250 g"],
    [1000, "kg/m3", "1000 kg/m³"],
    [1e6, "1/m", "1e6 m⁻¹"],
    [40, "", "40"],
    [0, "m", "0 m"],
    [0, "Pa", "0 Pa"],
    [1e-10, "", "1e−10"],
  ])("%d %s is %s", (value, unit, text) => {
    expect(quantityText(value, unit)).toBe(text);
  });

  it("has no more digits than are worth reading", () => {
    expect(numberText(1 / 3)).toBe("0.333");
    expect(numberText(123_456)).toBe("123000");
  });
});

describe("what a person types", () => {
  it.each([
    ["0.04", "m", 0.04],
    [" 40 mm ", "m", 0.04],
    ["4cm", "m", 0.04],
    ["5 um", "m", 5e-6],
    ["3,5", "m/s2", 3.5],
    ["9.81 m/s²", "m/s2", 9.81],
    ["9.81 m/s2", "m/s2", 9.81],
    ["1.1 GPa", "Pa", 1.1e9],
    ["1e9", "Pa", 1e9],
    ["−12", "deg", -12],
    ["45°", "deg", 45],
    ["250 g", "kg", 0.25],
    [".5", "", 0.5],
    ["1e999", "", Number.POSITIVE_INFINITY],
  ])("%s in %s is read as %d", (text, unit, value) => {
    const entered = read(text, unit);
    if (Number.isFinite(value)) expect(entered).toBeCloseTo(value, 12);
    else expect(entered).toBe(value);
  });

  it.each([
    ["abc", "m"],
    ["", "m"],
    ["NaN", ""],
    ["Infinity", ""],
    ["4 kg", "m"],
    ["4 mm", ""],
    ["1 2", "m"],
    ["0x10", ""],
    ["1,000,000", ""],
  ])("%s in %s is no number, and stays the text it is", (text, unit) => {
    expect(read(text, unit)).toBe(text);
  });
});

describe("the travel of a slider", () => {
  const sliders = parameters.filter(({ kind }) => kind === "number" || kind === "integer");

  it.each(sliders.map((parameter) => [parameter.path, parameter] as const))("of %s", (_, parameter) => {
    const { slider, kind } = parameter;
    const travel = travelOf(parameter);
    expect(travel.value(travel.min)).toBeCloseTo(slider.min, 12);
    expect(travel.value(travel.max) / slider.max).toBeCloseTo(1, 6);
    // There and back again stays within half a step.
    for (let share = 0; share <= 1; share += 0.01) {
      const position = travel.min + share * (travel.max - travel.min);
      const value = travel.value(position);
      expect(value).toBeGreaterThanOrEqual(slider.min);
      expect(value).toBeLessThanOrEqual(slider.max);
      if (kind !== "integer")
        expect(Math.abs(travel.position(value) - position)).toBeLessThanOrEqual(travel.step);
    }
    // Beyond the ends the slider stays at its end.
    expect(travel.position(slider.max * 1e6 + 1e6)).toBe(travel.max);
    expect(travel.position(slider.min - Math.abs(slider.min))).toBe(travel.min);
  });
});

describe("names", () => {
  it("are words for people", () => {
    expect(nameOf("secondOrder")).toBe("Second order");
    expect(nameOf("material")).toBe("Wood");
  });
});
