/** Parameters that bring the axis closest to a traced line, and how sure they are. */
import { parameterAt } from "../params/declaration.ts";
import { type Params, valueAt, withValue } from "../params/params.ts";
import type { Place, Sensitivity } from "../plant/sensitivity.ts";
import { correlations, minimize, scalesOf, squares } from "./levenberg.ts";
import { residualsOf, type Traced } from "./line.ts";
import { inverse, Singular } from "./matrix.ts";
import { studentQuantile } from "./student.ts";

/** How sure the intervals are. */
export const confidence = 0.95;
/** Two columns of derivatives that differ by less than this share (of their squares) say the same: their round-off is 1e-12. */
const leastShare = 1e-9;
/** By less than this (m, for a change of a parameter by its own size, over the length of the line) the axis does not move. */
const leastMovement = 1e-9;

/** What is wished for. */
export interface Wish {
  /** Where the search starts, and what holds for all that is not fitted. */
  readonly params: Params;
  readonly step: number;
  /** The parameters that are fitted, by path. */
  readonly paths: readonly string[];
  readonly traced: readonly Traced[];
  /** Whether the last traced point is the tip. */
  readonly lastIsTip: boolean;
}

/** A parameter that was found. */
export interface Found {
  readonly path: string;
  readonly value: number;
  /** It is within these with the stated confidence, if the model and the other parameters are right. */
  readonly low: number;
  readonly high: number;
}

/** What came of it. */
export type Fit =
  | {
      readonly kind: "found";
      readonly params: Params;
      readonly found: readonly Found[];
      /** Root mean square of the distances that are left, m. */
      readonly deviation: number;
      /** Standard deviation of the tracing, estimated from them, m. */
      readonly noise: number;
      readonly iterations: number;
    }
  /** At least so many points are needed. */
  | { readonly kind: "tooFew"; readonly least: number }
  /** The line does not depend on these at all, or not smoothly. */
  | { readonly kind: "unseen"; readonly paths: readonly string[] }
  /** Only a combination of these can be found. */
  | { readonly kind: "inseparable"; readonly paths: readonly string[] }
  /** No plant comes to rest on the way. */
  | { readonly kind: "lost" };

/** Gives the plant's points and their derivatives, or null. */
export type Study = (params: Params, step: number, places: readonly Place[]) => Promise<Sensitivity | null>;

/** Fits the main axis of a plant to a traced line. */
export async function fitLine({ params, step, paths, traced, lastIsTip }: Wish, study: Study): Promise<Fit> {
  const count = traced.length + (lastIsTip ? 1 : 0);
  if (count <= paths.length + 1) return { kind: "tooFew", least: paths.length + 2 - (lastIsTip ? 1 : 0) };
  const travels = paths.map((path) => travelOf(path, params));
  const withValues = (values: readonly number[]) =>
    paths.reduce(
      (changed, path, k) => withValue(changed, path, travels[k]?.value(values[k] ?? 0) ?? 0),
      params,
    );
  const places = paths.map((path) => ({ path, part: 0 }));
  const numbers = 3 * (Math.min(step, params.axis.segments) + 1);
  const blind = new Set<string>();
  const evaluate = async (values: readonly number[]) => {
    const present = withValues(values);
    const found = await study(present, step, places);
    if (!found) return null;
    const slopes = paths.map((path, k) => {
      const slope = found.slopes[k];
      if (!slope) blind.add(path);
      const factor = travels[k]?.slope(values[k] ?? 0) ?? 1;
      return (slope ?? new Float64Array(numbers)).subarray(0, numbers).map((number) => number * factor);
    });
    const residuals = residualsOf({ points: found.points.subarray(0, numbers), slopes }, traced, lastIsTip);
    return residuals.values.every(Number.isFinite) ? residuals : null;
  };
  const start = travels.map(({ position }, k) => position(Number(valueAt(params, paths[k] ?? ""))));
  const ends = { min: travels.map(({ min }) => min), max: travels.map(({ max }) => max) };
  const minimum = await minimize({ evaluate, ...ends }, start);
  if (!minimum) return { kind: "lost" };
  const { values, residuals, iterations } = minimum;
  const scales = scalesOf(residuals);
  const reach = Math.hypot(...extent(traced)) * Math.sqrt(count);
  const unseen = paths.filter((path, k) => blind.has(path) || !((scales[k] ?? 0) > leastMovement * reach));
  if (unseen.length > 0) return { kind: "unseen", paths: unseen };
  try {
    const spread = inverse(correlations(residuals, scales), leastShare);
    const freedom = count - paths.length;
    const noise = Math.sqrt(squares(residuals) / freedom);
    const reachOf = studentQuantile(confidence, freedom) * noise;
    const found = paths.map((path, k) => {
      const error = (reachOf * Math.sqrt(spread[k]?.[k] ?? 0)) / (scales[k] ?? 1);
      const value = (position: number) => travels[k]?.value(position) ?? 0;
      const at = values[k] ?? 0;
      return { path, value: value(at), low: value(at - error), high: value(at + error) };
    });
    const deviation = Math.sqrt(squares(residuals) / count);
    return { kind: "found", params: withValues(values), found, deviation, noise, iterations };
  } catch (error) {
    if (!(error instanceof Singular)) throw error;
    return { kind: "inseparable", paths: error.columns.flatMap((column) => paths[column] ?? []) };
  }
}

/** How the search moves along a parameter: those that span decades by their logarithm. */
function travelOf(path: string, params: Params) {
  const parameter = parameterAt(path);
  const { min = 0, max = 0, unit = "" } = parameter ?? {};
  const isLogarithmic = unit !== "deg" && min > 0 && Number(valueAt(params, path)) > 0;
  const clamped = (value: number) => Math.min(max, Math.max(min, value));
  if (isLogarithmic) {
    return {
      min: Math.log(min),
      max: Math.log(max),
      position: Math.log,
      value: (position: number) => clamped(Math.exp(position)),
      slope: Math.exp,
    };
  }
  const plain = (value: number) => value;
  return { min, max, position: plain, value: clamped, slope: () => 1 };
}

function extent(traced: readonly Traced[]): [width: number, height: number] {
  const span = (values: number[]) => Math.max(...values) - Math.min(...values);
  return [span(traced.map(({ x }) => x)), span(traced.map(({ y }) => y))];
}
