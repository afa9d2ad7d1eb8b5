/** The core's functions with the types of the page. Results are copies: nothing in them refers to wasm memory. */
import * as glue from "../../generated/bough.js";
import type { Vector } from "../params/declaration.ts";
import type { Issue, IssueCode } from "../params/issue.ts";
import { shown } from "../params/wording.ts";
import type { Plant, Report, Status } from "../plant/plant.ts";
import type { Trajectory } from "../plant/trajectory.ts";
import { CoreError } from "./failure.ts";
import { isLoaded } from "./wasm.ts";

/** A plant without what the core does not need to tell: the params that made it, and the version. */
export type Shape = Omit<Plant, "params" | "version">;

/** A plant that is held, and the force that holds it, N. */
export interface Held {
  shape: Shape;
  force: Vector;
}

/** Makes a fresh instance of the wasm. Glue that was made without it keeps the old one. */
const { __wbg_reset_state: reset } = glue as { __wbg_reset_state?: () => void };

/** Counts the instances of the wasm: what an earlier one held is gone. */
let instance = 0;

/** Calls into the wasm. A trap leaves its memory in disorder, so the next call gets a fresh instance. */
function call<Result>(work: () => Result): Result {
  if (!isLoaded()) throw new Error("Bough is not ready yet: call init() and wait for it first.");
  try {
    return work();
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError)) throw error;
    if (reset) {
      reset();
      instance++;
    }
    throw new CoreError(
      `The computation broke off: the memory ran out, or this is a fault of Bough (${error.message}). ` +
        "The next one starts afresh.",
      { cause: error },
    );
  }
}

/** What the core finds wrong with the ranges of flat params, and with their combinations. */
export function check(flat: Float64Array): Issue[] {
  return call(() =>
    glue.check(flat).map((found) => {
      const { code, path, value, pattern, numbers, min, max } = found;
      found.free();
      const message = filled(pattern, numbers);
      const range = min === undefined || max === undefined ? {} : { min, max };
      return { code: code as IssueCode, path, value, message, ...range };
    }),
  );
}

/** A sentence of the core with its numbers in their places. */
function filled(pattern: string, numbers: Float64Array): string {
  let place = 0;
  return pattern.replaceAll("{}", () => shown(numbers[place++] ?? Number.NaN));
}

/** How the plant of flat params, which must have passed `check`, comes to rest in a growth step, a whole number. */
export function relaxation(flat: Float64Array, step: number): Trajectory {
  return call(() => {
    const found = new glue.Trajectory(flat, step);
    const [segments = 0, steps = 0, residual = 0] = found.figures();
    const arrays = { time: found.time(), angle: found.angle(), velocity: found.velocity() };
    const trajectory = { segments, ...arrays, status: found.status as Status, residual, steps };
    found.free();
    return trajectory;
  });
}

/** The ages of one plant, held in wasm memory until `free`. */
export class History {
  readonly #flat: Float64Array;
  #handle: glue.History;
  #instance = instance;

  /** From flat params, which must have passed `check`. */
  constructor(flat: Float64Array) {
    this.#flat = flat;
    this.#handle = call(() => new glue.History(flat));
  }

  /** How many growth steps there are. */
  get steps(): number {
    return this.#call((handle) => handle.steps);
  }

  /** The step that growth stands at. */
  get step(): number {
    return this.#call((handle) => handle.step);
  }

  /**
   * Goes towards a step for about `budget` stepped segments; outside 1 .. `steps` it is the nearest inside.
   * @returns whether it was reached
   */
  seek(step: number, budget: number): boolean {
    // wasm would take numbers modulo 2^32.
    return this.#call((handle) => handle.seek(Math.min(Math.max(step, 1), handle.steps), budget));
  }

  /**
   * As `seek`, but never beyond this work, in iterations times segments: a step that needs more is given up, and the plant is
   * that of the last finished one, with the status "budget".
   */
  reach(step: number, work: number): boolean {
    return this.#call((handle) => handle.reach(Math.min(Math.max(step, 1), handle.steps), work));
  }

  /** How much of the work of growth it takes again to make the plant of it. */
  get remaking(): number {
    return this.#call((handle) => handle.remaking);
  }

  /** The plant at the step that growth stands at. */
  shape(): Shape {
    return this.#call((handle) => copied(handle.plant()));
  }

  /**
   * The plant at the step that growth stands at, with the distal end of a segment held at a place (m); null when it
   * cannot be. Places near each other are quick. The next `shape` lets go.
   */
  hold(segment: number, [x, y, z]: Vector): Held | null {
    // wasm would take numbers modulo 2^32.
    if (!Number.isInteger(segment) || segment < 0 || segment >= 2 ** 32) return null;
    return this.#call((handle) => {
      const plant = handle.hold(segment, x, y, z);
      if (!plant) return null;
      const [, fx = 0, fy = 0, fz = 0] = plant.forces();
      return { shape: copied(plant), force: [fx, fy, fz] };
    });
  }

  /** Gives the memory back. */
  free(): void {
    if (this.#instance === instance) this.#handle.free();
  }

  /** A history of an earlier instance of the wasm starts anew: every step is the same to the last bit. */
  #call<Result>(work: (handle: glue.History) => Result): Result {
    return call(() => {
      if (this.#instance !== instance) {
        this.#handle = new glue.History(this.#flat);
        this.#instance = instance;
      }
      return work(this.#handle);
    });
  }
}

function copied(plant: glue.Plant): Shape {
  const shape = {
    polylines: { points: plant.points(), radii: plant.radii(), offsets: plant.offsets() },
    segments: {
      parent: plant.parent(),
      point: plant.point(),
      axis: plant.axis(),
      order: plant.order(),
      birth: plant.birth(),
      length: plant.length(),
      radius: plant.radius(),
      mass: plant.mass(),
      rotation: plant.rotation(),
      moment: plant.moment(),
      twistMoment: plant.twist_moment(),
      curvature: plant.curvature(),
      restCurvature: plant.rest_curvature(),
      stress: plant.stress(),
    },
    report: reported(plant),
  };
  plant.free();
  return shape;
}

function reported(plant: glue.Plant): Report {
  const figures = plant.figures();
  const [residual = 0, worstStepResidual = 0, iterations = 0, steps = 0, gravityNumber = 0] = figures;
  const there = (figure = Number.NaN) => (Number.isNaN(figure) ? null : figure);
  return {
    status: plant.status as Status,
    stable: plant.stable ?? null,
    unstableSince: plant.unstable_since ?? null,
    residual,
    worstStepResidual,
    iterations,
    steps,
    gravityNumber,
    steppingError: there(figures[5]),
    selfBuckling: there(figures[6]),
    safetyFactor: there(figures[7]),
    breaksFirst: there(figures[8]),
  };
}
