/** Which part of the world is in the picture, from one plant to the next: as still as it can be. */
import { type Bounds, boundsOf, union } from "../geometry/bounds.ts";
import { between, type Frame, frameOf, girthFor, type Size } from "../geometry/frame.ts";
import { measure } from "../geometry/measure.ts";
import type { Plant } from "../plant/plant.ts";
import { Glide } from "./glide.ts";

/** What is to be in the picture. */
export interface Aim {
  readonly plant: Plant;
  readonly grown: Plant;
  /** False in the midst of a gesture. */
  readonly settled: boolean;
  /** Whether it can be turned: then its depth needs room as well. */
  readonly turns: boolean;
}

/** A plant beside that is so many times as large is not taken in. */
const farLarger = 8;

export class Framing {
  /** How many times too thick limbs are drawn. */
  girth = 1;
  /** How large the full-grown plant is, m. */
  extent = 1;
  /** Radius of the base as drawn, m. */
  foot = 0;
  readonly #glide = new Glide();
  #bounds: Bounds | null = null;
  #beside: Bounds | null = null;
  #turns = false;
  #picture: Size = { width: 1, height: 1 };
  #from: Frame | null = null;
  #to: Frame | null = null;

  /**
   * Aims at a plant, whatever its age: the frame fits it at full age. In the midst of a gesture the frame only widens, and
   * limbs keep their girth, so that what is seen is what changed.
   */
  aim({ plant, grown, settled, turns }: Aim, now: number): void {
    this.#turns = turns;
    const holds = !settled && this.#bounds !== null;
    if (!holds) {
      this.extent = extent(boundsOf(grown.polylines));
      this.girth = girthFor(thickest(grown), this.extent);
    }
    this.foot = (grown.polylines.radii[0] ?? 0) * this.girth;
    const plants = union(boundsOf(grown.polylines, this.girth), boundsOf(plant.polylines, this.girth));
    const bounds = union(plants, marked(grown, extent(plants)));
    this.#bounds = holds && this.#bounds ? union(this.#bounds, bounds) : bounds;
    this.#turn(now);
  }

  /** Takes another plant in beside it, or none any more. */
  takeIn(plant: Plant | null, now: number): void {
    // Its centre lines: to pin the plant that is shown moves nothing.
    this.#beside = plant && boundsOf(plant.polylines, 0);
    this.#turn(now);
  }

  /** Takes the size of the picture: that is no passage to look at. */
  resize(picture: Size): void {
    this.#picture = picture;
    this.#turn(0);
    this.finish();
  }

  /** Ends a passage at once. */
  finish(): void {
    this.#glide.finish();
  }

  /** The frame at a time, and whether it still moves; null before the first plant. */
  at(now: number): { frame: Frame; moves: boolean } | null {
    if (!this.#from || !this.#to) return null;
    const share = this.#glide.share(now);
    return { frame: between(this.#from, this.#to, share), moves: share < 1 };
  }

  #turn(now: number): void {
    if (!this.#bounds) return;
    const isFarLarger = this.#beside && extent(this.#beside) > farLarger * extent(this.#bounds);
    const beside = isFarLarger ? null : this.#beside;
    const to = frameOf(this.#bounds, this.#picture, this.foot, this.#turns, beside);
    if (this.#to && same(this.#to, to)) return;
    this.#from = this.at(now)?.frame ?? to;
    this.#to = to;
    this.#glide.start(now);
  }
}

function thickest({ polylines }: Plant): number {
  return polylines.radii.reduce((most, radius) => Math.max(most, radius), 0);
}

function extent({ min, max }: Bounds): number {
  return Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

function same(a: Frame, b: Frame): boolean {
  return (
    a.height === b.height && a.ground === b.ground && a.center.every((value, k) => value === b.center[k])
  );
}

/** The box of what marks the elevation of the base, for a plant of some extent. */
function marked(plant: Plant, extent: number): Bounds {
  const { base, heading } = measure(plant);
  const { elevation } = plant.params.axis;
  const boxes = [0, elevation / 2, elevation].map((angle) => {
    const radians = (angle * Math.PI) / 180;
    const [across, up] = [0.18 * extent * Math.cos(radians), 0.18 * extent * Math.sin(radians)];
    const end = [base[0] + across * heading[0], base[1] + up, base[2] + across * heading[2]] as const;
    return { min: end, max: end };
  });
  return boxes.reduce(union);
}
