/** The presets: plants worth looking at. */
import { html, nothing, type TemplateResult } from "lit";
import { presets } from "../params/declaration.ts";
import { sameParams } from "../params/params.ts";
import { icon } from "./icons.ts";
import type { Actions, Model } from "./model.ts";

/** Title of the plant that belongs to no preset. */
export const ownTitle = "A branch to begin with";

/** The plate that is shown, with what to see on it, and the others to choose from. */
export function gallery({ state, baseline }: Model, actions: Actions): TemplateResult {
  const preset = state.preset === null ? undefined : presets[state.preset];
  const title = preset?.title ?? ownTitle;
  const note = preset?.note ?? "Change a value and watch the branch answer, or begin with one of the plates.";
  const isChanged = !sameParams(state.params, baseline);
  return html`<section class="gallery" aria-labelledby="plate-title">
    <div class="plate-head">
      <p class="plate-name">${plateName(state.preset)}${isChanged ? ", changed" : ""}</p>
      ${isChanged ? html`<button type="button" @click=${actions.resetAll}>Reset all</button>` : nothing}
      <button type="button" aria-haspopup="dialog" @click=${actions.showGallery}>All plates</button>
    </div>
    <h2 id="plate-title">${title}</h2>
    <p class="note">${note}</p>
    <ul class="plates" aria-label="Plates">
      ${card(null, ownTitle, state.preset, actions.choosePreset)}
      ${Object.entries(presets).map(([id, { title }]) => card(id, title, state.preset, actions.choosePreset))}
    </ul>
  </section>`;
}

/** Brings the plate that is shown into view in its strip. */
export function revealPlate(root: HTMLElement): void {
  const plate = root.querySelector<HTMLElement>(".plate[aria-pressed=true]");
  const strip = plate?.closest("ul");
  if (plate && strip) strip.scrollLeft = plate.offsetLeft - strip.offsetLeft - 0.3 * strip.clientWidth;
}

/** A plate to choose: its picture, its name and its title. */
export function card(
  id: string | null,
  title: string,
  present: string | null,
  choose: (id: string | null) => void,
): TemplateResult {
  return html`<li>
    <button type="button" class="plate" title=${title} aria-pressed=${id === present} @click=${() => choose(id)}>
      <span class="thumbnail">${id === null ? icon("branch") : thumbnail(id)}</span>
      <span class="plate-name">${plateName(id)}</span> <span class="plate-title">${title}</span>
    </button>
  </li>`;
}

/** Beside its title the picture says nothing new to those who do not see it: hence the empty text. */
function thumbnail(id: string): TemplateResult {
  const hide = ({ target }: Event) => (target as HTMLElement).remove();
  return html`<img src="presets/${id}.webp" alt="" width="160" height="120" loading="lazy" decoding="async" @error=${hide} />`;
}

/** "figure-8a" is "Figure 8 a". */
function plateName(id: string | null): string {
  if (id === null) return "Default";
  const [, number, letter] = /^figure-(\d+)(\w*)$/.exec(id) ?? [];
  return number === undefined ? "Plate" : `Figure ${number} ${letter ?? ""}`.trim();
}
