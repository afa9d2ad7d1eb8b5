/** Round lengths for scale bars. */
import { local } from "../language/number.ts";

/** A length that a scale bar can show. */
export interface Ruler {
  /** In m: 1, 2 or 5 times a power of ten. */
  readonly length: number;
  /** The same for a person: "20 cm". */
  readonly text: string;
}

const units = [
  { unit: "km", size: 1e3 },
  { unit: "m", size: 1 },
  { unit: "cm", size: 1e-2 },
  { unit: "mm", size: 1e-3 },
  { unit: "µm", size: 1e-6 },
] as const;

/** The longest round length that is not above `most` (in m, positive). */
export function rulerWithin(most: number): Ruler {
  const power = Math.floor(Math.log10(most));
  // The logarithm of an exact power of ten may come out just below it: the next decade is tried first.
  const decades = [power + 1, power, power - 1];
  const steps = decades.flatMap((exponent) => [5, 2, 1].map((digit) => Number(`${digit}e${exponent}`)));
  const length = steps.find((step) => step <= most) ?? Number(`1e${power}`);
  return { length, text: inUnits(length) };
}

/** A length in the largest unit that leaves a whole number; below 1 µm a decimal fraction of it. */
function inUnits(length: number): string {
  const { unit, size } = units.find(({ size }) => length >= size * (1 - 1e-9)) ?? units[4];
  return `${local(String(Number((length / size).toPrecision(3))))} ${unit}`;
}
