/** A way to rest in one growth step, from the moment at which the new wood is attached and all weights begin to act. */
import type { Status } from "./plant.ts";

/** T moments, n segments. */
export interface Way {
  /** How many segments there are, n; in the order of `Plant.segments`. */
  segments: number;
  /** Of the paper's relaxation the time of each moment, s; of Newton's method the number of each iteration; shape T. */
  time: Float64Array;
  /** Direction of every segment, radians counter-clockwise from +x; shape T n, moment after moment. */
  angle: Float64Array;
  /** Largest torque left over at a joint at each moment, relative to the largest external torque; shape T. */
  residuals: Float64Array;
  /** How it ended. */
  status: Status;
  /** Euler steps, or iterations of Newton's method. */
  steps: number;
  /** Whether the last shape was not reached by the iterations before it, but by raising the load in parts. */
  isLed: boolean;
}
