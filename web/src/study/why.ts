/** Why a plant has its shape: what acts along it, what matters for its tip, whether it holds, and how it came to rest. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import type { Analyst } from "../engine/analyst.ts";
import { quantityText, unitText } from "../form/quantity.ts";
import { digits, quantity, scaleFor } from "../geometry/quantity.ts";
import { local } from "../language/number.ts";
import type { Vector } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import { acrossOf, type Chart, drawChart, heightOf, type Strip, sheet } from "../plots/chart.ts";
import { csvOf, drawingOf, offer } from "../plots/keep.ts";
import { indexAt, type Profile, profileOf, type Quantity, quantities, units } from "../plots/profile.ts";
import { SensitivityBars } from "./bars.ts";
import type { Desk, Project, Section, Sight } from "./desk.ts";
import { stabilitySentences, strengthSentences } from "./soundness.ts";
import { Ways } from "./ways.ts";
import { words } from "./words.ts";

/** Rows of the table: more would not be read. */
const mostRows = 41;

export class Why implements Section {
  readonly name = "why";
  get title(): string {
    return words.why.title;
  }
  open = false;
  readonly #desk: Desk;
  readonly #pinned: () => Plant | null;
  readonly #onChange: () => void;
  readonly #bars: SensitivityBars;
  readonly #ways: Ways;
  #plant: Plant | null = null;
  /** The segment that the cursor stands on; null: none was chosen yet. */
  #cursor: number | null = null;

  /** `pinned` is the plant that the present one is compared with, if there is one. */
  constructor(desk: Desk, analyst: Analyst, pinned: () => Plant | null, onChange: () => void) {
    this.#desk = desk;
    this.#pinned = pinned;
    this.#onChange = onChange;
    this.#bars = new SensitivityBars(analyst, onChange);
    this.#ways = new Ways(analyst, onChange);
    const { stage } = desk;
    // Before the hand, which keeps presses on limbs to itself.
    stage?.canvas.parentElement?.addEventListener("pointerdown", (event) => this.#feel(event), {
      capture: true,
    });
    stage?.canvas.addEventListener("pointermove", (event) => event.buttons === 0 && this.#feel(event));
  }

  see({ shape, rests }: Sight): void {
    this.#plant = shape;
    if (this.#cursor !== null && this.#cursor >= shape.segments.parent.length) this.#cursor = null;
    if (!this.open) return;
    if (rests) void this.#bars.study(shape);
    if (rests) this.#ways.see(shape);
  }

  /** The place of the plant under the pointer. */
  #feel({ clientX, clientY, target }: PointerEvent): void {
    const { stage } = this.#desk;
    if (!this.open || !stage || target !== stage.canvas) return;
    const found = stage.pick(clientX, clientY);
    if (found && found.segment !== this.#cursor) this.#put(found.segment);
  }

  #put(segment: number): void {
    this.#cursor = segment;
    this.#onChange();
  }

  render(): TemplateResult {
    const plant = this.#plant;
    if (!plant) return html``;
    const profile = profileOf(plant, this.#cursor);
    const { report } = plant;
    return html`${this.#along(profile)}
      <h3>${words.why.holds}</h3>
      <dl class="facts">
        <div><dt>${words.why.stability}</dt><dd class=${report.stable === false ? "unsound" : ""}>${stabilitySentences(plant).join(" ")}</dd></div>
        <div><dt>${words.why.strength}</dt><dd>${strengthSentences(plant).join(" ")}</dd></div>
      </dl>
      <h3>${words.why.tip}</h3>
      <p class="note">${words.why.tipNote}</p>
      ${this.#bars.render()}
      <h3>${words.why.ways}</h3>
      ${this.#ways.render()}`;
  }

  #along(profile: Profile): TemplateResult {
    const chart = this.#chart(profile);
    const height = heightOf(quantities.length);
    const index = this.#indexIn(profile);
    return html`<h3>${words.why.along}</h3>
      <div
        class="plots"
        role="slider"
        tabindex="0"
        aria-label=${words.why.place}
        aria-valuemin="1"
        aria-valuemax=${profile.segments.length}
        aria-valuenow=${index + 1}
        aria-valuetext=${reading(profile, index)}
        @keydown=${(event: KeyboardEvent) => this.#key(event, profile)}
        @pointermove=${(event: PointerEvent) => this.#point(event, profile, chart)}
        @pointerdown=${(event: PointerEvent) => this.#point(event, profile, chart)}
      >
        <svg class="chart" aria-hidden="true" viewBox="0 0 ${sheet.width} ${height}">${drawChart(chart)}</svg>
      </div>
      <p class="reading" aria-live="off">${this.#cursor === null ? words.why.hint : reading(profile, index)}</p>
      <p class="deeds">
        <button type="button" @click=${(event: Event) => this.#saveDrawing(event)}>${words.why.saveDrawing}</button>
        <button type="button" @click=${() => this.#saveNumbers(profile)}>${words.why.saveNumbers}</button>
      </p>
      <details class="numbers">
        <summary>${words.why.asTable}</summary>
        ${table(profile)}
      </details>`;
  }

