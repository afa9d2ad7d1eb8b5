/** A passage from one thing to another that takes a moment, so that the eye can follow. */

/** ms */
const duration = 320;

/** Runs from 0 to 1, slow at both ends. Nothing ticks here: whoever draws asks for the share. */
export class Glide {
  #start = -Infinity;

  /** Starts over at the time `now`, in ms. */
  start(now: number): void {
    this.#start = now;
  }

  /** Jumps to the end. */
  finish(): void {
    this.#start = -Infinity;
  }

  /** How far it has come, 0 to 1. */
  share(now: number): number {
    const t = Math.min(1, Math.max(0, (now - this.#start) / duration));
    return t * t * (3 - 2 * t);
  }
}
