/** What can be measured on the plant. */
import { html, nothing, type TemplateResult } from "lit";
import { angle, gravitySentence, placed, solverSentence, strengthSentence } from "../element/description.ts";
import { quantityText } from "../form/quantity.ts";
import { measure } from "../geometry/measure.ts";
import { say } from "../language/say.ts";
import { isBroken } from "../plant/plant.ts";
import type { Model } from "./model.ts";

export function readout({ plant, pull }: Model): TemplateResult | typeof nothing {
  if (!plant) return nothing;
  const { tip, length, tipElevation } = measure(plant);
  const { report } = plant;
  // What is a millionth of the axis is round-off.
  const place = (value: number) =>
    quantityText(Math.abs(value) < 1e-6 * length ? 0 : value, "m").replace("-", "−");
  const strength = strengthSentence(plant);
  const sound = report.status === "converged" && (report.stable !== false || pull !== null);
  return html`<section class="readout" aria-labelledby="readout-title">
    <h2 id="readout-title">${say("Measured")}</h2>
    <dl>
      <div><dt>${say("Length")}</dt><dd>${quantityText(length, "m")}</dd></div>
      <div>
        <dt>${say("Tip")}</dt>
        <dd>${placed(place(tip[0]), place(Math.abs(tip[1])), tip[1] < 0)} <small>${say("pointing {0}", angle(tipElevation))}</small></dd>
      </div>
      <div>
        <dt><abbr title=${say("weight times length squared over bending stiffness, at the base")}>${say("Gravity number")}</abbr> <i class="symbol">q</i></dt>
        <dd>${quantityText(report.gravityNumber, "")} <small>${gravitySentence(report.gravityNumber)}</small></dd>
      </div>
      ${strength === "" ? nothing : html`<div class=${isBroken(report) ? "unsound" : ""}><dt>${say("Strength")}</dt><dd>${strength}</dd></div>`}
      <div class=${sound ? "" : "unsound"}>
        <dt>${say("Solution")}</dt>
        <dd>${!pull || report.stable !== false ? solverSentence(report) : say("In equilibrium while it is held; the same force as a load would make it snap through.")}</dd>
      </div>
    </dl>
  </section>`;
}
