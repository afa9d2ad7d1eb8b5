/** Passes from one shape of a plant to another before the eye: when it is let go of, or its loads are taken off. */
import { blend } from "../geometry/blend.ts";
import type { Plant } from "../plant/plant.ts";

/** The share of the way that is gone, by the share of the time: 0 at 0, about 1 at 1. */
type Pace = (share: number) => number;

/** How a passage goes, and how long it takes, ms. */
export const gaits = {
  /** From rest to rest. */
  ease: { duration: 600, pace: (share) => share * share * (3 - 2 * share) },
  /** As a branch that is let go of: it swings past, less and less. For the eye only, the core knows no time. */
  swing: {
    duration: 1100,
    pace: (share) => 1 - Math.exp(-5 * share) * (1 - share) * Math.cos(5 * Math.PI * share),
  },
} as const satisfies Record<string, { duration: number; pace: Pace }>;

export class Passage {
  readonly #stillness = matchMedia("(prefers-reduced-motion: reduce)");
  #plant: Plant | null = null;
  #request = 0;

  /** The shape that is due; null when there is no passage. */
  get plant(): Plant | null {
    return this.#plant;
  }

  /**
   * Passes between two shapes of the same plant; `onChange` is told of every shape that is due, and of the end. Others, and
   * all where motion is unwelcome, are left to change at once.
   */
  start(from: Plant, to: Plant, gait: keyof typeof gaits, onChange: () => void): void {
    this.stop();
    const isSame = from.polylines.points.length === to.polylines.points.length;
    if (this.#stillness.matches || !isSame) return;
    const { duration, pace } = gaits[gait];
    let started: number | undefined;
    const tick = (now: number) => {
      started ??= now;
      const share = (now - started) / duration;
      const between = share < 1 ? blend(from, to, pace(share)) : null;
      this.#plant = between ? { ...to, polylines: between.polylines } : null;
      if (between) this.#request = requestAnimationFrame(tick);
      onChange();
    };
    this.#plant = from;
    this.#request = requestAnimationFrame(tick);
  }

  /** Ends it. */
  stop(): void {
    cancelAnimationFrame(this.#request);
    this.#plant = null;
  }
}
