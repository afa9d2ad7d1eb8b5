/** What a reader can change: the age and a few sliders, or everything that is declared, in groups. */
import type { Entry } from "../form/entry.ts";
import { nameOf } from "../form/words.ts";
import { groupAndField, type Parameter, parameters, type Value } from "../params/declaration.ts";
import { type Params, valueAt } from "../params/params.ts";
import { colors, type State, styles, views } from "../params/state.ts";
import { choiceOf, type Dial, dialOf, rangeOf } from "./dial.ts";
import { element } from "./face.ts";
import { sheetOf } from "./style.ts";
import type { controlKinds } from "./wanted.ts";

/** What is shown. */
export interface Shown {
  readonly state: State;
  readonly params: Params;
  /** The age that is shown, and the last one; growth steps. */
  readonly step: number;
  readonly last: number;
  readonly plays: boolean;
}

/** What a reader can do. */
export interface Actions {
  enter(path: string, value: Value, how: Entry["how"]): void;
  age(step: number, how: Entry["how"]): void;
  look(change: Partial<Pick<State, "view" | "color" | "style">>): void;
  togglePlay(): void;
  reset(): void;
}

/** One of the kinds of controls. */
export type ControlKind = (typeof controlKinds)[number];

/** What a reader meets first, if the author names nothing else. The second gives way where there is little room. */
const usual: readonly string[] = ["axis.elevation", "material.youngsModulus", "loads.gravity"];

const sheetText = `
.controls {
  display: grid;
  gap: 0.35rem 1.4rem;
  overflow: auto;
  padding: 0.6rem 0.8rem;
  border-top: 1px solid var(--line);
}
.time { display: flex; align-items: center; gap: 0.6rem; }
.time .dial { align-items: center; flex: 1; grid-template-columns: auto 1fr auto; }
.dials { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(10.5rem, 100%), 1fr)); gap: 0.35rem 1rem; }
.dial { display: grid; grid-template-columns: 1fr auto; align-items: end; gap: 0 0.4rem; min-width: 0; }
.dial > input[type="range"], .dial > select { grid-column: 1 / -1; }
.dial > output { grid-area: 1 / 2; }
.time .dial > :is(input, output) { grid-area: auto; }
.vector { grid-template-columns: repeat(3, minmax(0, 1fr)); }
.vector > span { grid-column: 1 / -1; }
output { direction: ltr; color: var(--quiet); font-variant-numeric: tabular-nums; white-space: nowrap; }
button, select, input[type="number"] {
  min-width: 0;
  border: 1px solid var(--line);
  border-radius: 0.4rem;
  padding: 0.2rem 0.4rem;
  background: var(--paper-lit);
  color: inherit;
  font: inherit;
}
option { background: var(--paper-lit); }
.controls button { border: 0; background: var(--wash); cursor: pointer; }
.play { display: grid; flex: none; width: 2.25rem; height: 2.25rem; padding: 0; place-items: center; border-radius: 50%; }
.play svg { width: 1.1rem; height: 1.1rem; fill: none; stroke: currentColor; stroke-width: 1.8; stroke-linejoin: round; }
input[type="range"] { width: 100%; min-width: 0; height: 1.5rem; margin: 0; accent-color: var(--accent); cursor: pointer; }
input[type="checkbox"] { width: 1.1rem; height: 1.1rem; margin: 0; accent-color: var(--accent); }
summary { padding: 0.3rem 0; cursor: pointer; }
.foot { display: flex; justify-content: end; }
@media print { .controls { display: none; } }
@container (max-width: 34rem) {
  .compact .usual > :nth-child(2) { display: none; }
}
@container (min-width: 46rem) {
  figure.full { display: grid; grid-template: auto / minmax(0, 1fr) 19rem; }
  .full .controls { border-top: 0; border-inline-start: 1px solid var(--line); align-content: start; contain: size; }
  .full figcaption { grid-column: 1 / -1; }
}
`;

let sheet: CSSStyleSheet | undefined;

/** The style sheet of all controls. */
export function sheetOfControls(): CSSStyleSheet {
  sheet ??= sheetOf(sheetText);
  return sheet;
}

