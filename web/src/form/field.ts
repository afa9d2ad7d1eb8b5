/** The control of one parameter: native elements, with symbol, unit, help, reset, and what is wrong with the last entry. */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { local } from "../language/number.ts";
import { language, say } from "../language/say.ts";
import type { Parameter, Value, Vector } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import { sameValue } from "../params/params.ts";
import type { Entry } from "./entry.ts";
import { issueText } from "./issue.ts";
import { quantityText, read, unitText } from "./quantity.ts";
import { slide } from "./slide.ts";
import { travelOf } from "./travel.ts";
import { labelOf, nameOf } from "./words.ts";

/** `<bough-field>`: dispatches `bough-enter`. It renders into the page itself, so that the page's styles and labels reach it. */
export class BoughField extends LitElement {
  static override properties = {
    parameter: { attribute: false },
    value: { attribute: false },
    baseline: { attribute: false },
    issue: { attribute: false },
    language: { attribute: false },
    draft: { state: true },
    entered: { state: true },
    explained: { state: true },
    explanation: { state: true },
  };

  /** What is controlled. */
  declare parameter: Parameter;
  /** The value in force. */
  declare value: Value;
  /** What a reset brings back. */
  declare baseline: Value;
  /** What is wrong with the last entry, which then stays in the box. */
  declare issue: Issue | undefined;
  /** The language that is spoken: another one says the same anew. */
  declare language: string;
  /** Text in the boxes that is not (yet) a value in force, by the number of the box. */
  declare draft: Readonly<Record<number, string>>;
  /** What was entered and not yet judged: it is shown until it is the value in force, or has an issue. */
  declare entered: Value | undefined;
  declare explained: boolean;
  /** Says what a parameter does, once that was wanted. */
  declare explanation: ((path: string) => unknown) | undefined;

  constructor() {
    super();
    this.draft = {};
    this.explained = false;
  }

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override willUpdate(changed: Map<PropertyKey, unknown>): void {
    // A value that came from elsewhere, or an entry that was good, makes the draft pointless.
    const { value } = this;
    if (changed.has("value") && !sameValue(changed.get("value") as Value, value) && !this.issue)
      this.draft = {};
    if (changed.has("issue") && changed.get("issue") && !this.issue) this.draft = {};
    const isRefused = changed.has("issue") && this.issue !== undefined;
    if (isRefused || (this.entered !== undefined && sameValue(this.entered, value))) this.entered = undefined;
  }

