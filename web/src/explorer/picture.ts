/** The stage in the page: how it is named to those who do not see it, what it shows, and what is said when it cannot. */
import { say } from "../language/say.ts";
import type { Plant } from "../plant/plant.ts";
import type { Force } from "../scene/force.ts";
import { type Showing, Stage } from "../scene/stage.ts";
import type { Notices } from "./notices.ts";

/** What the picture is of. */
export interface Sight extends Showing {
  readonly shape: Plant;
  /** The force that holds it in this shape. */
  readonly force: Force | null;
}

export class Picture {
  readonly stage: Stage;
  readonly #notices: Notices;
  #sight: Sight | null = null;
  /** Why the stage shows something other than what is wanted. */
  #objection: string | null = null;

  /** Opens the stage in its element; throws where the browser draws no pictures. `onRest` is told that it may rest. */
  constructor(host: HTMLElement, notices: Notices, onRest: () => void) {
    this.stage = new Stage(host);
    this.#notices = notices;
    const { canvas } = this.stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", say("The plant"));
    const lost = say(
      "The graphics card dropped the picture: this is the last one. It will come back, or after a reload.",
    );
    canvas.addEventListener("bough-lost", () => notices.add(lost, { tone: "problem" }));
    canvas.addEventListener("bough-restored", () => notices.dismiss(({ text }) => text === lost));
    for (const event of ["bough-due", "bough-drawn", "bough-idle"]) canvas.addEventListener(event, onRest);
  }

  /** Says what is written on it anew: in another language. */
  say(): void {
    const sight = this.#sight;
    this.#sight = null;
    if (sight) this.show(sight);
  }

  /** Shows a plant, if that is anything new: while another is being computed, nothing is drawn again. */
  show(sight: Sight): void {
    if (this.#sight && !differs(this.#sight, sight)) return;
    this.#sight = sight;
    const objection = this.stage.show(sight.shape, sight);
    this.#notices.replace(this.#objection, objection);
    this.#objection = objection;
    this.stage.showForce(sight.force);
  }
}

/** Whether there is anything new to see. That a gesture begins is not; that it has ended is: then the frame fits closely. */
function differs(old: Sight, now: Sight): boolean {
  // The force belongs to the shape.
  const aspects = ["shape", "grown", "view", "color", "style", "tone", "still", "passage"] as const;
  return (now.settled && !old.settled) || aspects.some((aspect) => old[aspect] !== now[aspect]);
}