export class Controls {
  readonly #host: HTMLElement;
  readonly #play = element("button", { class: "play", part: "play", type: "button" });
  readonly #age: ReturnType<typeof rangeOf>;
  readonly #time = element("div", { class: "time" });
  readonly #dials = new Map<string, Dial>();
  readonly #looks: readonly (readonly ["view" | "color" | "style", Dial])[];

  /** Fills an element with controls of a kind; `fields` are the paths of those that come first. */
  constructor(
    host: HTMLElement,
    kind: Exclude<ControlKind, "none">,
    fields: readonly string[] | null,
    actions: Actions,
  ) {
    this.#host = host;
    this.#age = rangeOf("Age", { min: "1", max: "1", step: "1" }, actions.age);
    this.#play.addEventListener("click", actions.togglePlay);
    this.#age.element.setAttribute("part", "age");
    const make = (parameter: Parameter) => {
      const dial = dialOf(parameter, (value, how) => actions.enter(parameter.path, value, how));
      this.#dials.set(parameter.path, dial);
      return dial.element;
    };
    const main = fields ?? usual;
    const first = main.flatMap((path) => parameters.filter((one) => one.path === path).map(make));
    const looks = {
      color: choiceOf("Colour", named(colors), (color) => actions.look({ color: color as State["color"] })),
      style: choiceOf("Drawing", named(styles), (style) => actions.look({ style: style as State["style"] })),
      view: choiceOf("View", named(views), (view) => actions.look({ view: view as State["view"] })),
    };
    this.#looks =
      kind === "full" ? (["color", "style", "view"] as const).map((key) => [key, looks[key]]) : [];
    this.#time.append(this.#play, this.#age.element);
    host.setAttribute("role", "group");
    host.setAttribute("aria-label", "Controls");
    host.replaceChildren(
      this.#time,
      element("div", { class: fields ? "dials" : "dials usual", part: "dials" }, ...first),
    );
    if (kind !== "full") return;
    const reset = element("button", { type: "button", part: "reset" }, "Reset all");
    reset.addEventListener("click", actions.reset);
    host.append(
      element("div", { class: "dials" }, ...this.#looks.map(([, dial]) => dial.element)),
      ...groups(main).map(([group, members]) =>
        element(
          "details",
          {},
          element("summary", {}, nameOf(group)),
          element("div", { class: "dials" }, ...members.map(make)),
        ),
      ),
      element("div", { class: "foot" }, reset),
    );
  }

  /** Shows what is in force. */
  show({ state, params, step, last, plays }: Shown): void {
    const label = plays ? "Pause" : "Watch it grow";
    if (this.#play.getAttribute("aria-label") !== label) {
      this.#play.setAttribute("aria-label", label);
      this.#play.title = label;
      this.#play.replaceChildren(icon(plays ? "M7 4.5v11M13 4.5v11" : "M6.5 4.2v11.6l9-5.8z"));
    }
    const { input, output } = this.#age;
    this.#time.hidden = last === 1;
    input.max = String(last);
    input.value = String(step);
    input.setAttribute("aria-valuetext", `growth step ${step} of ${last}`);
    output.textContent = `${step} of ${last}`;
    for (const [path, dial] of this.#dials) dial.show(valueAt(params, path));
    for (const [key, dial] of this.#looks) dial.show(state[key]);
  }

  remove(): void {
    this.#host.replaceChildren();
  }
}

function named(options: readonly string[]): [string, string][] {
  return options.map((option) => [option, nameOf(option)]);
}

/** All parameters but the main ones, by group. */
function groups(main: readonly string[]): [group: string, members: Parameter[]][] {
  const others = parameters.filter(({ path }) => !main.includes(path));
  const names = [...new Set(others.map(({ path }) => groupAndField(path)[0]))];
  return names.map((group) => [group, others.filter(({ path }) => groupAndField(path)[0] === group)]);
}

function icon(path: string): SVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const stroke = document.createElementNS("http://www.w3.org/2000/svg", "path");
  stroke.setAttribute("d", path);
  svg.append(stroke);
  return svg;
}
