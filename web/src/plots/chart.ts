/** Charts as SVG: strips above each other over one horizontal scale, small enough to stand beside the picture. */
import { nothing, type SVGTemplateResult, svg } from "lit";
import { digits } from "../geometry/quantity.ts";
import { ticksWithin } from "./ticks.ts";

/** One curve. */
export interface Curve {
  readonly x: readonly number[];
  readonly y: readonly number[];
  /** The second one of a strip is what the first is compared with. */
  readonly kind: "first" | "second";
}

/** One strip. */
export interface Strip {
  /** Its name, with the unit: "Moment (mN m)". */
  readonly title: string;
  readonly curves: readonly Curve[];
  /** Whether the scale must reach to zero. */
  readonly fromZero: boolean;
  /** Values are powers of ten. */
  readonly isLogarithmic?: boolean;
}

/** What is drawn. */
export interface Chart {
  readonly strips: readonly Strip[];
  /** Name of the horizontal scale, with the unit. */
  readonly across: string;
  readonly isLogarithmicAcross?: boolean;
  /** Where the cursor stands on the horizontal scale. */
  readonly cursor: number | null;
}

/** Sizes in units of the drawing, which are about px. */
export const sheet = { width: 340, left: 50, right: 10, strip: 78, gap: 26, foot: 34 } as const;
/** A curve of more points than this cannot be told from one of this many. */
const mostPoints = 400;

/** The height of a chart of so many strips. */
export function heightOf(strips: number): number {
  return strips * (sheet.strip + sheet.gap) + sheet.foot;
}

/** From the horizontal scale to the drawing and back. */
export function acrossOf({ strips, isLogarithmicAcross = false }: Chart): {
  min: number;
  max: number;
  place(value: number): number;
  value(place: number): number;
} {
  const all = strips.flatMap(({ curves }) => curves.flatMap(({ x }) => [x[0] ?? 0, x[x.length - 1] ?? 0]));
  const min = isLogarithmicAcross ? Math.max(1, Math.min(...all)) : Math.min(0, ...all);
  const max = Math.max(...all, isLogarithmicAcross ? 10 * min : 1e-12);
  const scale = (value: number) => (isLogarithmicAcross ? Math.log10(Math.max(value, min)) : value);
  const [low, high] = [scale(min), scale(max)];
  const room = sheet.width - sheet.left - sheet.right;
  return {
    min,
    max,
    place: (value) => sheet.left + (room * (scale(value) - low)) / (high - low),
    value: (place) => {
      const scaled = low + ((place - sheet.left) / room) * (high - low);
      return isLogarithmicAcross ? 10 ** scaled : scaled;
    },
  };
}

/** The parts of a chart, to be put into an `svg` element whose view box is `sheet.width` by `heightOf(strips)`. */
export function drawChart(chart: Chart): SVGTemplateResult {
  const across = acrossOf(chart);
  const foot = heightOf(chart.strips.length) - sheet.foot;
  const exponents = ticksWithin(Math.log10(Math.max(across.min, 1e-300)), Math.log10(across.max));
  const marks = chart.isLogarithmicAcross
    ? exponents.filter(Number.isInteger).map((power) => 10 ** power)
    : ticksWithin(across.min, across.max, 6);
  return svg`
    ${chart.strips.map((strip, index) => drawStrip(strip, index * (sheet.strip + sheet.gap) + sheet.gap, across.place))}
    ${marks.map(
      (value) =>
        svg`<text class="tick" text-anchor="middle" x=${across.place(value).toFixed(1)} y=${foot + 14}>${digits(value)}</text>`,
    )}
    <text class="name" text-anchor="end" x=${sheet.width - sheet.right} y=${foot + 30}>${chart.across}</text>
    ${
      chart.cursor === null
        ? nothing
        : svg`<line class="cursor" x1=${across.place(chart.cursor).toFixed(1)} x2=${across.place(chart.cursor).toFixed(1)} y1=${sheet.gap - 4} y2=${foot} />`
    }`;
}

function drawStrip(strip: Strip, top: number, place: (x: number) => number): SVGTemplateResult {
  const scaled = (value: number) => (strip.isLogarithmic ? Math.log10(Math.max(value, 1e-17)) : value);
  const values = strip.curves.flatMap(({ y }) => y.map(scaled)).filter(Number.isFinite);
  const zero = strip.fromZero ? [0] : [];
  let min = values.reduce((least, value) => Math.min(least, value), zero[0] ?? values[0] ?? 0);
  let max = values.reduce((most, value) => Math.max(most, value), zero[0] ?? values[0] ?? 1);
  // A straight line must not become a picture of round-off.
  const least = strip.fromZero ? 1e-9 : 1;
  if (max - min < least) [min, max] = [(min + max - 1) / 2, (min + max + 1) / 2];
  const height = (value: number) => top + sheet.strip * (1 - (scaled(value) - min) / (max - min));
  const marks = strip.isLogarithmic
    ? ticksWithin(min, max, 3)
        .filter(Number.isInteger)
        .map((power) => 10 ** power)
    : ticksWithin(min, max);
  const end = sheet.width - sheet.right;
  return svg`<text class="name" x="2" y=${top - 9}>${strip.title}</text>
    ${marks.map(
      (
        value,
      ) => svg`<line class=${value === 0 ? "zero" : "grid"} x1=${sheet.left} x2=${end} y1=${height(value).toFixed(1)} y2=${height(value).toFixed(1)} />
        <text class="tick" text-anchor="end" x=${sheet.left - 6} y=${(height(value) + 3.5).toFixed(1)}>${strip.isLogarithmic ? power(value) : digits(value)}</text>`,
    )}
    ${strip.curves.map((curve) => svg`<path class="curve ${curve.kind}" d=${pathOf(curve, place, height)} />`)}`;
}

function power(value: number): string {
  const exponent = Math.round(Math.log10(value));
  if (exponent === 0) return "1";
  return `1e${String(exponent).replace("-", "−")}`;
}

function pathOf({ x, y }: Curve, place: (x: number) => number, height: (y: number) => number): string {
  const stride = Math.max(1, Math.ceil(x.length / mostPoints));
  const parts: string[] = [];
  for (let k = 0; k < x.length; k += stride) {
    const at = k + stride >= x.length ? x.length - 1 : k;
    const [across, up] = [place(x[at] ?? 0), height(y[at] ?? 0)];
    if (Number.isFinite(across) && Number.isFinite(up)) parts.push(`${across.toFixed(1)} ${up.toFixed(1)}`);
  }
  return parts.length > 0 ? `M${parts.join("L")}` : "";
}
