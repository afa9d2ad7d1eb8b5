/** The force that holds the plant, in words, and how to let go. */
import { html, nothing, type TemplateResult } from "lit";
import { angle, placed } from "../element/description.ts";
import { quantityText } from "../form/quantity.ts";
import { forceText } from "../geometry/quantity.ts";
import { say } from "../language/say.ts";
import type { Actions, Model } from "./model.ts";
import type { Pull } from "./touch.ts";

/** "Held at the end of segment 40 by 0.32 N · 33 gf, 45° above the horizontal, at 1.2 m across, 40 cm up." */
export function pullSentence({ segment, force, at: [x, y] }: Pull): string {
  const [across, up, depth] = force;
  const elevation = (Math.atan2(up, Math.hypot(across, depth)) * 180) / Math.PI;
  const place = placed(quantityText(Math.abs(x), "m"), quantityText(Math.abs(y), "m"), y < 0);
  const size = forceText(Math.hypot(...force));
  return say(
    "Held at the end of segment {0} by {1}, pulling {2}; it is {3}.",
    segment + 1,
    size,
    angle(elevation),
    place,
  );
}

/** What is said beside the picture while the plant is held. */
export function pullNote({ pull, holds }: Model, actions: Actions): TemplateResult | typeof nothing {
  if (!holds) return nothing;
  const words = pull
    ? html`${say("Segment {0}", pull.segment + 1)} <data value=${pull.force.join()}>${forceText(Math.hypot(...pull.force))}</data>`
    : say("Held");
  return html`<div class="pull">
    <p>${words}</p>
    <button type="button" @click=${actions.toggleHold}>${say("Let go")}</button>
  </div>`;
}
