/** Numbers with units, for people: sensible digits and SI prefixes. */
import { local } from "../language/number.ts";

const prefixes = [
  ["G", 1e9],
  ["M", 1e6],
  ["k", 1e3],
  ["", 1],
  ["m", 1e-3],
  ["µ", 1e-6],
  ["n", 1e-9],
] as const;

/** A unit with its prefix, and how many of the plain unit it is. */
export interface Scale {
  readonly unit: string;
  readonly size: number;
}

/** The unit in which a value has one to three digits before the point. A unit per something, and a pure count, take no prefix. */
export function scaleFor(value: number, unit: string): Scale {
  if (unit === "" || unit.startsWith("1/") || unit === "steps") return { unit, size: 1 };
  const size = Math.abs(value);
  const last = prefixes[prefixes.length - 1] ?? prefixes[3];
  // A hair is allowed for values whose decimals are not exact.
  const fitting = size > 0 ? prefixes.find(([, step]) => size >= step * (1 - 1e-9)) : prefixes[3];
  const [prefix, step] = fitting ?? last;
  return { unit: prefix + unit, size: step };
}

/** A number in two digits, without powers of ten, and with a real minus: "0.32", "−33", "1200". */
export function digits(value: number): string {
  const short = Number(value.toPrecision(2));
  if (short === 0 || Math.abs(short) >= 1)
    return local(String(Math.abs(short) === 0 ? 0 : short).replace("-", "−"));
  const places = Math.min(20, 1 - Math.floor(Math.log10(Math.abs(short))));
  return local(short.toFixed(places).replace(/0$/, "").replace("-", "−"));
}

/** A quantity in two digits: "12 mN". */
export function quantity(value: number, unit: string): string {
  const scale = scaleFor(value, unit);
  return `${digits(value / scale.size)} ${scale.unit}`;
}

/** Standard gravity, N/kg: what turns newtons into grams-force. */
const standardGravity = 9.80665;

/** A force in newtons and in grams-force, which a hand knows: "0.32 N · 33 gf". */
export function forceText(newtons: number): string {
  const inNewtons = newtons >= 0.1 ? `${digits(newtons)} N` : quantity(newtons, "N");
  return `${inNewtons} · ${quantity((newtons * 1000) / standardGravity, "gf")}`;
}
