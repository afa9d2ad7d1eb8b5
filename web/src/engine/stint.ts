/** Growing against the clock: as far as it goes in the time, in slices. */
import { BoughError } from "../params/issue.ts";
import { described } from "../params/wording.ts";
import type { History } from "./core.ts";

/** How long one slice should take, ms. */
const SLICE = 8;
/** For what cannot be foreseen, ms. */
const MARGIN = 10;
/** Work of the first slice, in iterations times segments: 0.1 ms by Newton, 10 ms by Euler. */
const FIRST_WORK = 1000;

/** What a slice came to. */
export type Progress = "there" | "onTheWay" | "late";

/** The time that one plant is given; it begins now. */
export class Stint {
  readonly #start = performance.now();
  readonly #end: number;
  #work = FIRST_WORK;

  /** `deadline` is in ms. */
  constructor(deadline: number) {
    this.#end = this.#start + deadline - MARGIN;
  }

  /** Grows for one slice, unless too little time is left for it: then the plant is that of the last finished step. */
  go(history: History, step: number): Progress {
    const before = performance.now();
    const from = history.step;
    const isLate = before >= this.#end;
    if (history.reach(step, isLate ? 0 : this.#work)) return "there";
    if (isLate) return "late";
    const now = performance.now();
    const took = now - before;
    // The plant must still be made of what has grown.
    const left = this.#end - now - history.remaking * (now - this.#start);
    // Where no step was finished the next one needs more.
    const isStuck = history.step === from;
    const times = isStuck ? 2 : Math.min(Math.max(SLICE / took, 0.1), 4);
    if (isStuck && times * took > left) return "late";
    this.#work *= Math.max(Math.min(times, left / took), 0.01);
    return left > 0 ? "onTheWay" : "late";
  }
}

/**
 * A deadline as it is given, ms.
 * @throws {BoughError} if it is no time
 */
export function milliseconds(deadline: number): number {
  if (typeof deadline === "number" && deadline >= 0) return deadline;
  const message = `deadline must be a number of milliseconds from 0 on; it is ${described(deadline)}.`;
  throw new BoughError([{ code: "wrongType", path: "deadline", value: deadline, message }]);
}
