/** The head of the page: its name, and what concerns everything. */
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { ownNames } from "../language/load.ts";
import { say } from "../language/say.ts";
import { languages, type State } from "../params/state.ts";
import { type Icon, icon } from "./icons.ts";
import type { Actions, Model } from "./model.ts";

/** A page that is a file cannot be put into another one. */
const isFile = location.protocol === "file:";

export function masthead({ state, canUndo, canRedo }: Model, actions: Actions): TemplateResult {
  return html`<header class="masthead">
    <h1>Bough</h1>
    <p class="tagline">${say("How branches bend as they grow")}</p>
    <div class="actions">
      ${button("undo", say("Undo"), actions.undo, !canUndo)} ${button("redo", say("Redo"), actions.redo, !canRedo)}
      ${button("keys", say("Keys"), actions.showKeys)} ${button("link", say("Copy link"), actions.copyLink)}
      ${button("save", say("Take it away"), actions.showTakeAway)}
      ${isFile ? nothing : button("embed", say("Embed"), actions.showEmbed)}
      ${isFile ? nothing : html`<a class="tool" href="course/index.html" title=${say("Course")} aria-label=${say("Course")}>${icon("course")}</a>`}
      ${button(state.theme, say("Theme: {0}", say(state.theme)), () => actions.next("theme"))} ${tongues(state.lang, actions)}
    </div>
  </header>`;
}

function tongues(present: State["lang"], actions: Actions): TemplateResult {
  const change = (event: Event) =>
    actions.change({ lang: (event.target as HTMLSelectElement).value as State["lang"] });
  return html`<label class="tool tongues" title=${say("Language")}
    >${icon("language")}<select aria-label=${say("Language")} .value=${live(present)} @change=${change}>
      ${languages.map(
        (one) =>
          html`<option value=${one} lang=${one === "auto" ? nothing : one} ?selected=${one === present}>
            ${one === "auto" ? say("auto") : ownNames[one]}
          </option>`,
      )}
    </select></label
  >`;
}

function button(name: Icon, label: string, act: () => void, disabled = false): TemplateResult {
  return html`<button type="button" class="tool" title=${label} aria-label=${label} ?disabled=${disabled} @click=${act}>
    ${icon(name)}
  </button>`;
}
