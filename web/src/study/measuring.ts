/** Measuring on the picture, and fitting the plant to a traced line. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import type { Analyst } from "../engine/analyst.ts";
import { type Fit, fitLine } from "../fit/fit.ts";
import { quantityText } from "../form/quantity.ts";
import { labelOf } from "../form/words.ts";
import { parameterAt } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import { placesOf } from "./bars.ts";
import type { Desk, Project, Section, Sight } from "./desk.ts";
import { Tools } from "./tools.ts";
import { distanceText, Tracing } from "./tracing.ts";
import { words } from "./words.ts";

export class Measuring implements Section {
  readonly name = "measure";
  get title(): string {
    return words.measure.title;
  }
  open = false;
  readonly #desk: Desk;
  readonly #analyst: Analyst;
  readonly #onChange: () => void;
  readonly #tools: Tools;
  readonly #tracing: Tracing | null;
  #plant: Plant | null = null;
  #chosen: ReadonlySet<string> = new Set(["material.youngsModulus"]);
  #lastIsTip = true;
  #busy = false;
  /** What the last fit came to, and with what paths. */
  #fit: Fit | null = null;
  #problem: string | null = null;

  constructor(desk: Desk, analyst: Analyst, onChange: () => void) {
    this.#desk = desk;
    this.#analyst = analyst;
    this.#onChange = onChange;
    this.#tools = new Tools(onChange);
    this.#tracing = desk.stage ? new Tracing(desk.stage, () => this.#plant, onChange) : null;
  }

  /** Takes a photo to trace over; false where there is no picture to lay it on. */
  take(photo: File): boolean {
    if (!this.#tracing) return false;
    this.open = true;
    if (this.#desk.store.state.view === "space") this.#desk.actions.change({ view: "plane" });
    void this.#tracing.take(photo);
    return true;
  }

  see({ shape }: Sight): void {
    this.#plant = shape;
  }

  render(): TemplateResult {
    const plant = this.#plant;
    const tracing = this.#tracing;
    if (!plant || !tracing) return html``;
    if (this.#desk.store.state.view === "space") {
      return html`<p class="note">${words.measure.inSpace}</p>
        <p class="deeds">
          <button type="button" @click=${() => this.#desk.actions.change({ view: "plane" })}>${words.measure.toPlane}</button>
        </p>`;
    }
    return html`<h3>${words.measure.tools}</h3>
      ${this.#tools.render(plant)} ${tracing.render()}
      <h3>${words.measure.fit}</h3>
      ${plant.params.arrangement.pattern === "single" ? this.#fitting(plant, tracing) : html`<p class="note">${words.measure.aroundStem}</p>`}`;
  }

  #fitting(plant: Plant, tracing: Tracing): TemplateResult {
    const { measure: own } = words;
    const paths = placesOf(plant.params).filter(({ path }) => parameterAt(path)?.kind === "number");
    const choose = (path: string, isOn: boolean) => {
      this.#chosen = new Set(
        isOn ? [...this.#chosen, path] : [...this.#chosen].filter((other) => other !== path),
      );
      this.#onChange();
    };
    const option = (name: string, isOn: boolean, enter: (isOn: boolean) => void) => html`<label class="option"
      ><input type="checkbox" .checked=${live(isOn)} @change=${(event: Event) => enter((event.target as HTMLInputElement).checked)} />${name}</label
    >`;
    return html`<p class="note">${own.fitNote}</p>
      <fieldset class="which">
        <legend>${own.which}</legend>
        ${paths.map(({ path }) => option(nameAt(path), this.#chosen.has(path), (isOn) => choose(path, isOn)))}
      </fieldset>
      ${option(own.lastIsTip, this.#lastIsTip, (isOn) => {
        this.#lastIsTip = isOn;
        this.#onChange();
      })}
      <p class="deeds">
        ${
          this.#busy
            ? html`<span role="status">${own.fitting}</span>
              <button type="button" @click=${() => this.#analyst.cancel()}>${own.stop}</button>`
            : html`<button type="button" class="run" @click=${() =>
                void this.#run(
                  plant,
                  tracing,
                  paths.map(({ path }) => path),
                )}>${own.run}</button>`
        }
      </p>
      ${this.#outcome(tracing)}`;
  }

  async #run(plant: Plant, tracing: Tracing, offered: readonly string[]): Promise<void> {
    const paths = offered.filter((path) => this.#chosen.has(path));
    this.#fit = null;
    this.#problem = paths.length === 0 ? words.measure.none : null;
    this.#busy = paths.length > 0;
    this.#onChange();
    if (!this.#busy) return;
    const { params, report } = plant;
    const wish = { params, step: report.steps, paths, traced: tracing.traced, lastIsTip: this.#lastIsTip };
    try {
      const found = await fitLine(wish, (...asked) => this.#analyst.sensitivity(...asked));
      this.#fit = found;
      if (found.kind === "found") this.#desk.actions.change({ params: found.params });
    } catch (error) {
      const isAbort = error instanceof DOMException && error.name === "AbortError";
      if (!isAbort)
        this.#problem = words.measure.failed(error instanceof Error ? error.message : String(error));
    } finally {
      this.#busy = false;
      this.#onChange();
    }
  }

  #outcome(tracing: Tracing): TemplateResult | typeof nothing {
    const { measure: own } = words;
    if (this.#problem) return html`<p class="issue" role="alert">${this.#problem}</p>`;
    const found = this.#fit;
    if (!found) return nothing;
    const problem = (sentence: string) => html`<p class="issue" role="alert">${sentence}</p>`;
    const labels = (paths: readonly string[]) => paths.map(nameAt).join(", ");
    switch (found.kind) {
      case "tooFew":
        return problem(own.tooFew(found.least));
      case "unseen":
        return problem(own.unseen(labels(found.paths)));
      case "inseparable":
        return problem(own.inseparable(labels(found.paths)));
      case "lost":
        return problem(own.lost);
    }
    const text = (path: string, value: number) => quantityText(value, parameterAt(path)?.unit ?? "", 4);
    return html`<table class="fitted">
        <caption class="visually-hidden">${own.caption}</caption>
        <thead>
          <tr>
            <th scope="col">${own.value}</th>
            <th scope="col">${own.fitted}</th>
            <th scope="col">${own.interval}</th>
          </tr>
        </thead>
        <tbody>
          ${found.found.map(
            ({ path, value, low, high }) => html`<tr data-path=${path} data-low=${low} data-high=${high}>
              <th scope="row">${nameAt(path)}</th>
              <td>${text(path, value)}</td>
              <td>${own.between(text(path, low), text(path, high))}</td>
            </tr>`,
          )}
        </tbody>
      </table>
      <p class="note" role="status">
        ${own.deviation(distanceText(found.deviation, tracing.pixel), own.iterations(found.iterations))} ${own.sure}
      </p>`;
  }

  draw(project: Project): SVGTemplateResult | null {
    const { stage, store } = this.#desk;
    if (!stage || !this.#tracing || store.state.view === "space") return null;
    return svg`${this.#tracing.draw(project, this.open)}${this.open ? this.#tools.draw(stage, project) : nothing}`;
  }
}

function nameAt(path: string): string {
  const parameter = parameterAt(path);
  return parameter ? labelOf(parameter) : path;
}
