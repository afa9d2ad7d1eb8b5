/** Values as text in a link, and back. */
import type { Parameter, Value } from "./declaration.ts";

/** A value read from text; without a value it is unreadable, with a code it is not what the text said. */
export interface Parsed<T> {
  value?: T;
  code?: "unreadable" | "outOfRange" | "notInteger";
}

/** The text of a number that is left open. */
const NONE = "none";

/** Reads the value of a parameter. */
export function parsed({ kind, options = [], min, max }: Parameter, text: string): Parsed<Value> {
  switch (kind) {
    case "number":
    case "integer":
      return numberIn(text, min, max, kind === "integer");
    case "optional":
      return text === NONE ? { value: null } : numberIn(text, min, max, false);
    case "choice":
      return options.includes(text) ? { value: text } : { code: "unreadable" };
    case "flag":
      return text === "1" || text === "0" ? { value: text === "1" } : { code: "unreadable" };
    case "vector":
      return vectorIn(text, min, max);
    case "forces":
      return { code: "unreadable" };
  }
}

function vectorIn(text: string, min: number, max: number): Parsed<Value> {
  const [x, y, z, ...more] = text.split(",", 4).map((part) => numberIn(part, min, max, false));
  if (x?.value === undefined || y?.value === undefined || z?.value === undefined || more.length > 0) {
    return { code: "unreadable" };
  }
  const code = x.code ?? y.code ?? z.code;
  return { value: [x.value, y.value, z.value], ...(code && { code }) };
}

/** A number, moved into its range and made whole where it must be. */
export function numberIn(text: string, min: number, max: number, whole: boolean): Parsed<number> {
  // A plus sign that was not percent-encoded arrives as a space.
  const plain = text.trim().replace("e ", "e+");
  if (!/^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return { code: "unreadable" };
  const number = Number(plain) + 0;
  const clamped = Math.min(Math.max(number, min), max);
  const value = whole ? Math.round(clamped) : clamped;
  if (value === number) return { value };
  return { value, code: clamped === number ? "notInteger" : "outOfRange" };
}

/** A value as text without loss: numbers at their shortest, choices by name. */
export function written(value: Value): string {
  if (Array.isArray(value)) return value.map(written).join(",");
  if (value === null) return NONE;
  if (typeof value === "boolean") return value ? "1" : "0";
  return String(value).replace("e+", "e");
}
