/** Plants of the course as the core grows them, and what is measured on them, as the text writes it. */
import { angle } from "../../web/src/element/description.ts";
import { measure } from "../../web/src/geometry/measure.ts";
import { grow, history, type ParamsInput, type Plant } from "../../web/src/package/node.ts";
import type { Value } from "../../web/src/params/declaration.ts";
import { read } from "../../web/src/params/link.ts";
import { complete, type Params, withValue } from "../../web/src/params/params.ts";
import { figures } from "./text.ts";

/** The params that a figure of the course starts with, and some of them changed. */
export function paramsOf(figure: string, changes: Readonly<Record<string, Value>> = {}): Params {
  const found = figures.get(figure);
  if (!found) throw new Error(`There is no figure ${figure}.`);
  return changed(read(found.link).state.params, changes);
}

/** The params of a preset, and some of them changed. */
export function paramsOfPreset(preset: string, changes: Readonly<Record<string, Value>> = {}): Params {
  return changed(read(`preset=${preset}`).state.params, changes);
}

function changed(params: Params, changes: Readonly<Record<string, Value>>): Params {
  return Object.entries(changes).reduce((all, [path, value]) => withValue(all, path, value), params);
}

/** A figure's plant, full grown or at an age. */
export function plantOf(figure: string, changes: Readonly<Record<string, Value>> = {}, step?: number): Plant {
  const params = paramsOf(figure, changes);
  return step === undefined ? grow(params) : history(params).at(step);
}

/** The default plant, changed. */
export function plantWith(params: ParamsInput): Plant {
  return grow(complete(params));
}

/** Where the tip points, degrees above the horizontal. */
export const direction = (plant: Plant) => measure(plant).tipElevation;

/** Height of the tip above the base, m. */
export const height = (plant: Plant) => measure(plant).tip[1];

/** Largest bending moment, N m. */
export const moment = ({ segments }: Plant) => Math.max(...segments.moment.map(Math.abs));

/** Mass of all segments, kg. */
export const mass = ({ segments }: Plant) => segments.mass.reduce((sum, own) => sum + own, 0);

/** Distance between two tips, m. */
export function apart(a: Plant, b: Plant): number {
  const [one, other] = [measure(a).tip, measure(b).tip];
  return Math.hypot(one[0] - other[0], one[1] - other[1]);
}

/** How often the curve changes sides; what bends less than 1e-6 per metre does not count. */
export function inflections({ segments }: Plant): number {
  const signs = [...segments.curvature].filter((own) => Math.abs(own) > 1e-6).map(Math.sign);
  return signs.filter((sign, at) => at > 0 && sign !== signs[at - 1]).length;
}

/** "48.5°" */
export const degrees = (value: number, digits = 1) => `${value.toFixed(digits)}°`;

/** "0.491": the digits that count. */
export const digits = (value: number, count = 3) => String(Number(value.toPrecision(count)));

/** "37° down", as a reader says it. */
export const upOrDown = (value: number) =>
  angle(value).replace(" above the horizontal", " up").replace(" below the horizontal", " down");

/** The sag of an axis that starts level, over its length. */
export const sag = (plant: Plant) => -height(plant) / measure(plant).length;

/** Height of the lowest tip above the base, m. */
export function lowestTip({ polylines: { points, offsets } }: Plant): number {
  return Math.min(...[...offsets.subarray(1)].map((next) => points[3 * (next - 1) + 1] ?? 0));
}
