/** A plant coming to rest in one growth step, as typed arrays: what playing and plotting it takes. */
import type { Status } from "./plant.ts";

/**
 * Angles and angular velocities over time, from the moment at which the new segments are attached and all weights begin
 * to act until the plant is at rest; T moments, n segments. The damping is chosen, as the paper leaves it open: only the
 * end is physical. At most 512 moments are kept.
 */
export interface Trajectory {
  /** How many segments there are, n; in the order of `Plant.segments`. */
  segments: number;
  /** Time of each moment, s; shape T. */
  time: Float64Array;
  /** Direction of every segment, radians counter-clockwise from +x; shape T n, moment after moment. */
  angle: Float64Array;
  /** Angular velocity of every segment's base joint, 1/s; shape T n, moment after moment. */
  velocity: Float64Array;
  /** How it ended. */
  status: Status;
  /** Largest torque left over at a joint in the end, relative to the largest external torque. */
  residual: number;
  /** Euler steps taken. */
  steps: number;
}
