/** A point on the picture that can be dragged, or moved by keys. */
import { type SVGTemplateResult, svg } from "lit";
import { quantityText } from "../form/quantity.ts";
import type { Vector } from "../params/declaration.ts";
import type { Stage } from "../scene/stage.ts";
import type { Project } from "./desk.ts";
import { words } from "./words.ts";

/** A handle. */
export interface Handle {
  /** m, in the plane of the picture. */
  readonly at: Vector;
  readonly name: string;
  readonly kind: "tool" | "trace";
  move(to: Vector): void;
  remove?(): void;
}

/** A key moves it by so many px, with Shift by ten times that. */
const stride = 1;

/** Draws it, and lets it be moved. */
export function drawHandle(handle: Handle, stage: Stage, project: Project): SVGTemplateResult {
  const { x, y } = project(handle.at);
  const drag = (event: PointerEvent) => {
    const target = event.currentTarget as Element;
    if (event.type === "pointerdown") {
      event.preventDefault();
      target.setPointerCapture(event.pointerId);
      (target as SVGGElement).focus({ preventScroll: true });
    } else if (target.hasPointerCapture(event.pointerId)) {
      handle.move([...stage.unproject(event.clientX, event.clientY, handle.at)]);
    }
  };
  const key = (event: KeyboardEvent) => {
    if (handle.remove && (event.key === "Delete" || event.key === "Backspace")) {
      event.preventDefault();
      handle.remove();
      return;
    }
    const [dx, dy] =
      { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [];
    if (dx === undefined || dy === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const { left, top } = stage.canvas.getBoundingClientRect();
    const far = stride * (event.shiftKey ? 10 : 1);
    handle.move([...stage.unproject(left + x + far * dx, top + y + far * dy, handle.at)]);
  };
  return svg`<g
    class="handle ${handle.kind}"
    tabindex="0"
    role="button"
    aria-label=${handle.name}
    transform="translate(${x.toFixed(2)} ${y.toFixed(2)})"
    @pointerdown=${drag}
    @pointermove=${drag}
    @keydown=${key}
  ><circle class="reach" r=${handle.kind === "tool" ? 16 : 9} /><circle r=${handle.kind === "tool" ? 7 : 4} /></g>`;
}

/** Where a point is, in words. */
export function placeText([x, y]: Vector): string {
  const text = (value: number) => quantityText(value, "m").replace("-", "−");
  return words.measure.place(text(x), text(y));
}
