/** The travel of a slider: from its position to the value and back. */
import type { Parameter } from "../params/declaration.ts";

type Ranged = Pick<Parameter, "kind" | "slider">;

/** A slider as the browser has it: linear, in equal steps. */
export interface Travel {
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Where a value is; beyond the ends, at the end. */
  position(value: number): number;
  /** The value at a position, with no more digits than the step is fine. */
  value(position: number): number;
}

/** The finest step that makes at least this many of them is taken. */
const leastSteps = 150;
/** Steps a decade on a logarithmic scale: about 2 % each. */
const stepsPerDecade = 100;

/** The travel of a parameter's slider. */
export function travelOf({ kind, slider: { min, max, scale } }: Ranged): Travel {
  if (scale === "log") {
    const span = Math.log(max / min);
    const steps = Math.round((span / Math.LN10) * stepsPerDecade);
    const clamp = (value: number) => Math.min(Math.max(value, min), max);
    return {
      min: 0,
      max: steps,
      step: 1,
      position: (value) => Math.round((Math.log(clamp(value) / min) / span) * steps),
      value: (position) => rounded(clamp(min * Math.exp((position / steps) * span)), kind),
    };
  }
  const step = kind === "integer" ? 1 : roundBelow((max - min) / leastSteps);
  const digits = Math.max(0, Math.ceil(-Math.log10(step)));
  return {
    min,
    max,
    step,
    position: (value) => Math.min(Math.max(value, min), max),
    // Plus zero: there is no negative zero.
    value: (position) => Number(position.toFixed(digits)) + 0,
  };
}

function rounded(value: number, kind: Parameter["kind"]): number {
  return kind === "integer" ? Math.round(value) : Number(value.toPrecision(3));
}

/** The largest of 1, 2, 5 times a power of ten that is not above. */
function roundBelow(size: number): number {
  const power = Math.floor(Math.log10(size));
  const digit = [5, 2, 1].find((candidate) => Number(`${candidate}e${power}`) <= size) ?? 1;
  return Number(`${digit}e${power}`);
}
