/** The state that an author wants, from what was written; or all that is wrong with it. */
import type { Engine } from "../engine/engine.ts";
import { parameters, presetNamed, presets } from "../params/declaration.ts";
import { examined } from "../params/examination.ts";
import type { Issue } from "../params/issue.ts";
import { read } from "../params/link.ts";
import { nearest } from "../params/nearest.ts";
import { type Params, stepsOf } from "../params/params.ts";
import { colors, initialState, presetState, type State, styles, themes, views } from "../params/state.ts";
import { described, shortened } from "../params/wording.ts";
import type { Attribute, Request } from "./request.ts";

/** What came of a request. */
export interface Wanted {
  readonly state: State;
  /** All that is wrong; then the state is not to be shown. */
  readonly issues: readonly Issue[];
  /** What was repaired in a link. */
  readonly notices: readonly string[];
}

/** What controls a widget can have. */
export const controlKinds = ["compact", "full", "none"] as const;

/** The paths in a list with spaces between them; null where there is no list. */
export function pathsIn(fields: string | null): string[] | null {
  return fields ? fields.trim().split(/\s+/) : null;
}

/** The state after a change of some attributes. What the others say counts again only where another preset is chosen. */
export async function wantedState(
  request: Request,
  changed: ReadonlySet<Attribute>,
  present: State,
  engine: Pick<Engine, "check">,
): Promise<Wanted> {
  const issues: Issue[] = [];
  const { state, notices } = start(request, changed, present, issues);
  const choose = <Name extends string>(
    attribute: Attribute,
    options: readonly Name[],
    now: Name,
    usual: Name,
  ) => {
    const text = request[attribute];
    if (!changed.has(attribute)) return now;
    if (typeof text === "string") return option(attribute, text, options, now, issues);
    return changed.has("link") ? now : usual;
  };
  const looks = {
    view: choose("view", views, state.view, initialState.view),
    color: choose("color", colors, state.color, initialState.color),
    style: choose("drawing", styles, state.style, initialState.style),
    theme: choose("theme", themes, state.theme, initialState.theme),
  };
  choose("controls", controlKinds, "compact", "compact");
  if (changed.has("fields")) {
    const paths = parameters.map(({ path }) => path);
    for (const path of pathsIn(request.fields) ?? []) option("fields", path, paths, "", issues);
  }
  let { params } = state;
  if ((changed.has("params") || changed.has("preset")) && request.params !== null) {
    const merged = over(params, request.params, issues);
    issues.push(...(await engine.check(merged)));
    params = examined(merged).params;
  }
  const heedsStep = changed.has("step") || changed.has("preset");
  // Without an attribute the age is the preset's own.
  const usual = changed.has("step") && !changed.has("link") ? presetState(state.preset).step : state.step;
  const step = stepOf(heedsStep ? request.step : null, usual, params, issues);
  return { state: { ...state, ...looks, params, step }, issues, notices };
}

/** What the changes start from: the link, the preset, or what there is; params are always given relative to a preset. */
function start(
  { link, preset }: Request,
  changed: ReadonlySet<Attribute>,
  present: State,
  issues: Issue[],
): { state: State; notices: readonly string[] } {
  const isLinked = changed.has("link") && link !== null;
  if (isLinked && !(changed.has("preset") && preset)) {
    const { state, notices } = read(link.replace(/^[^?]*\?/, "").replace(/#.*/, ""));
    return { state, notices: notices.map(({ message }) => message) };
  }
  if (changed.has("preset")) {
    if (preset && !presetNamed(preset)) issues.push(noPreset(preset));
    return { state: { ...present, ...presetState(preset || null) }, notices: [] };
  }
  const isOther = changed.has("params");
  const { params } = isOther ? presetState(present.preset) : present;
  return { state: { ...present, params }, notices: [] };
}

function noPreset(preset: string): Issue {
  const near = nearest(preset, Object.keys(presets));
  const hint = near ? `did you mean ${near}?` : `there are ${Object.keys(presets).join(", ")}.`;
  const message = `There is no preset ${shortened(preset)}; ${hint}`;
  return { code: "notAnOption", path: "preset", value: preset, message };
}

/** Given params over those they start from. What is no object is left as it is, for the check to say so. */
function over(base: Params, given: unknown, issues: Issue[]): unknown {
  try {
    const read: unknown = typeof given === "string" ? JSON.parse(given) : given;
    if (!isObject(read)) return read;
    const merged: Record<string, unknown> = { ...base };
    for (const [group, content] of Object.entries(read)) {
      const old = merged[group];
      merged[group] = isObject(content) && isObject(old) ? { ...old, ...content } : content;
    }
    return merged;
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    const message = `params is no JSON: ${shortened(reason)}`;
    issues.push({ code: "unreadable", path: "params", value: given, message });
    return base;
  }
}

function isObject(value: unknown): value is Record<string, unknown> {
  return Object.prototype.toString.call(value) === "[object Object]";
}

function option<Name extends string>(
  path: string,
  text: string,
  options: readonly Name[],
  fallback: Name,
  issues: Issue[],
): Name {
  const known = options.find((one) => one === text);
  if (known) return known;
  const message = `${path} must be one of ${options.join(", ")}; it is ${described(text)}.`;
  issues.push({ code: "notAnOption", path, value: text, message });
  return fallback;
}

function stepOf(
  text: string | null,
  fallback: number | null,
  params: Params,
  issues: Issue[],
): number | null {
  const max = stepsOf(params);
  if (text === null) return fallback === null ? null : Math.min(fallback, max);
  if (text === "full") return null;
  const step = Number(text);
  if (text.trim() !== "" && Number.isInteger(step) && step >= 1) return step >= max ? null : step;
  const message = `step must be a whole number from 1 to ${max}, or full; it is ${described(text)}.`;
  issues.push({ code: "outOfRange", path: "step", value: text, message, min: 1, max });
  return fallback;
}
