/** Numbers with units, as a person writes and reads them. */

import { local } from "../language/number.ts";

/** How units are written. */
const written: Readonly<Record<string, string>> = {
  deg: "°",
  "kg/m3": "kg/m³",
  "m/s2": "m/s²",
  "1/m": "m⁻¹",
};

/** Units that take a prefix where that reads better: 37.5 mm rather than 0.0375 m. */
const prefixes: Readonly<Record<string, readonly (readonly [prefix: string, factor: number])[]>> = {
  m: [
    ["k", 1e3],
    ["", 1],
    ["c", 1e-2],
    ["m", 1e-3],
    ["µ", 1e-6],
  ],
  Pa: [
    ["T", 1e12],
    ["G", 1e9],
    ["M", 1e6],
    ["k", 1e3],
    ["", 1],
  ],
  N: [
    ["k", 1e3],
    ["", 1],
    ["m", 1e-3],
    ["µ", 1e-6],
  ],
};

/** A unit as it is written: "m/s²". */
export function unitText(unit: string): string {
  return written[unit] ?? unit;
}

/** The digits that are worth reading: at most `digits`, without an exponent where that is short. */
export function numberText(value: number, digits = 3): string {
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  if (rounded === 0) return "0";
  if (size >= 1e-4 && size < 1e6) return local(String(rounded));
  return local(rounded.toExponential().replace("e+", "e").replace("-", "−"));
}

/** A quantity for reading: "1.1 GPa", "37.5 mm", "50°". */
export function quantityText(value: number, unit: string, digits = 3): string {
  if (unit === "kg" && Math.abs(value) < 1 && value !== 0) return `${numberText(1000 * value, digits)} g`;
  const choices = prefixes[unit] ?? [["", 1]];
  const size = Math.abs(value) * (1 + 1e-12);
  const fits = choices.find(([, factor]) => size >= factor) ?? choices.at(-1);
  const [prefix, factor] = value === 0 ? ["", 1] : (size > 0 && fits) || ["", 1];
  const number = numberText(value / factor, digits);
  if (unit === "deg") return `${number}°`;
  return unit === "" ? number : `${number} ${prefix}${unitText(unit)}`;
}

/**
 * Reads what a person typed: a plain number is in the SI unit; "40 mm" or "1,5 GPa" say their own. Anything that is no
 * number is given back as the text it was, for the check to word what is wrong.
 */
export function read(text: string, unit: string): number | string {
  const match = /^([+−-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+−-]?\d+)?)\s*(.*)$/i.exec(text.trim());
  if (!match) return text;
  const [, digits = "", suffix = ""] = match;
  const factor = factorOf(suffix.trim(), unit);
  return factor === undefined ? text : Number(digits.replaceAll("−", "-").replace(",", ".")) * factor + 0;
}

/** What a written unit is worth in the parameter's own, if it is one of its kind. */
function factorOf(suffix: string, unit: string): number | undefined {
  if (suffix === "" || suffix === unit || suffix === unitText(unit)) return 1;
  if (unit === "kg" && suffix === "g") return 1e-3;
  const plain = suffix.replace(/^[uμ]/, "µ");
  return prefixes[unit]?.find(([prefix]) => `${prefix}${unit}` === plain)?.[1];
}
