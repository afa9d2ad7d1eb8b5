/** The form of all parameters, made from their declaration: a few at first sight, the others in groups. */
import { html, type TemplateResult } from "lit";
import { ref } from "lit/directives/ref.js";
import { say } from "../language/say.ts";
import { groupAndField, type Parameter, parameters } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import { type Params, sameValue, valueAt } from "../params/params.ts";
import { field } from "./field.ts";
import { nameOf } from "./words.ts";

/** What a person meets first. */
const main: readonly string[] = [
  "axis.elevation",
  "axis.segments",
  "axis.segmentLength",
  "axis.radius",
  "material.youngsModulus",
  "loads.gravity",
];

/** What the form shows. */
export interface FormModel {
  readonly params: Params;
  /** What resets bring back: the preset, or the defaults. */
  readonly baseline: Params;
  /** What is wrong with the last entries, by path. */
  readonly issues: ReadonlyMap<string, Issue>;
}

/** The main parameters. Entries are told by `bough-enter`. */
export function mainForm(model: FormModel): TemplateResult {
  const shown = main.flatMap((path) => parameters.filter((parameter) => parameter.path === path));
  return html`<div class="fields">${shown.map((parameter) => control(parameter, model))}</div>`;
}

/** All the others, in groups that can be opened. A group that holds an issue is open. */
export function groupForms(model: FormModel): TemplateResult {
  const others = parameters.filter(({ path }) => !main.includes(path));
  const groups = new Set(others.map(({ path }) => groupAndField(path)[0]));
  return html`${[...groups].map((group) => {
    const members = others.filter(({ path }) => groupAndField(path)[0] === group);
    const changed = members.filter(
      ({ path }) => !sameValue(valueAt(model.params, path), valueAt(model.baseline, path)),
    ).length;
    const wrong = members.some(({ path }) => model.issues.has(path));
    // Opened where something is wrong, but never closed under a person's hands.
    const open = (element?: Element) => {
      if (wrong && element instanceof HTMLDetailsElement) element.open = true;
    };
    return html`<details class="group" ${ref(open)}>
      <summary>${nameOf(group)}${changed > 0 ? html` <span class="changed">${say("{0} changed", changed)}</span>` : ""}</summary>
      <div class="fields">${members.map((parameter) => control(parameter, model))}</div>
    </details>`;
  })}`;
}

function control(parameter: Parameter, { params, baseline, issues }: FormModel): TemplateResult {
  const { path } = parameter;
  return field(parameter, valueAt(params, path), valueAt(baseline, path), issues.get(path));
}
