/** The age that is shown: replayed, paused, or gone through by single steps. */
import type { Store } from "../params/store.ts";
import type { Plant } from "../plant/plant.ts";
import { Playback, type Speed } from "../scene/playback.ts";

export class Replay {
  readonly #store: Store;
  readonly #grown: () => Plant | null;
  readonly #onStep: () => void;
  readonly #playback = new Playback();

  /** `grown` is the full-grown plant; `onStep` is told that another age is due. */
  constructor(store: Store, grown: () => Plant | null, onStep: () => void) {
    this.#store = store;
    this.#grown = grown;
    this.#onStep = onStep;
  }

  /** Whether it plays. */
  get plays(): boolean {
    return this.#playback.plays;
  }

  /** The growth step that is due: of the replay, else of the state; null is full grown. */
  get step(): number | null {
    return this.#playback.step ?? this.#store.state.step;
  }

  /** How long a growth step takes, ms; 0 while nothing plays. */
  get interval(): number {
    return this.#playback.interval;
  }

  /** How fast it plays. */
  get speed(): Speed {
    return this.#playback.speed;
  }

  set speed(speed: Speed) {
    this.#playback.speed = speed;
  }

  /** Plays from the present age on, or from the first if it is the last, or if all of it is wanted; then tells so. */
  play(whole = false, onPlayed?: () => void): void {
    const last = this.#grown()?.report.steps;
    if (last === undefined) return;
    const { step } = this.#store.state;
    const from = whole || step === null || step >= last ? 1 : step;
    const onEnd = () => {
      this.#stay(null);
      onPlayed?.();
    };
    this.#playback.start(from, last, this.#onStep, onEnd);
  }

  /** Stays at the present age. */
  pause(): void {
    this.#stay(this.step);
  }

  /** Stops, and goes back to the age of the state. */
  stop(): void {
    if (!this.plays) return;
    this.#playback.stop();
    this.#onStep();
  }

  /** Shows another age, and stops. */
  go(steps: number): void {
    const last = this.#grown()?.report.steps;
    if (last === undefined) return;
    const step = Math.min(Math.max((this.step ?? last) + steps, 1), last);
    this.#stay(step === last ? null : step);
  }

  /** Stops, and makes an age that of the state. */
  #stay(step: number | null): void {
    const isKnown = step === this.#store.state.step;
    this.#playback.stop();
    this.#store.set({ step }, "settled");
    // The store tells nothing of an age that it has already.
    if (isKnown) this.#onStep();
  }
}
