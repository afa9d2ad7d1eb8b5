import { describe, expect, it } from "vitest";
import { digits, forceText, quantity, scaleFor } from "../../web/src/geometry/quantity.ts";

describe("a quantity", () => {
  it.each([
    [0.0123, "N m", "12 mN m"],
    [1_100_000_000, "Pa", "1.1 GPa"],
    [2.5e6, "Pa", "2.5 MPa"],
    [999.9, "N", "1000 N"],
    [-33, "N", "−33 N"],
    [0.001, "N", "1 mN"],
    [3e-13, "N", "0.0003 nN"],
    [0, "N", "0 N"],
    [0.042, "1/m", "0.042 1/m"],
    [12, "steps", "12 steps"],
  ])("%s %s is %s", (value, unit, text) => {
    expect(quantity(value, unit)).toBe(text);
  });

  it("has two digits and no powers of ten", () => {
    expect(digits(0.3217)).toBe("0.32");
    expect(digits(-1234)).toBe("−1200");
    expect(digits(1e-7)).toBe("0.0000001");
  });

  it("has one scale for a whole axis", () => {
    expect(scaleFor(4e-3, "N m")).toEqual({ unit: "mN m", size: 1e-3 });
    expect(scaleFor(4, "1/m")).toEqual({ unit: "1/m", size: 1 });
  });
});

describe("a force", () => {
  it.each([
    [0.32, "0.32 N · 33 gf"],
    [0.0032, "3.2 mN · 330 mgf"],
    [98.0665, "98 N · 10 kgf"],
  ])("of %s N is %s", (newtons, text) => {
    expect(forceText(newtons)).toBe(text);
  });
});
