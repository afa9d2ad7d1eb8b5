/** The text that puts a plant into another page. No DOM. */
import { groupAndField, parameters } from "../params/declaration.ts";
import { write } from "../params/link.ts";
import { sameValue, valueAt } from "../params/params.ts";
import { initialState, presetState, type State } from "../params/state.ts";

/** A frame for pages that take no scripts, as those of an LMS; or the element, for one's own page. */
export type Form = "iframe" | "element";
/** How much of the page comes along. */
export const controls = ["full", "compact", "none"] as const;

/** How a plant is to stand in another page. */
export interface Wishes {
  readonly form: Form;
  /** CSS px. */
  readonly width: number;
  readonly height: number;
  readonly theme: State["theme"];
  readonly controls: (typeof controls)[number];
  /** Whether the element shows a picture file until it is touched. */
  readonly poster: boolean;
  /** What it is called, for those who do not see it. */
  readonly title: string;
}

/** Name of the picture file that the element's snippet expects beside it. */
export const posterFile = "plant.webp";

/** The page for frames, showing a state. `site` is the address of the explorer. */
export function frameAddress(state: State, site: string, { theme, controls }: Wishes): string {
  return new URL(`embed.html${write({ ...state, theme })}&ui=${controls}`, site).href;
}

/** The snippet, as HTML. */
export function snippet(state: State, site: string, wishes: Wishes): string {
  return wishes.form === "iframe" ? frame(state, site, wishes) : element(state, site, wishes);
}

/** What hosts leave in place: no script, no style, and under it a link for those that take the frame out all the same. */
function frame(state: State, site: string, wishes: Wishes): string {
  const { width, height, title } = wishes;
  const src = attribute("src", frameAddress(state, site, wishes));
  const size = `${attribute("width", `${width}`)} ${attribute("height", `${height}`)}`;
  const link = attribute("href", new URL(write(state), site).href);
  return [
    `<iframe ${src} ${size} ${attribute("title", title)} allowfullscreen loading="lazy"></iframe>`,
    `<p><a ${link}>${escaped(title)}</a></p>`,
  ].join("\n");
}

function element(state: State, site: string, wishes: Wishes): string {
  const changes = changesOf(state);
  const given: readonly (readonly [name: string, value: string | null])[] = [
    ["preset", state.preset],
    ["params", changes === "{}" ? null : changes],
    ["step", state.step === presetState(state.preset).step ? null : String(state.step ?? "full")],
    ["view", state.view === initialState.view ? null : state.view],
    ["color", state.color === initialState.color ? null : state.color],
    ["drawing", state.style === initialState.style ? null : state.style],
    ["controls", wishes.controls],
    ["theme", wishes.theme],
    ["poster", wishes.poster ? posterFile : null],
    // A poster is what is seen until somebody asks for the plant.
    ["loading", wishes.poster ? "click" : null],
    ["alt", wishes.title],
    ["style", `display: block; width: ${wishes.width}px; max-width: 100%; height: ${wishes.height}px`],
  ];
  const attributes = given.flatMap(([name, value]) => (value === null ? [] : [attribute(name, value)]));
  return [
    `<script async ${attribute("src", new URL("bough-widget.js", site).href)}></script>`,
    `<bough-plant ${attributes.join(" ")}></bough-plant>`,
  ].join("\n");
}

/** What differs from the preset, or from the defaults, as JSON of params. */
function changesOf({ preset, params }: State): string {
  const base = presetState(preset).params;
  const changes: Record<string, Record<string, unknown>> = {};
  for (const { path } of parameters) {
    const value = valueAt(params, path);
    if (sameValue(value, valueAt(base, path))) continue;
    const [group, field] = groupAndField(path);
    changes[group] = { ...changes[group], [field]: value };
  }
  return JSON.stringify(changes);
}

/** In the quotes that leave the value readable. */
function attribute(name: string, value: string): string {
  const quote = value.includes('"') && !value.includes("'") ? "'" : '"';
  return `${name}=${quote}${escaped(value, quote)}${quote}`;
}

function escaped(text: string, quote = '"'): string {
  const names: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;" };
  return text
    .replace(/[&<>]/g, (sign) => names[sign] ?? sign)
    .replaceAll(quote, quote === '"' ? "&quot;" : "&#39;");
}
