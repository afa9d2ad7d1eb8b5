/** Replays the growth. */

/** ms a growth step, and how long the whole may take, at speed 1. */
const pace = 90;
const [shortest, longest] = [2500, 6000];

/** How fast growth may be replayed. */
export const speeds = [0.5, 1, 2, 4] as const;
/** One of the speeds. */
export type Speed = (typeof speeds)[number];

export class Playback {
  /** The growth step that is due, while it plays. */
  step: number | null = null;
  /** How long a growth step takes, ms; 0 while nothing plays. */
  interval = 0;
  #speed: Speed = 1;
  #request = 0;

  /** Whether it plays. */
  get plays(): boolean {
    return this.step !== null;
  }

  /** How fast it plays; may change while it does. */
  get speed(): Speed {
    return this.#speed;
  }

  set speed(speed: Speed) {
    this.interval *= this.#speed / speed;
    this.#speed = speed;
  }

  /** Plays from one growth step to another; `onStep` is told every step that is due, `onEnd` that the last was reached. */
  start(from: number, to: number, onStep: () => void, onEnd: () => void): void {
    this.stop();
    const count = to - from + 1;
    const whole = Math.min(longest, Math.max(shortest, to * pace)) / to;
    this.interval = whole / this.#speed;
    let before: number | undefined;
    let grown = 0;
    const tick = (now: number) => {
      grown += (now - (before ?? now)) / this.interval;
      before = now;
      const step = Math.min(to, from + Math.floor(grown));
      if (step !== this.step) {
        this.step = step;
        onStep();
      }
      if (grown < count) this.#request = requestAnimationFrame(tick);
      else {
        this.stop();
        onEnd();
      }
    };
    this.step = from;
    onStep();
    this.#request = requestAnimationFrame(tick);
  }

  /** Stops where it is. */
  stop(): void {
    cancelAnimationFrame(this.#request);
    this.step = null;
    this.interval = 0;
  }
}
