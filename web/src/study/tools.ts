/** A ruler and a protractor on the picture. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { angle } from "../element/description.ts";
import { numberText, quantityText } from "../form/quantity.ts";
import { measure } from "../geometry/measure.ts";
import type { Vector } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import type { Stage } from "../scene/stage.ts";
import type { Project } from "./desk.ts";
import { drawHandle, type Handle, placeText } from "./handle.ts";
import { lineThrough } from "./overlay.ts";
import { words } from "./words.ts";

export class Tools {
  readonly #onChange: () => void;
  /** Both ends, m. */
  #ruler: Vector[] | null = null;
  /** An arm's end, the corner, the other arm's end, m. */
  #protractor: Vector[] | null = null;

  constructor(onChange: () => void) {
    this.#onChange = onChange;
  }

  render(plant: Plant): TemplateResult {
    const toggle = (name: string, isOn: boolean, act: () => void) =>
      html`<button
        type="button"
        aria-pressed=${isOn}
        @click=${() => {
          act();
          this.#onChange();
        }}
      >
        ${name}
      </button>`;
    const { base, tip, length } = measure(plant);
    const end: Vector = [base[0] + tip[0], base[1] + tip[1], 0];
    const level: Vector = [base[0] + 0.4 * length, base[1], 0];
    return html`<p class="deeds">
        ${toggle(words.measure.ruler, this.#ruler !== null, () => {
          this.#ruler = this.#ruler ? null : [[base[0], base[1], 0], end];
        })}
        ${toggle(words.measure.protractor, this.#protractor !== null, () => {
          this.#protractor = this.#protractor ? null : [level, [base[0], base[1], 0], end];
        })}
      </p>
      <p class="measured" role="status">${this.#reading()}</p>
      ${this.#ruler || this.#protractor ? html`<p class="note">${words.measure.toolsNote}</p>` : nothing}`;
  }

  #reading(): string {
    const sentences: string[] = [];
    const [from, to] = this.#ruler ?? [];
    if (from && to) {
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const direction = angle((Math.atan2(dy, Math.abs(dx)) * 180) / Math.PI);
      sentences.push(words.measure.length(quantityText(Math.hypot(dx, dy), "m"), direction));
    }
    const [a, corner, b] = this.#protractor ?? [];
    if (a && corner && b) {
      const turn = Math.abs(directionOf(corner, b) - directionOf(corner, a));
      const between = Math.min(turn, 2 * Math.PI - turn);
      sentences.push(words.measure.angle(`${numberText((between * 180) / Math.PI)}°`));
    }
    return sentences.join(" ");
  }

  draw(stage: Stage, project: Project): SVGTemplateResult {
    const parts: SVGTemplateResult[] = [];
    for (const [points, isRuler] of [
      [this.#ruler, true],
      [this.#protractor, false],
    ] as const) {
      if (!points) continue;
      parts.push(lineThrough(points.map(project), isRuler ? "tool ruler" : "tool"));
      if (!isRuler) parts.push(arc(points.map(project)));
      points.forEach((at, index) => {
        const part = index === 1 ? words.measure.corner : words.measure.arm(index === 0 ? 1 : 2);
        const place = placeText(at);
        const handle: Handle = {
          at,
          kind: "tool",
          name: isRuler
            ? words.measure.rulerHandle(index + 1, place)
            : words.measure.protractorHandle(part, place),
          move: (to) => {
            points[index] = to;
            this.#onChange();
          },
        };
        parts.push(drawHandle(handle, stage, project));
      });
    }
    return svg`${parts}`;
  }
}

function directionOf(from: Vector, to: Vector): number {
  return Math.atan2(to[1] - from[1], to[0] - from[0]);
}

/** The arc between the arms, on the picture. */
function arc(places: readonly { x: number; y: number }[]): SVGTemplateResult {
  const [a, corner, b] = places;
  if (!a || !corner || !b) return svg``;
  const [from, to] = [a, b].map(({ x, y }) => Math.atan2(y - corner.y, x - corner.x)) as [number, number];
  const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  const radius =
    0.4 * Math.min(Math.hypot(a.x - corner.x, a.y - corner.y), Math.hypot(b.x - corner.x, b.y - corner.y));
  const points = Array.from({ length: 25 }, (_, k) => {
    const angle = from + (turn * k) / 24;
    return { x: corner.x + radius * Math.cos(angle), y: corner.y + radius * Math.sin(angle) };
  });
  return lineThrough(points, "tool arc");
}
