/** The paper's relaxation, played beside Newton's iterations. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import type { Analyst } from "../engine/analyst.ts";
import type { Vector } from "../params/declaration.ts";
import type { Params } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import type { Way } from "../plant/way.ts";
import { type Chart, drawChart, heightOf, sheet } from "../plots/chart.ts";
import type { Project } from "./desk.ts";
import { lineThrough } from "./overlay.ts";
import { words } from "./words.ts";

/** Both ways of one plant's last step. */
interface Both {
  readonly of: Plant;
  readonly euler: Way;
  readonly newton: Way;
}

/** How long it plays, ms. */
const length = 8000;

export class Ways {
  readonly #analyst: Analyst;
  readonly #onChange: () => void;
  #plant: Plant | null = null;
  #both: Both | null = null;
  #busy = false;
  #problem: string | null = null;
  /** From the unloaded shape, instead of the last growth step alone. */
  #isWhole = false;
  /** How far it has played, 0 to 1. */
  #share = 0;
  #request = 0;

  constructor(analyst: Analyst, onChange: () => void) {
    this.#analyst = analyst;
    this.#onChange = onChange;
  }

  /** Whether they lie over the picture. */
  get shown(): boolean {
    return this.#both !== null;
  }

  /** The plant that they would be played for; those of another one are put away. */
  see(plant: Plant): void {
    const isOther = this.#both !== null && this.#both.of.params !== plant.params;
    if (isOther || (this.#both && this.#both.of.report.steps !== plant.report.steps)) this.close();
    this.#plant = plant;
  }

  close(): void {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#both = null;
    this.#problem = null;
    this.#onChange();
  }

  async #open(): Promise<void> {
    const plant = this.#plant;
    if (!plant || this.#busy) return;
    this.#busy = true;
    this.#problem = null;
    this.#onChange();
    try {
      const { report } = plant;
      const { solver } = plant.params;
      const params: Params = this.#isWhole
        ? { ...plant.params, solver: { ...solver, stepping: "static" } }
        : plant.params;
      const newton = await this.#analyst.way(params, report.steps, "newton");
      const euler = await this.#analyst.way(params, report.steps, "euler");
      if (this.#plant?.params === plant.params) {
        this.#both = { of: plant, euler, newton };
        this.#share = 0;
        this.#play();
      }
    } catch (error) {
      const isAbort = error instanceof DOMException && error.name === "AbortError";
      if (!isAbort) this.#problem = words.why.failed(error instanceof Error ? error.message : String(error));
    } finally {
      this.#busy = false;
      this.#onChange();
    }
  }

  #play(): void {
    if (this.#share >= 1) this.#share = 0;
    let last = performance.now();
    const advance = (now: number) => {
      this.#share = Math.min(1, this.#share + Math.max(0, now - last) / length);
      last = now;
      this.#request = this.#share < 1 ? requestAnimationFrame(advance) : 0;
      this.#onChange();
    };
    this.#request = requestAnimationFrame(advance);
  }

  #pause(): void {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#onChange();
  }

  render(): TemplateResult {
    const both = this.#both;
    const start = (isWhole: boolean, name: string) => html`<label class="option"
      ><input
        type="radio"
        name="way-from"
        .checked=${live(this.#isWhole === isWhole)}
        @change=${() => {
          this.#isWhole = isWhole;
          this.close();
        }}
      />${name}</label
    >`;
    return html`<p class="note">${words.why.waysNote}</p>
      <fieldset class="from">
        <legend class="visually-hidden">${words.why.from}</legend>
        ${start(false, words.why.step)} ${start(true, words.why.whole)}
      </fieldset>
      ${this.#isWhole ? html`<p class="note">${words.why.wholeNote}</p>` : nothing}
      <p class="deeds">
        ${
          this.#busy
            ? html`<span role="status">${words.why.computing}</span>
              <button type="button" @click=${() => this.#analyst.cancel()}>${words.why.stop}</button>`
            : both
              ? html`<button type="button" @click=${() => (this.#request ? this.#pause() : this.#play())}>
                  ${this.#request ? words.why.pause : this.#share >= 1 ? words.why.again : words.why.play}
                </button>
                <button type="button" @click=${() => this.close()}>${words.why.close}</button>`
              : html`<button type="button" @click=${() => void this.#open()}>${words.why.play}</button>`
        }
      </p>
      ${this.#problem ? html`<p class="issue" role="alert">${this.#problem}</p>` : nothing}
      ${both ? this.#player(both) : nothing}`;
  }

  #player({ euler, newton }: Both): TemplateResult {
    const [paper, own] = [this.#momentOf(euler), this.#momentOf(newton)];
    const steps = stepsAt(euler, paper);
    const left = ({ residuals }: Way, moment: number) =>
      words.why.leftOver((residuals[moment] ?? 0).toExponential(0).replace("-", "−"));
    const onInput = (event: Event) => {
      this.#pause();
      this.#share = (event.target as HTMLInputElement).valueAsNumber / 1000;
      this.#onChange();
    };
    const text = words.why.euler(String(steps), String(euler.steps));
    return html`<label class="moment"
        ><span class="visually-hidden">${words.why.moment}</span>
        <input
          type="range"
          min="0"
          max="1000"
          .value=${live(String(Math.round(1000 * this.#share)))}
          aria-valuetext=${text}
          @input=${onInput}
      /></label>
      <dl class="ways">
        <div class="euler"><dt>${text}</dt><dd>${left(euler, paper)}</dd></div>
        <div class="newton">
          <dt>${words.why.newton(String(Math.min(own, newton.steps)), String(newton.steps))}</dt>
          <dd>${left(newton, own)}</dd>
        </div>
      </dl>
      ${newton.isLed && own === newton.time.length - 1 ? html`<p class="note">${words.why.led(newton.steps)}</p>` : nothing}
      ${euler.status === "converged" ? nothing : html`<p class="note">${words.why.notThere}</p>`}
      <svg class="chart residuals" aria-hidden="true" viewBox="0 0 ${sheet.width} ${heightOf(1)}">${drawChart(residualsOf(euler, newton))}</svg>`;
  }

  /** The moment of a way that is due: both take the same time to play. */
  #momentOf({ time }: Way): number {
    return Math.round(this.#share * (time.length - 1));
  }

  draw(project: Project): SVGTemplateResult | null {
    if (!this.#both) return null;
    const { of, euler, newton } = this.#both;
    const lines = (way: Way, className: string) =>
      shapeOf(of, way, this.#momentOf(way)).map((points) => lineThrough(points.map(project), className));
    return svg`<g class="ways">${lines(euler, "euler")}${lines(newton, "newton")}</g>`;
  }
}

/** Moments are thinned evenly, and time steps hardly differ: so the share of time is that of the steps. */
function stepsAt({ time, steps }: Way, moment: number): number {
  return Math.round((steps * (time[moment] ?? 0)) / (time[time.length - 1] || 1));
}

function residualsOf(euler: Way, newton: Way): Chart {
  const curve = (way: Way, kind: "first" | "second") => {
    const moments = [...way.residuals.keys()].filter((moment) => (way.residuals[moment] ?? 0) > 0);
    const x = moments.map((moment) => Math.max(1, kind === "first" ? moment : stepsAt(way, moment)));
    return { x, y: moments.map((moment) => way.residuals[moment] ?? 0), kind };
  };
  const curves = [curve(newton, "first"), curve(euler, "second")];
  return {
    strips: [{ title: words.why.residual, curves, fromZero: false, isLogarithmic: true }],
    across: words.why.work,
    isLogarithmicAcross: true,
    cursor: null,
  };
}

/** The centre lines at a moment, axis after axis, m. */
function shapeOf({ segments, polylines }: Plant, way: Way, moment: number): Vector[][] {
  const { points, offsets } = polylines;
  const ends = new Map<number, Vector>();
  const lines: Vector[][] = Array.from({ length: Math.max(0, offsets.length - 1) }, () => []);
  const root: Vector = [points[0] ?? 0, points[1] ?? 0, points[2] ?? 0];
  for (let segment = 0; segment < way.segments; segment++) {
    const from = ends.get(segments.parent[segment] ?? -1) ?? root;
    const angle = way.angle[moment * way.segments + segment] ?? 0;
    const length = segments.length[segment] ?? 0;
    const to: Vector = [from[0] + length * Math.cos(angle), from[1] + length * Math.sin(angle), from[2]];
    ends.set(segment, to);
    const line = lines[segments.axis[segment] ?? 0];
    if (line?.length === 0) line.push(from);
    line?.push(to);
  }
  return lines;
}
