/** Lets a plant pass from one growth step to the next while its growth is replayed. */
import { blend } from "../geometry/blend.ts";
import type { Axes } from "../geometry/tube.ts";

export class Morph {
  #from: Axes | null = null;
  #to: Axes | null = null;
  #start = 0;
  #duration = 0;

  /** Passes to a plant in the given time from now on, in ms; 0 is at once. */
  turn(to: Axes, now: number, duration: number): void {
    const grows = this.#to !== null && to.report.steps === this.#to.report.steps + 1;
    this.#from = duration > 0 && grows ? this.#to : null;
    this.#to = to;
    this.#start = now;
    this.#duration = duration;
  }

  /** The shape at a time, and whether it still moves. */
  at(now: number): { axes: Axes; moves: boolean } | null {
    if (!this.#to) return null;
    const share = this.#from ? Math.min(1, Math.max(0, (now - this.#start) / this.#duration)) : 1;
    const between = this.#from && share < 1 ? blend(this.#from, this.#to, share) : null;
    return between ? { axes: between, moves: true } : { axes: this.#to, moves: false };
  }
}
