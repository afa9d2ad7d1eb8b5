// The table: one line a figure, printed as it is measured and kept for the evidence.

import { ratios, summary } from "./samples.mjs";

/**
 * @typedef {object} Comparison
 * @property {string} name what the figure is a multiple of
 * @property {readonly number[]} samples
 * @property {string} [target]
 *
 * @typedef {object} Row
 * @property {string} what
 * @property {string} [who]
 * @property {readonly number[]} [samples] in `unit`
 * @property {string} [unit] seconds ("s") are shown as ns, us or ms where they are few
 * @property {readonly Comparison[]} [over]
 * @property {string} [note]
 * @property {string} [target]
 */

const widths = { what: 38, who: 26, figure: 32 };

export class Table {
  /** @type {string[]} */
  lines = [];

  /** @param {string} line */
  note(line = "") {
    console.log(line);
    this.lines.push(line.trimEnd());
  }

  /** @param {string} title */
  heading(title) {
    this.note();
    this.note(title);
    this.note("-".repeat(title.length));
  }

  /** @param {Row} row */
  row({ what, who = "", samples, unit = "", over = [], note = "", target = "" }) {
    const figure = samples ? figureOf(samples, unit) : "".padEnd(widths.figure);
    const best = unit === "s" ? "min" : "max";
    const compared = over.map(({ name, samples: others, target: wanted }) => {
      const { median, min, max } = summary(ratios(samples ?? [], others));
      const ofBest = summary(samples ?? [])[best] / summary(others)[best];
      const goal = wanted ? `, target ${wanted}` : "";
      return `${digits(median)} x ${name} (${digits(min)} .. ${digits(max)}, best ${digits(ofBest)}${goal})`;
    });
    const words = [...compared, ...(target ? [`target ${target}`] : []), ...(note ? [note] : [])];
    this.note(`${what.padEnd(widths.what)} ${who.padEnd(widths.who)} ${figure} ${words.join("; ")}`);
  }
}

/**
 * @param {readonly number[]} samples
 * @param {string} unit
 */
function figureOf(samples, unit) {
  const { median, min, max } = summary(samples);
  const [size, name] = (unit === "s" && scales.find(([least]) => median >= least)) || [1, unit];
  const spread = samples.length > 1 ? `${digits(min / size)} .. ${digits(max / size)}` : "once";
  return `${digits(median / size).padStart(8)} ${name.padEnd(3)} ${spread.padStart(18)}`.padEnd(
    widths.figure,
  );
}

/** @type {readonly [number, string][]} */
const scales = [
  [1, "s"],
  [1e-3, "ms"],
  [1e-6, "us"],
  [1e-9, "ns"],
];

/** Three digits. @param {number} value */
export function digits(value) {
  if (!Number.isFinite(value)) return "-";
  const size = Math.abs(value);
  if (size !== 0 && size < 1e-3) return value.toExponential(2);
  return size >= 1000 ? Number(value.toPrecision(3)).toLocaleString("en-US") : value.toPrecision(3);
}
