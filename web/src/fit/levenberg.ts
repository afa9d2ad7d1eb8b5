/** Least squares by Levenberg's and Marquardt's method: Gauss-Newton steps, shortened where they do not help. */
import type { Residuals } from "./line.ts";
import { inverse, times } from "./matrix.ts";

/** What is to be made small. */
export interface Problem {
  /** The residuals there; null where there are none. */
  evaluate(values: readonly number[]): Promise<Residuals | null>;
  readonly min: readonly number[];
  readonly max: readonly number[];
}

/** Where the search ended. */
export interface Minimum {
  readonly values: readonly number[];
  readonly residuals: Residuals;
  readonly iterations: number;
}

const mostIterations = 60;
/** A step that makes the sum of squares smaller by less than this share was the last. */
const leastGain = 1e-12;
/** Beyond this damping steps are too short to find anything. */
const mostDamping = 1e10;

/** Null where not even the start has residuals. */
export async function minimize(problem: Problem, start: readonly number[]): Promise<Minimum | null> {
  let values = [...start];
  let residuals = await problem.evaluate(values);
  if (!residuals) return null;
  let damping = 1e-3;
  let iterations = 0;
  while (iterations < mostIterations && damping < mostDamping) {
    iterations++;
    const before = squares(residuals);
    const step = stepFrom(residuals, damping);
    const next = values.map((value, k) =>
      Math.min(problem.max[k] ?? value, Math.max(problem.min[k] ?? value, value + (step[k] ?? 0))),
    );
    const there = await problem.evaluate(next);
    const after = there ? squares(there) : Number.POSITIVE_INFINITY;
    if (!there || !(after <= before)) {
      damping *= 10;
      continue;
    }
    values = next;
    residuals = there;
    damping = Math.max(1e-12, damping / 10);
    if (before - after <= leastGain * before) break;
  }
  return { values, residuals, iterations };
}

/** The sum of squares. */
export function squares({ values }: Residuals): number {
  return values.reduce((sum, value) => sum + value * value, 0);
}

/** The scale of every parameter: how much all residuals together change with it. */
export function scalesOf({ rows }: Residuals): number[] {
  const count = rows[0]?.length ?? 0;
  return Array.from({ length: count }, (_, k) => Math.hypot(...rows.map((row) => row[k] ?? 0)));
}

/** The products of all columns with each other, each column of length 1. */
export function correlations({ rows }: Residuals, scales: readonly number[]): number[][] {
  return scales.map((a, i) =>
    scales.map((b, k) => {
      const product = rows.reduce((sum, row) => sum + (row[i] ?? 0) * (row[k] ?? 0), 0);
      return i === k ? 1 : product / (a * b || 1);
    }),
  );
}

function stepFrom(residuals: Residuals, damping: number): number[] {
  const scales = scalesOf(residuals);
  const damped = correlations(residuals, scales).map((row, i) =>
    row.map((entry, k) => (i === k ? entry + damping : entry)),
  );
  const slope = scales.map(
    (scale, k) =>
      -residuals.rows.reduce((sum, row, i) => sum + (row[k] ?? 0) * (residuals.values[i] ?? 0), 0) /
      (scale || 1),
  );
  return times(inverse(damped, 0), slope).map((part, k) => part / (scales[k] || 1));
}
