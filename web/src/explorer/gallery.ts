/** The presets: plants worth looking at. */
import { html, nothing, type TemplateResult } from "lit";
import { presetWords } from "../form/words.ts";
import { say } from "../language/say.ts";
import { presets } from "../params/declaration.ts";
import { sameParams } from "../params/params.ts";
import type { Actions, Model } from "./model.ts";
import { makeStop, rove } from "./roving.ts";
import { thumbnailOf } from "./thumbnails.ts";

/** The title of a preset, or of the plant that belongs to none. */
export function titleOf(id: string | null): string {
  return id === null ? say("A branch to begin with") : presetWords(id)[0];
}

/** The plate that is shown, with what to see on it, and the others to choose from. */
export function gallery({ state, baseline }: Model, actions: Actions): TemplateResult {
  const note =
    state.preset === null
      ? say("Change a value and watch the branch answer, or begin with one of the plates.")
      : presetWords(state.preset)[1];
  const isChanged = !sameParams(state.params, baseline);
  return html`<section class="gallery" aria-labelledby="plate-title">
    <div class="plate-head">
      <p class="plate-name">${isChanged ? say("{0}, changed", plateName(state.preset)) : plateName(state.preset)}</p>
      ${isChanged ? html`<button type="button" @click=${actions.resetAll}>${say("Reset all")}</button>` : nothing}
      <button type="button" aria-haspopup="dialog" @click=${actions.showGallery}>${say("All plates")}</button>
    </div>
    <h2 id="plate-title">${titleOf(state.preset)}</h2>
    <p class="note">${note}</p>
    <ul class="plates" aria-label=${say("Plates")} @keydown=${rove} @focusin=${rove}>
      ${[null, ...Object.keys(presets)].map((id) => card(id, titleOf(id), state.preset, actions.choosePreset))}
    </ul>
  </section>`;
}

/** Brings the plate that is shown into view in its strip, and makes it the strip's stop for Tab. */
export function revealPlate(root: HTMLElement): void {
  const plate = root.querySelector<HTMLElement>(".plate[aria-pressed=true]");
  const strip = plate?.closest("ul");
  if (!plate || !strip) return;
  strip.scrollLeft = plate.offsetLeft - strip.offsetLeft - 0.3 * strip.clientWidth;
  makeStop(plate);
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
      <span class="thumbnail">${thumbnail(id)}</span>
      ${isOfPaper(id) ? html`<span class="plate-name">${plateName(id)}</span> <span class="plate-title">${title}</span>` : html`<span class="plate-name">${title}</span>`}
    </button>
  </li>`;
}

/** Beside its title the picture says nothing new to those who do not see it: hence the empty text. */
function thumbnail(id: string | null): TemplateResult {
  const hide = ({ target }: Event) => (target as HTMLElement).remove();
  return html`<img src=${thumbnailOf(id)} alt="" width="160" height="120" loading="lazy" decoding="async" @error=${hide} />`;
}

/** Plants one knows go by their own name. */
function isOfPaper(id: string | null): boolean {
  return id === null || id.startsWith("figure-");
}

/** "figure-8a" is "Figure 8 a"; what is not of the paper is a plant. */
function plateName(id: string | null): string {
  if (id === null) return say("Default");
  const [, number, letter] = /^figure-(\d+)(\w*)$/.exec(id) ?? [];
  return number === undefined ? say("Plant") : say("Figure {0}", `${number} ${letter ?? ""}`.trim());
}
