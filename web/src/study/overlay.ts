/** What a study draws over the picture. It follows the camera. */
import { render, type SVGTemplateResult, svg } from "lit";
import type { Stage } from "../scene/stage.ts";
import type { Project, Section } from "./desk.ts";

const namespace = "http://www.w3.org/2000/svg";

export class Overlay {
  readonly element = document.createElementNS(namespace, "svg");
  readonly #stage: Stage;
  readonly #sections: readonly Section[];
  #isDue = false;

  constructor(stage: Stage, sections: readonly Section[]) {
    this.#stage = stage;
    this.#sections = sections;
    this.element.setAttribute("class", "overlay");
    stage.canvas.parentElement?.append(this.element);
    stage.canvas.addEventListener("bough-drawn", () => this.#draw());
  }

  /** Draws anew, once for all changes of this task. */
  refresh(): void {
    if (this.#isDue) return;
    this.#isDue = true;
    queueMicrotask(() => this.#draw());
  }

  #draw(): void {
    this.#isDue = false;
    const project: Project = (point) => this.#stage.project(point);
    const { clientWidth, clientHeight } = this.#stage.canvas;
    render(
      svg`${this.#sections.map((section) => section.draw(project, clientWidth, clientHeight))}`,
      this.element as unknown as HTMLElement,
    );
  }
}

/** A broken line through points of the picture. */
export function lineThrough(
  places: readonly { x: number; y: number }[],
  className: string,
): SVGTemplateResult {
  const d = places.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");
  return svg`<path class=${className} d=${d === "" ? "" : `M${d}`} />`;
}
