/** A force as an arrow over the picture, with its size in words. */
import type { Vector } from "../geometry/bounds.ts";
import { forceText } from "../geometry/quantity.ts";
import type { Place } from "./annotation.ts";

/** A force on the plant. */
export interface Force {
  /** Where it pulls, m. */
  readonly at: Vector;
  /** N */
  readonly force: Vector;
}

const svg = "http://www.w3.org/2000/svg";
const head = 9;
/** Room for the words beside the arrow's head. px */
const room = { across: 62, up: 16 };

/** A group `force` for the annotation, of a path and a text. */
export class ForceArrow {
  readonly element = document.createElementNS(svg, "g");
  readonly #arrow = document.createElementNS(svg, "path");
  readonly #text = document.createElementNS(svg, "text");

  constructor() {
    this.element.setAttribute("class", "force");
    this.#text.setAttribute("text-anchor", "middle");
    this.#text.setAttribute("dominant-baseline", "middle");
    this.element.append(this.#arrow, this.#text);
  }

  /** Draws the force; none is nothing. `unit` is a length in m that is easily seen. */
  draw(
    what: Force | null,
    project: (point: Vector) => Place,
    unit: number,
    picture: { width: number; height: number },
  ): void {
    const size = what ? Math.hypot(...what.force) : 0;
    this.element.style.display = size > 0 ? "" : "none";
    if (!what || !(size > 0)) return;
    const [from, along] = [project(what.at), towards(what, size, unit, project)];
    const length = lengthOf(size);
    const to = { x: from.x + length * along.x, y: from.y + length * along.y };
    const barb = (side: number) => {
      const [back, across] = [-head, 0.5 * head * side];
      return `${point({ x: to.x + back * along.x - across * along.y, y: to.y + back * along.y + across * along.x })}`;
    };
    this.#arrow.setAttribute("d", `M${point(from)}L${point(to)}M${barb(1)}L${point(to)}L${barb(-1)}`);
    const beside = { x: to.x + along.x * room.across, y: to.y + along.y * room.up };
    this.#text.setAttribute("x", clamp(beside.x, room.across, picture.width).toFixed(1));
    this.#text.setAttribute("y", clamp(beside.y, room.up, picture.height).toFixed(1));
    this.#text.textContent = forceText(size);
  }
}

/** Direction of a force on the picture; one that points at the viewer has none, and is drawn upwards. */
function towards({ at, force }: Force, size: number, unit: number, project: (point: Vector) => Place): Place {
  const reach = unit / size;
  const from = project(at);
  const to = project([at[0] + reach * force[0], at[1] + reach * force[1], at[2] + reach * force[2]]);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  return length > 1e-9 ? { x: (to.x - from.x) / length, y: (to.y - from.y) / length } : { x: 0, y: -1 };
}

/** Longer for larger forces, px: 26 more for each ten times as much. What a hair bears and what breaks a bough both fit. */
function lengthOf(newtons: number): number {
  return Math.min(180, Math.max(28, 74 + 26 * Math.log10(newtons)));
}

function clamp(value: number, margin: number, size: number): number {
  return Math.min(Math.max(value, margin), Math.max(margin, size - margin));
}

function point({ x, y }: Place): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
