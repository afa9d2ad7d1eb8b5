/** A plant that is pinned, A, beside the present one: over the picture, in numbers, and as a plot. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { quantityText } from "../form/quantity.ts";
import { labelOf, nameOf } from "../form/words.ts";
import { clip } from "../geometry/clip.ts";
import { measure } from "../geometry/measure.ts";
import { digits, quantity, scaleFor } from "../geometry/quantity.ts";
import type { Value, Vector } from "../params/declaration.ts";
import { parameters } from "../params/declaration.ts";
import { read, write } from "../params/link.ts";
import { sameValue, valueAt } from "../params/params.ts";
import type { State } from "../params/state.ts";
import type { Plant } from "../plant/plant.ts";
import { type Chart, drawChart, heightOf, sheet } from "../plots/chart.ts";
import { type Profile, profileOf } from "../plots/profile.ts";
import type { Desk, Project, Section, Sight } from "./desk.ts";
import { lineThrough } from "./overlay.ts";
import { words } from "./words.ts";

/** A plant, and the state that it came from. */
interface Pinned {
  readonly state: Pick<State, "preset" | "params" | "step">;
  readonly plant: Plant;
}

/** Of a plant with more axes than can be told apart, so many are drawn. */
const mostAxes = 100;
/** Places along the axis at which the two are compared. */
const places = 100;

export class Comparison implements Section {
  readonly name = "compare";
  get title(): string {
    return words.compare.title;
  }
  open = false;
  readonly #desk: Desk;
  readonly #onChange: () => void;
  #a: Pinned | null = null;
  #plant: Plant | null = null;
  #rests = false;
  #said: string | null = null;

  constructor(desk: Desk, onChange: () => void) {
    this.#desk = desk;
    this.#onChange = onChange;
    if (desk.address.pin) void this.#recall(desk.address.pin);
  }

  /** The plant A, if there is one. */
  get pinned(): Plant | null {
    return this.#a?.plant ?? null;
  }

  see({ shape, rests }: Sight): void {
    this.#plant = shape;
    this.#rests = rests;
  }

  /** Grows what a link has pinned, with an engine of its own: the page's answers only the newest wish. */
  async #recall(link: string): Promise<void> {
    this.#said = words.compare.growing;
    try {
      const { state } = read(link);
      const engine = await this.#desk.startEngine();
      try {
        const a = { state, plant: await engine.plant(state.params, state.step) };
        if (!this.#a) this.#show(a);
      } finally {
        engine.dispose();
      }
      this.#said = null;
    } catch {
      this.#said = words.compare.unreadable;
      this.#desk.address.pin = "";
    }
    this.#onChange();
  }

  #pin(): void {
    if (!this.#plant) return;
    const { preset, params, step } = this.#desk.store.state;
    this.#put({ state: { preset, params, step }, plant: this.#plant });
  }

  #put(a: Pinned | null): void {
    this.#show(a);
    this.#said = null;
    this.#desk.address.pin = a ? write({ ...this.#desk.store.state, ...a.state }).slice(1) : "";
    this.#onChange();
  }

  #show(a: Pinned | null): void {
    this.#a = a;
    if (this.#desk.stage) this.#desk.stage.beside = this.pinned;
  }

  #swap(): void {
    const a = this.#a;
    if (!a || !this.#plant) return;
    this.#pin();
    this.#desk.actions.change(a.state);
  }

  render(): TemplateResult {
    const a = this.#a;
    const plant = this.#plant;
    // What a hand holds is no plant of its own.
    const isReady = this.#rests && plant?.params.loads.forces.length === 0;
    const button = (text: string, act: () => void) =>
      html`<button type="button" ?disabled=${!isReady} @click=${act}>${text}</button>`;
    const said = this.#said ? html`<p class="note" role="status">${this.#said}</p>` : nothing;
    if (!a || !plant) {
      return html`<p class="note">${words.compare.note}</p>
        ${said}
        <p class="deeds">${button(words.compare.pin, () => this.#pin())}</p>`;
    }
    const [then, now] = [profileOf(a.plant, null), profileOf(plant, null)];
    return html`<p class="deeds">
        ${button(words.compare.swap, () => this.#swap())} ${button(words.compare.pinAgain, () => this.#pin())}
        <button type="button" @click=${() => this.#put(null)}>${words.compare.unpin}</button>
      </p>
      ${differences(a.plant, plant)}
      <h3>${words.compare.changed}</h3>
      ${changes(a.state, this.#desk.store.state)}
      <svg class="chart" aria-hidden="true" viewBox="0 0 ${sheet.width} ${heightOf(2)}">${drawChart(chartOf(a.plant, plant, then, now))}</svg>`;
  }

  draw(project: Project, width: number, height: number): SVGTemplateResult | null {
    if (!this.#a) return null;
    const { points, offsets } = this.#a.plant.polylines;
    const lines = Array.from({ length: Math.min(offsets.length - 1, mostAxes) }, (_, axis) => {
      const [first, end] = [offsets[axis] ?? 0, offsets[axis + 1] ?? 0];
      const stride = Math.max(1, Math.ceil((end - first) / 60));
      const kept = Array.from({ length: end - first }, (_, k) => k).filter(
        (k) => k % stride === 0 || k === end - first - 1,
      );
      const line = kept.map((k) => project(pointAt(points, first + k)));
      return clip(line, width, height).map((part) => lineThrough(part, "ghost"));
    });
    const tip = project(pointAt(points, Math.max(0, (offsets[1] ?? 1) - 1)));
    return svg`<g>${lines}<text class="ghost-name" x=${(tip.x + 8).toFixed(1)} y=${Math.max(16, tip.y - 6).toFixed(1)}>${words.compare.a}</text></g>`;
  }
}

