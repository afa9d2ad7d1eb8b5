/** The head of the page: its name, and what concerns everything. */
import { html, type TemplateResult } from "lit";
import { type Icon, icon } from "./icons.ts";
import type { Actions, Model } from "./model.ts";

export function masthead({ state, canUndo, canRedo }: Model, actions: Actions): TemplateResult {
  return html`<header class="masthead">
    <h1>Bough</h1>
    <p class="tagline">How branches bend as they grow</p>
    <div class="actions">
      ${button("undo", "Undo", actions.undo, !canUndo)} ${button("redo", "Redo", actions.redo, !canRedo)}
      ${button("keys", "Keys", actions.showKeys)} ${button("link", "Copy link", actions.copyLink)}
      ${button("embed", "Embed", actions.showEmbed)}
      <a class="tool" href="course/index.html" title="Course" aria-label="Course">${icon("course")}</a>
      ${button(state.theme, `Theme: ${state.theme}`, () => actions.next("theme"))}
    </div>
  </header>`;
}

function button(name: Icon, label: string, act: () => void, disabled = false): TemplateResult {
  return html`<button type="button" class="tool" title=${label} aria-label=${label} ?disabled=${disabled} @click=${act}>
    ${icon(name)}
  </button>`;
}