  #chart(profile: Profile): Chart {
    const pinned = this.#pinned();
    const other = pinned ? profileOf(pinned, null) : null;
    const strips = quantities.map((name) => stripOf(name, profile, other));
    const scale = scaleFor(profile.length, "m");
    const chosen = this.#cursor === null ? null : profile.distance[this.#indexIn(profile)];
    return {
      strips: strips.map((strip) => ({
        ...strip,
        curves: strip.curves.map((curve) => ({ ...curve, x: curve.x.map((x) => x / scale.size) })),
      })),
      across: `${words.why.distance} (${scale.unit})`,
      cursor: chosen === null || chosen === undefined ? null : chosen / scale.size,
    };
  }

  #indexIn({ segments }: Profile): number {
    const index = this.#cursor === null ? -1 : segments.indexOf(this.#cursor);
    return index >= 0 ? index : segments.length - 1;
  }

  #key(event: KeyboardEvent, profile: Profile): void {
    const last = profile.segments.length - 1;
    const index = this.#cursor === null ? -1 : this.#indexIn(profile);
    const page = Math.max(2, Math.round(last / 10));
    const to = {
      ArrowRight: index + 1,
      ArrowUp: index + 1,
      ArrowLeft: index - 1,
      ArrowDown: index - 1,
      PageUp: index + page,
      PageDown: index - page,
      Home: 0,
      End: last,
    }[event.key];
    const segment = to === undefined ? undefined : profile.segments[Math.min(last, Math.max(0, to))];
    if (segment === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.#put(segment);
  }

  #point({ clientX, currentTarget }: PointerEvent, profile: Profile, chart: Chart): void {
    const { left, width } = (currentTarget as Element).getBoundingClientRect();
    const place = acrossOf(chart).value(((clientX - left) * sheet.width) / width);
    const { size } = scaleFor(profile.length, "m");
    const segment = profile.segments[indexAt(profile, place * size)];
    if (segment !== undefined && segment !== this.#cursor) this.#put(segment);
  }

  #saveDrawing({ target }: Event): void {
    const chart = (target as Element).closest("details")?.querySelector<SVGSVGElement>(".plots .chart");
    const panel = chart?.closest(".panel");
    if (!chart || !panel) return;
    const paper = getComputedStyle(panel).backgroundColor;
    offer(drawingOf(chart, paper), "image/svg+xml", "bough-along-the-axis.svg");
  }

  #saveNumbers(profile: Profile): void {
    const columns = [
      { name: "segment", values: profile.segments },
      { name: "distance (m)", values: profile.distance },
      ...quantities.map((name) => ({ name: `${name} (${units[name]})`, values: profile.values[name] })),
    ];
    offer(csvOf(columns), "text/csv", "bough-along-the-axis.csv");
  }

  draw(project: Project): SVGTemplateResult | null {
    if (!this.open || !this.#plant) return null;
    const place = this.#cursor === null ? null : project(baseOf(this.#plant, this.#cursor));
    return svg`${this.#ways.draw(project)}${
      place && !this.#ways.shown
        ? svg`<circle class="place" cx=${place.x.toFixed(1)} cy=${place.y.toFixed(1)} r="6" />`
        : nothing
    }`;
  }
}

/** Where a segment's base joint is, m. */
function baseOf({ polylines, segments }: Plant, segment: number): Vector {
  const at = 3 * (segments.point[segment] ?? 1) - 3;
  return [polylines.points[at] ?? 0, polylines.points[at + 1] ?? 0, polylines.points[at + 2] ?? 0];
}

function stripOf(name: Quantity, profile: Profile, other: Profile | null): Strip {
  const all = [...profile.values[name], ...(other?.values[name] ?? [])];
  const most = all.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const scale = name === "angle" ? { unit: "°", size: 1 } : scaleFor(most, units[name]);
  const scaled = (values: readonly number[]) => values.map((value) => value / scale.size);
  const first = { x: profile.distance, y: scaled(profile.values[name]), kind: "first" } as const;
  const second = other && ({ x: other.distance, y: scaled(other.values[name]), kind: "second" } as const);
  return {
    title: `${words.why.quantity[name]} (${unitText(scale.unit)})`,
    curves: second ? [second, first] : [first],
    fromZero: name !== "angle",
  };
}

/** "40 cm: 12°, −0.31 1/m, −12 mN m, 1.2 MPa." */
function reading(profile: Profile, index: number): string {
  const parts = quantities.map((name) => {
    const value = profile.values[name][index] ?? 0;
    const text = name === "angle" ? `${digits(value)}°` : quantity(value, units[name]).replace("1/m", "m⁻¹");
    return `${words.why.quantity[name].toLowerCase()} ${text}`;
  });
  return `${quantityText(profile.distance[index] ?? 0, "m")}: ${parts.join(", ")}.`;
}

function table(profile: Profile): TemplateResult {
  const count = profile.segments.length;
  const stride = Math.max(1, Math.ceil((count - 1) / (mostRows - 1)));
  const rows = [...profile.segments.keys()].filter((row) => row % stride === 0 || row === count - 1);
  const scales = quantities.map((name) => {
    const most = profile.values[name].reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return name === "angle" ? { unit: "°", size: 1 } : scaleFor(most, units[name]);
  });
  const across = scaleFor(profile.length, "m");
  return html`<div class="scroll" tabindex="0" role="region" aria-label=${words.why.along}>
    <table>
      <thead>
        <tr>
          <th scope="col">${words.why.distance} (${across.unit})</th>
          ${quantities.map((name, k) => html`<th scope="col">${words.why.quantity[name]} (${unitText(scales[k]?.unit ?? "")})</th>`)}
        </tr>
      </thead>
      <tbody>
        ${rows.map(
          (row) => html`<tr>
            <th scope="row">${digits3((profile.distance[row] ?? 0) / across.size)}</th>
            ${quantities.map((name, k) => html`<td>${digits3((profile.values[name][row] ?? 0) / (scales[k]?.size ?? 1))}</td>`)}
          </tr>`,
        )}
      </tbody>
    </table>
  </div>`;
}

function digits3(value: number): string {
  return local(String(Number(value.toPrecision(3)) + 0).replace("-", "−"));
}