function pointAt(points: Float64Array, point: number): Vector {
  return [points[3 * point] ?? 0, points[3 * point + 1] ?? 0, points[3 * point + 2] ?? 0];
}

/** Measures of a plant, each with the unit it is written in. */
function measures(plant: Plant): { key: keyof typeof words.compare.rows; value: number; unit: string }[] {
  const { tip, length, tipElevation, heading } = measure(plant);
  const most = (array: Float64Array) => array.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return [
    { key: "length", value: length, unit: "m" },
    { key: "across", value: tip[0] * heading[0] + tip[2] * heading[2], unit: "m" },
    { key: "up", value: tip[1], unit: "m" },
    { key: "pointing", value: tipElevation, unit: "deg" },
    { key: "gravityNumber", value: plant.report.gravityNumber, unit: "" },
    { key: "moment", value: most(plant.segments.moment), unit: "N m" },
    { key: "stress", value: most(plant.segments.stress), unit: "Pa" },
    { key: "steps", value: plant.report.steps, unit: "" },
  ];
}

function differences(a: Plant, now: Plant): TemplateResult {
  const after = measures(now);
  const text = (value: number, unit: string) =>
    (unit === "N m" ? quantity(value, unit) : quantityText(value, unit)).replace("-", "−");
  const rows = measures(a).map(({ key, value, unit }, index) => {
    const other = after[index]?.value ?? Number.NaN;
    // A millionth is round-off.
    const off = Math.abs(other - value) < 1e-6 * (Math.abs(value) + Math.abs(other)) ? 0 : other - value;
    return html`<tr>
      <th scope="row">${words.compare.rows[key]}</th>
      <td>${text(value, unit)}</td>
      <td>${text(other, unit)}</td>
      <td>${off > 0 ? "+" : ""}${text(off, unit)}</td>
    </tr>`;
  });
  return html`<div class="scroll" tabindex="0" role="region" aria-label=${words.compare.caption}>
    <table class="differences">
      <caption class="visually-hidden">${words.compare.caption}</caption>
      <thead>
        <tr>
          <th scope="col">${words.compare.measure}</th>
          <th scope="col">${words.compare.a}</th>
          <th scope="col">${words.compare.now}</th>
          <th scope="col">${words.compare.difference}</th>
        </tr>
      </thead>
      <tbody>${rows}</tbody>
    </table>
  </div>`;
}

function changes(a: Pinned["state"], now: State): TemplateResult {
  const text = (value: Value, unit: string): string => {
    if (typeof value === "number") return quantityText(value, unit);
    if (Array.isArray(value)) return value.map((part) => digits(part)).join(", ");
    return typeof value === "string" ? nameOf(value) : String(value ?? "none");
  };
  const lines = parameters.flatMap((parameter) => {
    const { path, unit } = parameter;
    const [before, after] = [valueAt(a.params, path), valueAt(now.params, path)];
    if (sameValue(before, after)) return [];
    return [
      html`<li>${words.compare.changes(labelOf(parameter), text(before, unit), text(after, unit))}</li>`,
    ];
  });
  return lines.length > 0
    ? html`<ul class="changes">${lines}</ul>`
    : html`<p class="note">${words.compare.same}</p>`;
}

/** How far every place of the axis is from where it is in A, and how far it is turned; by its share of the length. */
function chartOf(a: Plant, now: Plant, then: Profile, present: Profile): Chart {
  const share = Array.from({ length: places + 1 }, (_, k) => k / places);
  const [before, after] = [linesOf(a, then), linesOf(now, present)];
  const off = share.map((part) => {
    const [p, q] = [before(part), after(part)];
    return Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  });
  const scale = scaleFor(Math.max(...off), "m");
  const turned = share.map((part) => angleAt(present, part) - angleAt(then, part));
  const x = share.map((part) => 100 * part);
  return {
    strips: [
      {
        title: words.compare.moved(scale.unit),
        curves: [{ x, y: off.map((value) => value / scale.size), kind: "first" }],
        fromZero: true,
      },
      { title: words.compare.turned, curves: [{ x, y: turned, kind: "first" }], fromZero: true },
    ],
    across: words.compare.share,
    cursor: null,
  };
}

/** The place at a share of the length of a path. */
function linesOf(plant: Plant, { segments, distance, length }: Profile): (share: number) => Vector {
  const ends = segments.map((segment) => pointAt(plant.polylines.points, plant.segments.point[segment] ?? 0));
  const [first = 0] = segments;
  const base = pointAt(plant.polylines.points, Math.max(0, (plant.segments.point[first] ?? 1) - 1));
  return (share) => {
    const place = share * length;
    let index = 0;
    while (index + 1 < distance.length && (distance[index + 1] ?? 0) < place) index++;
    const [from, to] = [ends[index - 1] ?? base, ends[index] ?? base];
    const start = distance[index] ?? 0;
    const part = (place - start) / ((distance[index + 1] ?? length) - start || 1);
    return [0, 1, 2].map((k) => (from[k] ?? 0) + part * ((to[k] ?? 0) - (from[k] ?? 0))) as Vector;
  };
}

/** The direction at a share of the length of a path: that of a segment is the one at its middle. */
function angleAt({ distance, length, values: { angle } }: Profile, share: number): number {
  const place = share * length;
  const middle = (index: number) => ((distance[index] ?? length) + (distance[index + 1] ?? length)) / 2;
  let index = 0;
  while (index + 2 < angle.length && middle(index + 1) < place) index++;
  const [from = 0, to = from] = angle.slice(index, index + 2);
  return from + ((to - from) * (place - middle(index))) / (middle(index + 1) - middle(index) || 1);
}
