/** The key to the colours of the plant. */
import { html, nothing, svg, type TemplateResult } from "lit";
import { legend as legendOf } from "../geometry/legend.ts";
import { say } from "../language/say.ts";
import type { Model } from "./model.ts";

/** A colour scale with its numbers, in real units; nothing while the plant wears its bark. */
export function legend({ plant, grown, state: { color } }: Model): TemplateResult | typeof nothing {
  const key = plant && legendOf(plant, color, grown ?? plant);
  if (!key) return nothing;
  const { title, unit, stops, ticks } = key;
  const percent = (offset: number) => `${(100 * offset).toFixed(2)}%`;
  const said = say("Colour scale from {0} to {1} {2}", ticks[0]?.text ?? "", ticks.at(-1)?.text ?? "", unit);
  return html`<figure class="legend">
    <figcaption>${title} <span class="unit">${unit}</span></figcaption>
    <svg role="img" aria-label=${said}>
      <linearGradient id="legend-colors">
        ${stops.map(({ offset, css }) => svg`<stop offset=${offset} stop-color=${css} />`)}
      </linearGradient>
      <rect width="100%" height="10" rx="3" fill="url(#legend-colors)" />
      ${ticks.map(
        ({ offset, text }) => svg`<line x1=${percent(offset)} x2=${percent(offset)} y1="10" y2="14" />
        <text class="tick" x=${percent(offset)} y="27" text-anchor=${anchorOf(offset)}>${text}</text>`,
      )}
    </svg>
  </figure>`;
}

/** Numbers at the ends stay inside. */
function anchorOf(offset: number): string {
  return offset < 0.05 ? "start" : offset > 0.95 ? "end" : "middle";
}
