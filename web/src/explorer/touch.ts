/** Holds a point of the plant where a person wants it: the newest place counts. Loaded after the first plant. */
import type { Engine } from "../engine/engine.ts";
import { measure } from "../geometry/measure.ts";
import type { Vector } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import type { Stage } from "../scene/stage.ts";
import { Hand } from "./hand.ts";

/** Where a plant is held, by which force. */
export interface Pull {
  readonly segment: number;
  /** The end of the segment, m; where the hand is too, if that is within reach. */
  readonly at: Vector;
  /** N */
  readonly force: Vector;
}

/** Whom the touch concerns. */
export interface Toucher {
  readonly engine: Pick<Engine, "hold">;
  readonly stage: Stage;
  /** The plant that can be touched; null while it is being computed. */
  plant(): Plant | null;
  /** The plant is touched: nothing else shall move it. */
  onTake(): void;
  /** It is held otherwise than before. */
  onChange(): void;
  /** It was let go of; `held` is how it was held last, if it was. */
  onLetGo(held: Plant | null): void;
}

/** What is held, and how the plant answered. */
interface Grasp {
  readonly free: Plant;
  segment: number;
  place: Vector;
  held: Plant | null;
}

export class Touch {
  readonly #toucher: Toucher;
  #grasp: Grasp | null = null;
  #asks = false;
  /** Whether the place has changed since it was asked for. */
  #isStale = false;

  constructor(toucher: Toucher) {
    this.#toucher = toucher;
    new Hand(toucher.stage, this, () => toucher.plant());
  }

  /** Whether a hand is on the plant. */
  get holds(): boolean {
    return this.#grasp !== null;
  }

  /** Whether the plant has yet to answer. */
  get busy(): boolean {
    return this.#asks || this.#isStale;
  }

  /** The plant as it is held. */
  get plant(): Plant | null {
    return this.#grasp?.held ?? null;
  }

  /** How it is held; null before it has answered. */
  get pull(): Pull | null {
    const held = this.plant;
    const [pull] = held?.params.loads.forces ?? [];
    return held && pull ? { ...pull, at: endOf(held, pull.segment) } : null;
  }

  /** The segment that is held, and where it is wanted. */
  get aim(): { segment: number; place: Vector } | null {
    return this.#grasp;
  }

  /** Takes the end of a segment to a place, m. */
  take(segment: number, place: Vector): void {
    const free = this.#grasp?.free ?? this.#toucher.plant();
    if (!free) return;
    if (!this.#grasp) this.#toucher.onTake();
    this.#grasp ??= { free, segment, place, held: null };
    Object.assign(this.#grasp, { segment, place });
    this.#isStale = true;
    if (!this.#asks) void this.#ask();
    this.#toucher.onChange();
  }

  /** Takes hold of the tip of the measured axis, where it is. */
  takeTip(): void {
    const plant = this.#toucher.plant();
    const segment = plant ? plant.segments.axis.lastIndexOf(measure(plant).axis) : -1;
    if (plant && segment >= 0) this.take(segment, endOf(plant, segment));
  }

  /** Lets go of the plant. */
  letGo(): void {
    if (!this.#grasp) return;
    const { held } = this.#grasp;
    this.#grasp = null;
    this.#isStale = false;
    this.#toucher.onLetGo(held);
  }

  async #ask(): Promise<void> {
    this.#asks = true;
    try {
      while (this.#grasp && this.#isStale) {
        this.#isStale = false;
        const grasp = this.#grasp;
        const { free, segment, place } = grasp;
        const held = await this.#toucher.engine.hold(free.params, free.report.steps, segment, place);
        if (this.#grasp !== grasp) continue;
        // Where it cannot be held the last answer stays: the branch does not follow there.
        if (held) grasp.held = held;
        this.#toucher.onChange();
      }
    } catch {
      // Something newer is wanted of the engine, or it broke, which the next plant will tell.
      this.letGo();
    } finally {
      this.#asks = false;
      this.#toucher.onChange();
    }
  }
}

/** The distal end of a segment, m. */
export function endOf({ polylines, segments }: Plant, segment: number): Vector {
  const at = 3 * (segments.point[segment] ?? 0);
  const [x = 0, y = 0, z = 0] = polylines.points.subarray(at, at + 3);
  return [x, y, z];
}
