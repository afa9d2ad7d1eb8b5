/** Which parameter matters most for the tip: its exact derivatives, as small bars. */
import { html, nothing, type TemplateResult } from "lit";
import type { Analyst } from "../engine/analyst.ts";
import { quantityText } from "../form/quantity.ts";
import { labelOf } from "../form/words.ts";
import { parameters } from "../params/declaration.ts";
import { type Params, valueAt } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import type { Place } from "../plant/sensitivity.ts";
import { words } from "./words.ts";

/** How the tip moves with one parameter: by a tenth more of it, or by 5 degrees, in the direction of the change. */
interface Bar {
  readonly label: string;
  readonly change: string;
  /** m */
  readonly x: number;
  readonly y: number;
}

/** The bars of one plant, or why there are none. */
interface Bars {
  readonly of: Plant;
  readonly list: readonly Bar[];
  readonly without: readonly string[];
  readonly sentence: string | null;
}

const share = 0.1;
const turn = 5;
/** Shorter ones than this share of the longest are not worth a line. */
const leastShare = 1e-3;

export class SensitivityBars {
  readonly #analyst: Analyst;
  readonly #onChange: () => void;
  #bars: Bars | null = null;
  #asked: Plant | null = null;

  constructor(analyst: Analyst, onChange: () => void) {
    this.#analyst = analyst;
    this.#onChange = onChange;
  }

  /** Finds the bars of a plant that is at rest. */
  async study(plant: Plant): Promise<void> {
    if (this.#asked === plant) return;
    this.#asked = plant;
    const bars = await this.#find(plant);
    if (this.#asked !== plant) return;
    // Cancelled with something else: the next time it is looked at it is found anew.
    if (!bars) this.#asked = null;
    else this.#bars = bars;
    this.#onChange();
  }

  async #find(plant: Plant): Promise<Bars | null> {
    const places = placesOf(plant.params);
    const none = (sentence: string): Bars => ({ of: plant, list: [], without: [], sentence });
    try {
      const found = await this.#analyst.sensitivity(plant.params, plant.report.steps, places);
      if (!found) return none(reasonOf(plant.params));
      const tip = tipOf(plant, found.points);
      const list: Bar[] = [];
      const without: string[] = [];
      places.forEach((place, index) => {
        const parameter = parameters.find(({ path }) => path === place.path);
        const slope = found.slopes[index];
        if (!parameter) return;
        const part = parameter.kind === "vector" ? `, ${"xyz"[place.part]}` : "";
        const label = `${labelOf(parameter)}${part}`;
        if (!slope) {
          without.push(label);
          return;
        }
        const isAngle = parameter.unit === "deg";
        const change = isAngle ? turn : share * Math.abs(numberAt(plant.params, place));
        list.push({
          label,
          change: isAngle ? words.why.turn : words.why.share,
          x: change * (slope[tip] ?? 0),
          y: change * (slope[tip + 1] ?? 0),
        });
      });
      list.sort((a, b) => Math.hypot(b.x, b.y) - Math.hypot(a.x, a.y));
      return { of: plant, list, without, sentence: null };
    } catch (error) {
      if (error instanceof DOMException && error.name === "AbortError") return null;
      return none(words.why.failed(error instanceof Error ? error.message : String(error)));
    }
  }

  render(): TemplateResult {
    const bars = this.#bars;
    if (!bars) return html`<p class="note" role="status">${words.why.computing}</p>`;
    if (bars.sentence) return html`<p class="note" role="status">${bars.sentence}</p>`;
    const longest = Math.max(...bars.list.map(({ x, y }) => Math.hypot(x, y)), 1e-300);
    const shown = bars.list.filter(({ x, y }) => Math.hypot(x, y) >= leastShare * longest);
    return html`<ul class="bars">
        ${shown.map(
          (bar) => html`<li>
            <span>${words.why.more(bar.label, bar.change)}</span>
            <svg class="bar" aria-hidden="true"><rect width="${((100 * Math.hypot(bar.x, bar.y)) / longest).toFixed(1)}%" height="100%" rx="2" /></svg>
            <small>${movement(bar)}</small>
          </li>`,
        )}
      </ul>
      ${bars.without.length > 0 ? html`<p class="note">${words.why.noSlope(bars.without.join(", "))}</p>` : nothing}`;
  }
}

/** Where the main axis ends among the numbers of the points. Around a stem its copy has no other axis, or begins with it. */
function tipOf({ params, report }: Plant, points: Float64Array): number {
  return Math.min(3 * Math.min(report.steps, params.axis.segments), points.length - 3);
}

/** "12 mm down, 3 mm to the left": of the two parts, those that matter. */
function movement({ x, y }: Bar): string {
  const size = Math.hypot(x, y);
  if (size === 0) return words.why.nowhere;
  const part = (value: number, positive: string, negative: string) =>
    Math.abs(value) < 0.05 * size
      ? []
      : [words.why.moves(quantityText(Math.abs(value), "m", 2), value > 0 ? positive : negative)];
  return [...part(y, words.why.up, words.why.down), ...part(x, words.why.right, words.why.left)].join(", ");
}

/** Why there are no derivatives. */
export function reasonOf({ loads, solver }: Params): string {
  if (loads.forces.length > 0) return words.why.none.forces;
  return solver.stepping === "extrapolated" ? words.why.none.extrapolated : words.why.none.plant;
}

/** The parameters whose tenth means something here: numbers of what grows and what pulls. */
export function placesOf(params: Params): Place[] {
  const physical = parameters.filter(({ path }) => /^(axis|material|tropism|branching|loads)\./.test(path));
  return physical.flatMap(({ path, kind, unit }) => {
    const forks = params.branching.pattern !== "none";
    if (path.startsWith("branching.") && !(forks && /exponent|girthRatio/.test(path))) return [];
    if (path === "axis.taper" && params.growth.thickening === "pipes") return [];
    if (path === "tropism.elevation" && params.tropism.strength === 0) return [];
    const parts = kind === "vector" ? [0, 1] : kind === "number" ? [0] : [];
    const places = parts.map((part) => ({ path, part }));
    return places.filter((place) => unit === "deg" || numberAt(params, place) !== 0);
  });
}

/** One number of the params. */
export function numberAt(params: Params, { path, part }: Place): number {
  const value = valueAt(params, path);
  return Number(Array.isArray(value) ? value[part] : value);
}
