/** The page as a whole, made anew from the model after every change; lit touches only what differs. */
import { html, nothing, type TemplateResult } from "lit";
import { groupForms, mainForm } from "../form/form.ts";
import { say } from "../language/say.ts";
import { gallery } from "./gallery.ts";
import { type Icon, icon } from "./icons.ts";
import { legend } from "./legend.ts";
import { look } from "./look.ts";
import { masthead } from "./masthead.ts";
import type { Actions, Model } from "./model.ts";
import { pullNote } from "./pull.ts";
import { readout } from "./readout.ts";
import { timeline } from "./timeline.ts";

export function page(model: Model, actions: Actions): TemplateResult {
  const skip = (event: Event) => {
    event.preventDefault();
    actions.showControls();
  };
  const form = { ...model, params: model.state.params };
  return html`<a class="skip" href="#controls" @click=${skip}>${say("Skip to the controls")}</a>
    ${masthead(model, actions)}
    <main>
      <section class="view" aria-label=${say("The plant")}>
        <div class="stage"></div>
        <p id="touch-hint" class="visually-hidden">
          ${say("Drag any point of the plant to pull at it, or press Enter to take hold of the tip and pull with the arrow keys.")}
        </p>
        ${look(model, actions)} ${legend(model)} ${viewTools(model, actions)} ${progress(model, actions)} ${notices(model, actions)}
        ${pullNote(model, actions)} ${timeline(model, actions)}
      </section>
      <div class="panel" id="controls" tabindex="-1">
        ${gallery(model, actions)}
        <section aria-labelledby="controls-title">
          <h2 id="controls-title" class="visually-hidden">${say("Controls")}</h2>
          ${mainForm(form)}
        </section>
        ${readout(model)}
        <div class="study"></div>
        <section class="groups" aria-labelledby="more-title">
          <h2 id="more-title">${say("More")}</h2>
          ${groupForms(form)}
        </section>
      </div>
    </main>
    <p class="visually-hidden" role="status">${model.announcement}</p>`;
}

function viewTools({ holds }: Model, actions: Actions): TemplateResult {
  const tool = (name: Icon, label: string, act: () => void) =>
    html`<button type="button" class="tool" title=${label} aria-label=${label} @click=${act}>${icon(name)}</button>`;
  return html`<div class="zoom">
    <button
      type="button"
      class="tool hold"
      aria-pressed=${holds}
      title=${say("Take hold of the tip (or drag any point of the plant)")}
      aria-label=${say("Take hold of the tip")}
      @click=${actions.toggleHold}
    >
      ${icon("hand")}
    </button>
    ${tool("farther", say("Zoom out"), () => actions.zoom(0.8))} ${tool("closer", say("Zoom in"), () => actions.zoom(1.25))}
    ${tool("fit", say("Show the whole plant"), actions.fit)}
  </div>`;
}

function progress({ progress }: Model, actions: Actions): TemplateResult | typeof nothing {
  if (progress === null) return nothing;
  return html`<div class="progress">
    <label>${say("Growing")} <progress max="1" .value=${progress}></progress></label>
    <button type="button" @click=${actions.cancel}>${say("Cancel")}</button>
  </div>`;
}

function notices({ notices }: Model, actions: Actions): TemplateResult {
  return html`<div class="notices" role="status">
    ${notices.map(
      (notice) => html`<p class="notice ${notice.tone}">
        ${notice.text}
        <button type="button" class="tool" aria-label=${say("Dismiss")} @click=${() => actions.dismiss(notice)}>${icon("close")}</button>
      </p>`,
    )}
  </div>`;
}
