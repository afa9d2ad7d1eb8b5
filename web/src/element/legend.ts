/** The key to the colours of the plant. */
import { legend as legendOf } from "../geometry/legend.ts";
import type { Color } from "../geometry/shade.ts";
import type { Plant } from "../plant/plant.ts";
import { element } from "./face.ts";
import { sheetOf } from "./style.ts";

const sheetText = `
.legend { position: absolute; left: 0.8rem; top: 0.7rem; width: 11rem; font-size: 0.8125rem; direction: ltr; pointer-events: none; }
.scale { height: 0.6rem; border-radius: 0.2rem; }
.ticks { position: relative; height: 1.2rem; font-variant-numeric: tabular-nums; }
.ticks span { position: absolute; translate: -50%; }
.ticks span:first-child { translate: 0; }
.ticks span:last-child { translate: -100%; }
`;

let sheet: CSSStyleSheet | undefined;

/** The style sheet of all legends. */
export function sheetOfLegends(): CSSStyleSheet {
  sheet ??= sheetOf(sheetText);
  return sheet;
}

/** Fills an element with the key to a plant's colours; hides it where they are the plant's own. */
export function showLegend(host: HTMLElement, plant: Plant, color: Color, grown: Plant): void {
  const key = legendOf(plant, color, grown);
  host.hidden = key === null;
  if (!key) return;
  const { title, unit, stops, ticks } = key;
  const said = `from ${ticks[0]?.text} to ${ticks.at(-1)?.text} ${unit}`;
  const scale = element("div", { class: "scale", role: "img", "aria-label": `Colour scale ${said}` });
  const colors = stops.map(({ offset, css }) => `${css} ${100 * offset}%`);
  scale.style.background = `linear-gradient(to right, ${colors.join()})`;
  const marks = ticks.map(({ offset, text }) => {
    const mark = element("span", {}, text);
    mark.style.left = `${100 * offset}%`;
    return mark;
  });
  host.replaceChildren(
    element("div", {}, `${title}, ${unit}`),
    scale,
    element("div", { class: "ticks", "aria-hidden": "true" }, ...marks),
  );
}
