/** A plant in a row of numbers: the columns of sweeps. The very numbers of the core, which the native sweep writes. */
import { type Measures, measureNames } from "../../generated/measures.ts";
import type { Plant } from "./plant.ts";

export { type Measures, measureNames };

/** Measures a plant. */
export function measuresOf({ polylines, segments, report }: Plant): Measures {
  const { points, radii, offsets } = polylines;
  const tip = 3 * (offsets[1] ?? 0) - 3;
  const fromBase = (k: number) => (points[tip + k] ?? 0) - (points[k] ?? 0);
  let height = 0;
  let squaredReach = 0;
  for (let at = 0; at < points.length; at += 3) {
    const along = (points[at] ?? 0) - (points[0] ?? 0);
    const across = (points[at + 2] ?? 0) - (points[2] ?? 0);
    height = Math.max(height, (points[at + 1] ?? 0) - (points[1] ?? 0));
    squaredReach = Math.max(squaredReach, along * along + across * across);
  }
  return {
    tipX: fromBase(0),
    tipY: fromBase(1),
    tipZ: fromBase(2),
    height,
    reach: Math.sqrt(squaredReach),
    length: sum(segments.length),
    mass: sum(segments.mass),
    baseRadius: radii[0] ?? 0,
    baseMoment: segments.moment[0] ?? 0,
    largestMoment: largest(segments.moment),
    largestStress: largest(segments.stress),
    segments: segments.parent.length,
    axes: Math.max(0, offsets.length - 1),
    steps: report.steps,
    gravityNumber: report.gravityNumber,
    residual: report.residual,
    iterations: report.iterations,
    stable: report.stable === null ? Number.NaN : Number(report.stable),
  };
}

function sum(values: Float64Array): number {
  return values.reduce((all, value) => all + value, 0);
}

function largest(values: Float64Array): number {
  return values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
}
