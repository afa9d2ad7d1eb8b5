/** Takes hold of the plant by pointer or keys. */
import { measure } from "../geometry/measure.ts";
import type { Vector } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import type { Stage } from "../scene/stage.ts";
import { endOf, type Touch } from "./touch.ts";

/** A pointer that moved less has clicked, not dragged. px */
const slack = 3;
/** A key moves the held point by this share of the axis's length; with Shift by a fifth of that. */
const stride = 0.02;

/** Above so many segments the pointer does not feel for limbs on its way, only when it is pressed. */
const mostFelt = 5000;

/** A pointer on a limb. */
interface Contact {
  readonly down: PointerEvent;
  readonly segment: number;
  /** Where it took hold, m: what it drags stays on the vertical plane through that. */
  readonly point: Vector;
  isDragging: boolean;
}

export class Hand {
  readonly #stage: Stage;
  readonly #touch: Touch;
  readonly #plant: () => Plant | null;
  #contact: Contact | null = null;

  constructor(stage: Stage, touch: Touch, plant: () => Plant | null) {
    this.#stage = stage;
    this.#touch = touch;
    this.#plant = plant;
    const { canvas } = stage;
    // Before the camera, which takes the same gestures where there is no limb.
    const early = { capture: true };
    canvas.addEventListener("pointerdown", (event) => this.#press(event), early);
    canvas.addEventListener("pointermove", (event) => this.#move(event), early);
    canvas.addEventListener("pointerup", (event) => this.#lift(event), early);
    canvas.addEventListener("pointercancel", (event) => this.#lift(event), early);
    canvas.addEventListener("keydown", (event) => this.#key(event), early);
    addEventListener("keydown", (event) => event.key === "Escape" && this.#cancel(), early);
  }

  #press(event: PointerEvent): void {
    if (!event.isTrusted) return;
    if (this.#contact) {
      this.#yield(event);
      return;
    }
    if (event.button !== 0 || !event.isPrimary || !this.#plant()) return;
    const found = this.#stage.pick(event.clientX, event.clientY);
    if (!found) return;
    event.stopImmediatePropagation();
    const { segment, point } = found;
    this.#contact = { down: event, segment, point: [...point], isDragging: false };
    this.#stage.canvas.setPointerCapture(event.pointerId);
    this.#stage.canvas.focus({ preventScroll: true });
  }

  #move(event: PointerEvent): void {
    const { canvas } = this.#stage;
    const contact = this.#contact;
    if (!contact) {
      const feels = event.pointerType === "mouse" && event.buttons === 0 && this.#feels;
      canvas.classList.toggle("graspable", feels && this.#stage.pick(event.clientX, event.clientY) !== null);
      return;
    }
    event.stopImmediatePropagation();
    if (event.pointerId !== contact.down.pointerId) return;
    const { clientX, clientY } = contact.down;
    contact.isDragging ||= Math.hypot(event.clientX - clientX, event.clientY - clientY) > slack;
    if (!contact.isDragging) return;
    const place = this.#stage.unproject(event.clientX, event.clientY, contact.point, contact.segment);
    this.#touch.take(contact.segment, [...place]);
  }

  get #feels(): boolean {
    const plant = this.#plant();
    return plant !== null && plant.segments.parent.length <= mostFelt;
  }

  #lift(event: PointerEvent): void {
    if (event.pointerId !== this.#contact?.down.pointerId) return;
    event.stopImmediatePropagation();
    this.#cancel();
  }

  /** A second finger: both together move the camera, which must hear of the first one too. */
  #yield(second: PointerEvent): void {
    const first = this.#contact?.down;
    this.#cancel();
    if (first && second.pointerType === "touch")
      first.target?.dispatchEvent(new PointerEvent("pointerdown", first));
  }

  #cancel(): void {
    this.#contact = null;
    this.#touch.letGo();
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const plant = this.#plant();
    const aim = this.#touch.aim;
    if (event.key === "Enter" && plant) {
      if (aim) this.#touch.letGo();
      else this.#touch.takeTip();
      return;
    }
    if (!plant || !aim) return;
    const [dx, dy] =
      { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [];
    const along = { PageUp: 1, PageDown: -1 }[event.key];
    if (dx === undefined && along === undefined) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (dx !== undefined && dy !== undefined) {
      const { length, heading } = measure(plant);
      const step = stride * length * (event.shiftKey ? 0.2 : 1);
      const [x, y, z] = aim.place;
      this.#touch.take(aim.segment, [x + dx * step * heading[0], y + dy * step, z + dx * step * heading[2]]);
    } else if (along !== undefined) {
      const segment = aim.segment + along;
      if (segment >= 0 && segment < plant.segments.parent.length)
        this.#touch.take(segment, endOf(plant, segment));
    }
  }
}
