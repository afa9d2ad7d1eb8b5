/** How the points of a plant move with its parameters: exact derivatives, through the whole growth. */

/** One number of the params: a parameter, or of a vector one of its numbers x, y, z (0, 1, 2). */
export interface Place {
  readonly path: string;
  readonly part: number;
}

/** The centre lines of a plant, and their derivatives. */
export interface Sensitivity {
  /** As `Plant.polylines.points`; of an arrangement, one copy as it would stand alone. */
  points: Float64Array;
  /**
   * For each place that was asked for, the derivative of every one of these numbers, m a unit of the parameter (an angle: a
   * degree); null where the shape does not depend on it smoothly.
   */
  slopes: (Float64Array | null)[];
}
