/** How a limb leaves the one that bears it: it swells to meet it, so that the two look grown, not stuck together. */

/** In radii of the bearing limb: so far from its start a limb is swollen. */
const reach = 3.2;
/** A limb that leaves from the side widens by this share of its radius. */
const collar = 0.9;

export class Junction {
  /** Up to this distance from the start the limb is swollen, m. */
  length = 0;
  #extra = 0;

  /** None: a limb that stands by itself. */
  clear(): void {
    this.length = 0;
    this.#extra = 0;
  }

  /**
   * A limb of a radius leaves one of the radius `bearing` (both as drawn): as its continuation, then it starts just as
   * thick, or from its side, then with a collar that stays within it.
   */
  join(radius: number, bearing: number, continues: boolean, limbLength: number): void {
    this.length = Math.min(reach * bearing, 0.6 * limbLength);
    this.#extra = continues
      ? bearing - radius
      : Math.max(0, Math.min((1 + collar) * radius, 0.9 * bearing) - radius);
  }

  /** What the radius has more at a distance from the start. */
  swelling(distance: number): number {
    const t = this.#share(distance);
    return this.#extra * (1 - t) * (1 - t) * (1 + 2 * t);
  }

  /** How fast that changes with the distance. */
  slope(distance: number): number {
    const t = this.#share(distance);
    return this.length > 0 ? (-6 * this.#extra * t * (1 - t)) / this.length : 0;
  }

  #share(distance: number): number {
    return this.length > 0 ? Math.min(1, Math.max(0, distance / this.length)) : 1;
  }
}
