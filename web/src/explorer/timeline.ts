/** The age: scrub it, step it, or watch the plant grow; and take the loads off. */
import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { slide } from "../form/slide.ts";
import { local } from "../language/number.ts";
import { say } from "../language/say.ts";
import { stepsOf } from "../params/params.ts";
import { type Speed, speeds } from "../scene/playback.ts";
import { type Icon, icon } from "./icons.ts";
import type { Actions, Model } from "./model.ts";

export function timeline({ state, plant, grown, plays, speed }: Model, actions: Actions): TemplateResult {
  const last = grown?.report.steps ?? stepsOf(state.params);
  // While it plays the age runs ahead of the state.
  const step = Math.min(last, plays ? (plant?.report.steps ?? last) : (state.step ?? last));
  const onSlide = slide((entered, how) => actions.change({ step: entered >= last ? null : entered }, how));
  const playLabel = plays ? say("Pause") : say("Watch it grow");
  return html`<div class="timeline" role="group" aria-label=${say("Age")}>
    <div class="transport">
      ${tool("back", say("One step younger"), () => actions.age(-1), step <= 1)}
      <button type="button" class="tool play" title=${playLabel} aria-label=${playLabel} @click=${actions.togglePlay}>
        ${icon(plays ? "pause" : "play")}
      </button>
      ${tool("forward", say("One step older"), () => actions.age(1), step >= last)}
    </div>
    <label for="age">${say("Age")}</label>
    <input
      id="age"
      type="range"
      min="1"
      max=${last}
      step="1"
      .value=${live(String(step))}
      aria-valuetext=${say("growth step {0} of {1}", step, last)}
      @input=${onSlide}
      @change=${onSlide}
      @pointerup=${onSlide}
      @keydown=${onSlide}
      @keyup=${onSlide}
      @blur=${onSlide}
    />
    <output for="age">${step} <span class="of">${say("of {0}", last)}</span></output>
    <select
      class="speed"
      aria-label=${say("Speed")}
      title=${say("Speed of the replay")}
      @change=${(event: Event) => actions.setSpeed(Number((event.target as HTMLSelectElement).value) as Speed)}
    >
      ${speeds.map((one) => html`<option value=${one} ?selected=${one === speed}>${local(String(one))}×</option>`)}
    </select>
    <button
      type="button"
      class="unload"
      role="switch"
      aria-checked=${state.params.loads.removed}
      aria-label=${say("Take the loads off")}
      title=${say("Take the loads off after growth, and see what stays bent")}
      @click=${actions.toggleLoads}
    >
      ${icon("loads")}<span>${say("Loads off")}</span>
    </button>
  </div>`;
}

function tool(name: Icon, label: string, act: () => void, disabled: boolean): TemplateResult {
  return html`<button type="button" class="tool step" title=${label} aria-label=${label} ?disabled=${disabled} @click=${act}>
    ${icon(name)}
  </button>`;
}