  /** The value that is shown. */
  get #present(): Value {
    const { entered, value } = this;
    const isText = [entered].flat().some((part) => typeof part === "string") && typeof value !== "string";
    return entered === undefined || isText ? value : entered;
  }

  protected override render(): TemplateResult {
    const { parameter, issue } = this;
    const value = this.#present;
    const { symbol } = parameter;
    const label = labelOf(parameter);
    const id = this.#id;
    const name = html`<span class="label">${label}</span>${symbol ? html` <i class="symbol">${symbolText(symbol)}</i>` : nothing}`;
    const isGroup = ["vector", "choice", "optional"].includes(parameter.kind);
    return html`<div
      class="field ${parameter.kind}"
      role=${isGroup ? "group" : nothing}
      aria-labelledby=${isGroup ? `${id}-name` : nothing}
    >
      <div class="heading">
        ${
          isGroup
            ? html`<span id="${id}-name" class="name">${name}</span>`
            : html`<label id="${id}-name" class="name" for=${id}>${name}</label>`
        }
        <output class="reading" for=${id}>${typeof value === "number" ? this.#reading(value) : nothing}</output>
        ${
          sameValue(value, this.baseline) && !issue
            ? nothing
            : html`<button type="button" class="reset" @click=${this.#reset} title=${say("Reset {0}", label)} aria-label=${say("Reset {0}", label)}>${resetIcon}</button>`
        }
        <button
          type="button"
          class="explain"
          aria-expanded=${this.explained}
          aria-controls="${id}-help"
          aria-label=${say("About {0}", label)}
          @click=${() => this.#explain()}
        >?</button>
      </div>
      <div class="entry">${this.#control(value)}</div>
      ${issue ? html`<p class="issue" id="${id}-issue" role="alert">${issueText(issue)}</p>` : nothing}
      <div class="help" id="${id}-help" ?hidden=${!this.explained}>
        ${this.explanation?.(parameter.path)}
      </div>
    </div>`;
  }

  #explain(): void {
    this.explained = !this.explained;
    import("./explanation.ts").then(
      ({ explanationOf }) => {
        this.explanation = explanationOf;
      },
      (error: unknown) => {
        this.explanation = () =>
          say("A part of the page could not be loaded: reload it. ({0})", String(error));
      },
    );
  }

  get #id(): string {
    return this.parameter.path.replace(".", "-");
  }

  /** The value as people say it, where that differs from what is in the box. */
  #reading(value: number): string {
    const { unit } = this.parameter;
    const text = quantityText(value, unit);
    const boxed = `${local(plain(value))}${unit === "deg" ? "" : " "}${unitText(unit)}`;
    return text === boxed.trim() ? "" : text;
  }

  #control(value: Value): TemplateResult {
    if (this.parameter.kind === "optional") return this.#optional(value);
    if (typeof value === "number") return html`${this.#slider(value)}${this.#box(0, value, "")}`;
    if (typeof value === "boolean") return this.#checkbox(value);
    if (typeof value === "string") return this.#choices(value);
    if (value === null) return html``;
    const axes = ["x", "y", "z"];
    return html`${value.map((number, k) => html`<label class="part">${axes[k]} ${this.#box(k, number, `${labelOf(this.parameter)}, ${axes[k]}`)}</label>`)}`;
  }

  /** A number that may be left open: a box to tick, and once it is ticked the number. */
  #optional(value: Value): TemplateResult {
    const label = labelOf(this.parameter);
    return html`<input
        type="checkbox"
        aria-label=${say("{0}, given", label)}
        .checked=${live(value !== null)}
        @change=${(event: Event) => this.#enter((event.target as HTMLInputElement).checked ? 0 : null, "settled")}
      />${typeof value === "number" ? html`${this.#slider(value)}${this.#box(0, value, label)}` : nothing}`;
  }

  #slider(value: number): TemplateResult {
    const travel = travelOf(this.parameter);
    const { unit } = this.parameter;
    const onSlide = slide((position, how) => {
      this.draft = {};
      this.#enter(travel.value(position), how);
    });
    return html`<input
      type="range"
      min=${travel.min}
      max=${travel.max}
      step=${travel.step}
      .value=${live(String(travel.position(value)))}
      aria-label=${say("{0}, slider", labelOf(this.parameter))}
      aria-valuetext=${quantityText(value, unit)}
      @input=${onSlide}
      @change=${onSlide}
      @pointerup=${onSlide}
      @keydown=${onSlide}
      @keyup=${onSlide}
      @blur=${onSlide}
    />`;
  }

  #box(index: number, value: number, name: string): TemplateResult {
    const { issue, parameter } = this;
    const id = this.#id;
    return html`<span class="box"
      ><input
        type="text"
        inputmode="decimal"
        autocomplete="off"
        spellcheck="false"
        id=${index === 0 ? id : `${id}-${index}`}
        aria-label=${name || nothing}
        aria-invalid=${issue ? "true" : nothing}
        aria-describedby=${issue ? `${id}-issue` : nothing}
        .value=${live(this.draft[index] ?? local(plain(value)))}
        @input=${(event: Event) => {
          this.draft = { ...this.draft, [index]: (event.target as HTMLInputElement).value };
        }}
        @change=${() => this.#commit(index)}
        @keydown=${(event: KeyboardEvent) => this.#key(event, index, value)}
      /><span class="unit">${unitText(parameter.unit)}</span></span
    >`;
  }

  #checkbox(value: boolean): TemplateResult {
    return html`<input
      type="checkbox"
      id=${this.#id}
      .checked=${live(value)}
      aria-describedby=${this.issue ? `${this.#id}-issue` : nothing}
      @change=${(event: Event) => this.#enter((event.target as HTMLInputElement).checked, "settled")}
    />`;
  }

  #choices(value: string): TemplateResult {
    const { options = [], path } = this.parameter;
    return html`${options.map(
      (option) => html`<label class="option"
        ><input
          type="radio"
          name=${path}
          value=${option}
          .checked=${live(option === value)}
          @change=${() => this.#enter(option, "settled")}
        />${nameOf(option)}</label
      >`,
    )}`;
  }

  #key(event: KeyboardEvent, index: number, value: number): void {
    if (event.key === "Enter") this.#commit(index);
    if (event.key === "Escape" && this.draft[index] !== undefined) {
      event.stopPropagation();
      this.#reset(this.value);
    }
    const steps = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    const travel = travelOf(this.parameter);
    this.draft = {};
    this.#enterNumber(index, travel.value(travel.position(value) + steps * travel.step), "settled");
  }

  /** Takes what stands in a box. */
  #commit(index: number): void {
    const text = this.draft[index];
    if (text === undefined) return;
    const entered = read(text, this.parameter.unit);
    // The same number again changes nothing: the box just shows it plainly.
    if (entered === this.#number(index) && !this.issue) this.draft = {};
    else this.#enterNumber(index, entered, "settled");
  }

  #number(index: number): number | undefined {
    const { value } = this;
    return Array.isArray(value) ? value[index] : typeof value === "number" ? value : undefined;
  }

  #enterNumber(index: number, entered: number | string, how: Entry["how"]): void {
    const { value } = this;
    if (!Array.isArray(value)) {
      this.#enter(entered, how);
      return;
    }
    // Boxes that still hold a refused entry count with what stands in them.
    const parts = value.map((number, k) => {
      const text = this.draft[k];
      return k === index ? entered : text === undefined ? number : read(text, this.parameter.unit);
    });
    this.#enter(parts as Vector, how);
  }

  readonly #reset = (value: Value | Event): void => {
    this.draft = {};
    this.#enter(value instanceof Event ? this.baseline : value, "settled");
  };

  #enter(value: Value, how: Entry["how"]): void {
    this.entered = value;
    const detail: Entry = { path: this.parameter.path, value, how };
    this.dispatchEvent(new CustomEvent("bough-enter", { bubbles: true, detail }));
  }
}

customElements.define("bough-field", BoughField);

/** The control of a parameter; `baseline` is what a reset brings back. */
export function field(parameter: Parameter, value: Value, baseline: Value, issue?: Issue): TemplateResult {
  return html`<bough-field
    .parameter=${parameter}
    .value=${value}
    .baseline=${baseline}
    .issue=${issue}
    .language=${language()}
  ></bough-field>`;
}

const resetIcon = html`<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M5 6.5a6.3 6.3 0 1 1-1.2 5M5 2.8v3.9h3.9" /></svg>`;

/** A number for a box: all its digits, in the shorter of the two ways to write it. */
function plain(value: number): string {
  const usual = String(value).replace("e+", "e");
  const scientific = value.toExponential().replace("e+", "e");
  return usual.length <= 8 || usual.length <= scientific.length ? usual : scientific;
}

/** A symbol with its index: "ε_T" has a small T. */
function symbolText(symbol: string): TemplateResult | string {
  const [main = "", index] = symbol.split("_", 2);
  return index === undefined ? main : html`${main}<sub>${index}</sub>`;
}
