/**
 * The state as a link: `?v=1&preset=figure-8a&g=3` holds what differs from the preset, or from the defaults, under
 * the parameters' short keys. Reading repairs what is damaged and says so; it never throws. What the core alone
 * knows (combinations that the model does not have) is left to the core.
 */
import { type Parameter, parameters, presetNamed } from "./declaration.ts";
import { type Params, sameValue, stepsOf, valueAt, withValue } from "./params.ts";
import { colors, initialState, languages, presetState, type State, styles, themes, views } from "./state.ts";
import { numberIn, parsed, written } from "./text.ts";
import { shortened, shown, wanted } from "./wording.ts";

/** Version of the table of defaults and presets that links refer to. A released table never changes. */
export const LINK_VERSION = 1;

/** Keys that no parameter may take. Those that are not read here belong to the page around. */
export const reservedKeys: readonly string[] = "v preset step view color style theme lang ui pin".split(" ");

/** Something in a link that was not taken as it stands. */
export interface Notice {
  code: "version" | "unknownKey" | "unknownPreset" | "repeated" | "unreadable" | "outOfRange" | "notInteger";
  /** The link's key, or keys. */
  key: string;
  /** What the link said. */
  value: string;
  /** A sentence on what was done about it. */
  message: string;
}

/** The link's query, from the question mark on. */
export function write(state: State): string {
  const base = presetState(state.preset);
  const entries = [["v", String(LINK_VERSION)]];
  if (base.preset !== null) entries.push(["preset", base.preset]);
  for (const { key, path } of parameters) {
    const value = valueAt(state.params, path);
    if (!sameValue(value, valueAt(base.params, path))) entries.push([key, written(value)]);
  }
  if (state.step !== base.step) entries.push(["step", state.step === null ? FULL_GROWN : String(state.step)]);
  if (state.view !== initialState.view) entries.push(["view", state.view]);
  if (state.color !== initialState.color) entries.push(["color", state.color]);
  if (state.style !== initialState.style) entries.push(["style", state.style]);
  if (state.theme !== initialState.theme) entries.push(["theme", state.theme]);
  if (state.lang !== initialState.lang) entries.push(["lang", state.lang]);
  // None of this needs percent-encoding: numbers, commas, and names of our own.
  return `?${entries.map((entry) => entry.join("=")).join("&")}`;
}

/** The `step` of a plant that is full grown, where the preset says otherwise. */
const FULL_GROWN = "full";

/** The state that a query stands for, with or without its question mark, and what had to be repaired. */
export function read(query: string): { state: State; notices: Notice[] } {
  const notices: Notice[] = [];
  const given = entriesOf(query, notices);
  checkVersion(given.get("v"), notices);
  const base = presetState(presetOf(given.get("preset"), notices));
  let params = base.params;
  for (const parameter of parameters) {
    const text = given.get(parameter.key);
    if (text !== undefined) params = withText(params, parameter, text, notices);
  }
  return {
    state: {
      ...base,
      params,
      step: stepOf(given.get("step"), base.step, params, notices),
      view: nameOf("view", given, views, initialState.view, notices),
      color: nameOf("color", given, colors, initialState.color, notices),
      style: nameOf("style", given, styles, initialState.style, notices),
      theme: nameOf("theme", given, themes, initialState.theme, notices),
      lang: nameOf("lang", given, languages, initialState.lang, notices),
    },
    notices,
  };
}

/** What the link says by key; of a repeated key the last, as if each change had been added at the end. */
function entriesOf(query: string, notices: Notice[]): Map<string, string> {
  const known = new Set([...reservedKeys, ...parameters.map(({ key }) => key)]);
  const unknown = new Set<string>();
  const repeated = new Set<string>();
  const given = new Map<string, string>();
  for (const [key, value] of new URLSearchParams(query)) {
    if (!known.has(key)) unknown.add(key);
    else if (given.has(key)) repeated.add(key);
    if (known.has(key)) given.set(key, value);
  }
  if (unknown.size > 0) {
    const key = shortened([...unknown].join(", "));
    const message = `The link's ${key} means nothing here and is ignored.`;
    notices.push({ code: "unknownKey", key, value: "", message });
  }
  for (const key of repeated) {
    const value = given.get(key) ?? "";
    const message = `The link gives ${key} more than once; the last one, ${shortened(value)}, is taken.`;
    notices.push({ code: "repeated", key, value, message });
  }
  return given;
}

/** A link without a version was written by hand. */
function checkVersion(value: string | undefined, notices: Notice[]): void {
  if (value === undefined || value === String(LINK_VERSION)) return;
  const message = `The link is of version ${shortened(value)}, which is not known here; it is read as version ${LINK_VERSION}.`;
  notices.push({ code: "version", key: "v", value, message });
}

function presetOf(value: string | undefined, notices: Notice[]): string | null {
  if (value === undefined || presetNamed(value)) return value ?? null;
  const message = `There is no preset ${shortened(value)}; the default plant is taken instead.`;
  notices.push({ code: "unknownPreset", key: "preset", value, message });
  return null;
}

function stepOf(text: string | undefined, preset: number | null, params: Params, notices: Notice[]) {
  const last = stepsOf(params);
  const fallback = preset === null ? null : Math.min(preset, last);
  if (text === undefined) return fallback;
  if (text === FULL_GROWN) return null;
  const { value = fallback, code } = numberIn(text, 1, last, true);
  if (code) {
    const used = value === null ? "the full-grown plant" : `step ${value}`;
    const message = `step is "${shortened(text)}" in the link; it must be a whole number from 1 to ${last}, so ${used} is shown.`;
    notices.push({ code, key: "step", value: text, message });
  }
  return value;
}

function nameOf<Name extends string>(
  key: string,
  given: ReadonlyMap<string, string>,
  names: readonly Name[],
  fallback: Name,
  notices: Notice[],
): Name {
  const text = given.get(key);
  const name = names.find((candidate) => candidate === text);
  if (text === undefined || name !== undefined) return name ?? fallback;
  const message = `${key} is "${shortened(text)}" in the link; it must be one of ${names.join(", ")}, so ${fallback} is taken.`;
  notices.push({ code: "unreadable", key, value: text, message });
  return fallback;
}

/** The params with one parameter as the link has it, as far as it can be read. */
function withText(params: Params, parameter: Parameter, text: string, notices: Notice[]): Params {
  const { key, path } = parameter;
  const { value = valueAt(params, path), code } = parsed(parameter, text);
  if (code) {
    const used = typeof value === "number" ? shown(value) : String(value);
    const message = `${path} is "${shortened(text)}" in the link; it must be ${wanted(parameter)}, so ${used} is taken.`;
    notices.push({ code, key, value: text, message });
  }
  return withValue(params, path, value);
}
