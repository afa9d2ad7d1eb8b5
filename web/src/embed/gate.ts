/** Lets so many messages through, and no flood. */

/** As many at once, and as many a second after that. */
const [burst, rate] = [60, 30];

export class Gate {
  #room = burst;
  #at = 0;
  #isShut = false;

  /** Whether a message may pass at a time (ms); `"last"` is one too many, of which the sender is to be told. */
  pass(now: number): boolean | "last" {
    this.#room = Math.min(burst, this.#room + (Math.max(0, now - this.#at) / 1000) * rate);
    this.#at = now;
    // Once shut it opens only after a pause, so that a flood is told of once.
    if (this.#isShut && this.#room < burst / 2) return false;
    this.#isShut = this.#room < 1;
    if (this.#isShut) return "last";
    this.#room--;
    return true;
  }
}
