/** How the plant is looked at: what its colour means, how it is drawn, from where. */
import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { say } from "../language/say.ts";
import { colors, type State, styles, views } from "../params/state.ts";
import type { Actions, Model } from "./model.ts";

const colorNames: Readonly<Record<State["color"], () => string>> = {
  bark: () => say("Bark"),
  moment: () => say("Moment"),
  stress: () => say("Stress"),
  curvature: () => say("Curvature"),
  age: () => say("Age"),
};
const styleNames: Readonly<Record<State["style"], () => string>> = {
  limb: () => say("Limbs"),
  bare: () => say("Bare"),
  model: () => say("Model"),
};
const viewNames: Readonly<Record<State["view"], () => string>> = {
  plane: () => say("Plane"),
  space: () => say("Space"),
};

export function look({ state }: Model, actions: Actions): TemplateResult {
  const changeColor = (event: Event) =>
    actions.change({ color: (event.target as HTMLSelectElement).value as State["color"] });
  return html`<div class="look">
    <label class="color"
      ><span>${say("Colour")}</span>
      <select .value=${live(state.color)} @change=${changeColor}>
        ${colors.map((color) => html`<option value=${color} ?selected=${color === state.color}>${colorNames[color]()}</option>`)}
      </select></label
    >
    ${choice(say("Style"), "style", stylesOf(state), state.style, styleNames, (style) => actions.change({ style }))}
    ${choice(say("View"), "view", views, state.view, viewNames, (view) => actions.change({ view }))}
  </div>`;
}

/** Bare is for plants that bear something. */
function stylesOf({ params, style }: State): State["style"][] {
  const { foliage, tipMass } = params.loads;
  return styles.filter((name) => name !== "bare" || style === "bare" || foliage > 0 || tipMass > 0);
}

function choice<Name extends string>(
  legend: string,
  group: string,
  options: readonly Name[],
  present: Name,
  names: Readonly<Record<Name, () => string>>,
  choose: (name: Name) => void,
): TemplateResult {
  return html`<fieldset class="switch">
    <legend class="visually-hidden">${legend}</legend>
    ${options.map(
      (option) => html`<label
        ><input type="radio" name=${group} .checked=${live(option === present)} @change=${() => choose(option)} /><span
          >${names[option]()}</span
        ></label
      >`,
    )}
  </fieldset>`;
}
