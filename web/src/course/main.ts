/** `course.js`: writes below each figure of the course what is read off it, as it changes. */
import type { PlantDetail } from "../element/element.ts";
import { readingText } from "./reading.ts";

for (const event of ["bough-ready", "bough-change"] as const) {
  document.addEventListener(event, ({ target, detail }: Event & { detail?: PlantDetail }) => {
    const line =
      target instanceof Element ? target.parentElement?.querySelector<HTMLElement>(".reading") : null;
    if (!line || !detail) return;
    line.textContent = readingText(detail.plant, (line.dataset.readings ?? "").split(" "));
    line.hidden = false;
  });
}
