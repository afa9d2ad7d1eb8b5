/** Values and ranges as a person would write them, in the words of the core. */
import type { Parameter } from "./declaration.ts";

/** A number, plain where it is short, scientific where it is not. */
export function shown(number: number): string {
  const size = Math.abs(number);
  const plain = number === 0 || (size >= 1e-3 && size < 1e6) || !Number.isFinite(number);
  return plain ? String(number) : number.toExponential().replace("e+", "e");
}

/** What a parameter takes: "a number from 0 to 1e6 m/s2". */
export function wanted({ kind, min, max, unit, options = [] }: Omit<Parameter, "default">): string {
  const range = `from ${shown(min)} to ${shown(max)}${unit && ` ${unit}`}`;
  switch (kind) {
    case "number":
      return `a number ${range}`;
    case "optional":
      return `a number ${range}, or null`;
    case "integer":
      return `a whole number ${range}`;
    case "vector":
      return `three numbers, each ${range}`;
    case "forces":
      return "a list of {segment, force: [x, y, z]}";
    case "choice":
      return `one of ${options.join(", ")}`;
    case "flag":
      return "true or false";
  }
}

/** Any value at all, in a few words. Never throws. */
export function described(value: unknown): string {
  switch (typeof value) {
    case "string":
      return `the text "${shortened(value)}"`;
    case "number":
      return shown(value);
    case "object":
      if (value === null) return "null";
      return describedObject(value);
    case "function":
    case "symbol":
      return `a ${typeof value}`;
    case "bigint":
      return "a BigInt";
    default:
      return String(value);
  }
}

/** The beginning of a long text. */
export function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}

function describedObject(value: object): string {
  try {
    return Array.isArray(value) ? `a list of ${value.length}` : "an object";
  } catch {
    // Asking a revoked proxy throws.
    return "an object";
  }
}
