/** What every entry of the package offers, once the wasm is loaded. */
import { History as CoreHistory, check as checkFlat, relaxation as coreRelaxation } from "../engine/core.ts";
import { milliseconds, Stint } from "../engine/stint.ts";
import { version } from "../params/declaration.ts";
import { allIssues, type Examination, examined } from "../params/examination.ts";
import { BoughError, type Issue } from "../params/issue.ts";
import { type Params, type ParamsInput, stepsOf } from "../params/params.ts";
import { described } from "../params/wording.ts";
import type { Plant } from "../plant/plant.ts";
import type { Trajectory } from "../plant/trajectory.ts";

export { CoreError, LoadError } from "../engine/failure.ts";
export type { Source } from "../engine/wasm.ts";
export { type PointForce, type Preset, presets, type Vector, version } from "../params/declaration.ts";
export { BoughError, type Issue, type IssueCode } from "../params/issue.ts";
export type { Params, ParamsInput, PresetId } from "../params/params.ts";
export { schema } from "../params/schema.ts";
export type { Plant, Polylines, Report, Segments, Status } from "../plant/plant.ts";
export type { Trajectory } from "../plant/trajectory.ts";

/**
 * Every problem with any value given as params; empty when a plant can be grown from it. Nothing is thrown, whatever
 * the value is.
 */
export function check(params: unknown): Issue[] {
  const examination = examined(params);
  return allIssues(examination, checkFlat(examination.flat));
}

/**
 * Grows a plant to its last step, and returns when it is done: within a millisecond for the default plant. What is left out of
 * the params takes its default, so `{}` grows the default plant. The same params give the same plant to the last bit,
 * wherever they are grown.
 * @throws {BoughError} listing every problem, if no plant can be grown from these params
 */
export function grow(params: ParamsInput, { deadline }: GrowOptions = {}): Plant {
  if (deadline !== undefined) return grownUntil(passed(params), milliseconds(deadline));
  const ages = history(params);
  try {
    return ages.at(ages.steps);
  } finally {
    ages.dispose();
  }
}

/** What `grow` may be given beside the params. */
export interface GrowOptions {
  /**
   * Time that growing may take, ms. A plant that is not finished then is that of the last finished step, and its report says
   * `"budget"`; it has no segments if not even the first step was finished.
   */
  deadline?: number;
}

function grownUntil({ params, flat }: Examination, deadline: number): Plant {
  const core = new CoreHistory(flat);
  try {
    const stint = new Stint(deadline);
    while (stint.go(core, core.steps) === "onTheWay") {}
    return { ...core.shape(), params, version };
  } finally {
    core.free();
  }
}

/**
 * Prepares the ages of one plant; nothing is grown yet.
 * @throws {BoughError} listing every problem, if no plant can be grown from these params
 */
export function history(params: ParamsInput): History {
  return new Ages(passed(params));
}

/**
 * The paper's own way to rest (equations 15 to 20: Euler steps with damping) in one growth step, recorded so that it
 * can be played. It ends in the equilibrium that `grow` finds by Newton's method; the steps before are solved by that. Of
 * axes around a stem, which do not move each other, it is the one of a single axis. Quick to 100 segments, slow beyond:
 * the number of Euler steps goes with n to the power of 1.5. More than 2000 segments are refused.
 * @param step the growth step, the last one if it is left out; outside it is the nearest inside
 * @throws {BoughError} listing every problem, if no plant can be grown from these params
 * @throws {Error} at more than 2000 segments
 */
export function relaxation(params: ParamsInput, step: number = Number.POSITIVE_INFINITY): Trajectory {
  const examination = passed(params);
  const last = stepsOf(examination.params);
  return coreRelaxation(examination.flat, Math.min(Math.max(numbered(step, last), 1), last));
}

/**
 * The ages of one plant, made by `history`. They can be asked for in any order; each is the same to the last bit,
 * whichever way it is reached. To iterate over it gives every age from the first step to the last. What it holds in wasm
 * memory is bounded, and given back by `dispose`, or when the object is garbage-collected; the plants it gave stay.
 */
export interface History extends Iterable<Plant> {
  /** How many growth steps there are. */
  readonly steps: number;
  /** The plant at the end of a growth step; outside 1 .. `steps` it is the nearest inside. */
  at(step: number): Plant;
  /** Gives the wasm memory back; the history is of no more use then. */
  dispose(): void;
}

class Ages implements History {
  readonly steps: number;
  readonly #params: Params;
  #core: CoreHistory | undefined;

  constructor({ params, flat }: Examination) {
    this.#params = params;
    this.#core = new CoreHistory(flat);
    this.steps = this.#core.steps;
  }

  at(step: number): Plant {
    if (!this.#core) throw new Error("This history was disposed of.");
    this.#core.seek(numbered(step, this.steps), Number.POSITIVE_INFINITY);
    return { ...this.#core.shape(), params: this.#params, version };
  }

  *[Symbol.iterator](): Iterator<Plant> {
    for (let step = 1; step <= this.steps; step++) yield this.at(step);
  }

  dispose(): void {
    this.#core?.free();
    this.#core = undefined;
  }
}

/** Params that a plant can be grown from; all that is wrong with them is thrown. */
function passed(params: ParamsInput): Examination {
  const examination = examined(params);
  const issues = allIssues(examination, checkFlat(examination.flat));
  if (issues.length > 0) throw new BoughError(issues);
  return examination;
}

/** The step, if it is a number at all. */
function numbered(step: number, max: number): number {
  if (typeof step === "number" && !Number.isNaN(step)) return step;
  const message = `step must be a number from 1 to ${max}; it is ${described(step)}.`;
  throw new BoughError([{ code: "wrongType", path: "step", value: step, message, min: 1, max }]);
}
