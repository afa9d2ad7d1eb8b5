/** A grown plant as typed arrays: what the engine answers, and all that geometry, plots and exports read. */
import type { Params } from "../../generated/params.ts";

/** How a search for equilibrium ended. Only `"converged"` means that the torque residual is small. */
export type Status = "converged" | "maxIterations" | "nonFinite" | "budget";

/** What the solver says of a plant. */
export interface Report {
  /** How the iteration ended; the worst of all growth steps. */
  status: Status;
  /** Whether the final equilibrium is a minimum of energy; null when the shape is no equilibrium. */
  stable: boolean | null;
  /** First growth step whose equilibrium was not stable, or null. */
  unstableSince: number | null;
  /** Largest torque left over at a joint, relative to the largest external torque. */
  residual: number;
  /** Largest residual at the end of any growth step. */
  worstStepResidual: number;
  /** Newton factorizations, or Euler steps, of all growth steps together. */
  iterations: number;
  /** Growth steps taken. */
  steps: number;
  /**
   * Of an upright plant, the present loads over those at which it can no longer stand straight: above 1 it is past its critical
   * height and leans; null of any other plant.
   */
  selfBuckling: number | null;
  /** Weight times length squared over EI at the base; q for a uniform axis. */
  gravityNumber: number;
  /** With extrapolated stepping, the largest distance from the shape of exact stepping that is to be expected, over the length of the axis; null otherwise. */
  steppingError: number | null;
  /** Modulus of rupture over the largest fibre stress: below 1 the plant breaks; null where nothing is stressed. */
  safetyFactor: number | null;
  /** The segment with that stress, which breaks first; null where nothing is stressed. */
  breaksFirst: number | null;
}

/** Centre lines of all axes; A axes, P points. */
export interface Polylines {
  /** x, y, z in m, axis after axis; shape 3P. The first point of an axis is where it is attached. */
  points: Float64Array;
  /** Radius at every point, m; shape P. */
  radii: Float64Array;
  /** Axis a owns points `offsets[a] .. offsets[a + 1]`; shape A + 1. k segments have k + 1 points. */
  offsets: Uint32Array;
}

/** One entry a segment, parents before children; n segments. */
export interface Segments {
  /** Bearing segment, -1 for the ground. */
  parent: Int32Array;
  /** Index of the segment's distal point in `polylines`. */
  point: Uint32Array;
  /** The axis the segment belongs to. */
  axis: Uint32Array;
  /** Branching order of that axis, 0 for the main axis. */
  order: Uint32Array;
  /** Growth step of birth, from 1. */
  birth: Uint32Array;
  /** Length, m. */
  length: Float64Array;
  /** Radius at the middle, m. */
  radius: Float64Array;
  /** Mass of the wood, kg. */
  mass: Float64Array;
  /** Orientation as a quaternion x, y, z, w that turns +x to the segment's direction; shape 4n. */
  rotation: Float64Array;
  /** Bending moment at the base joint, N m: counter-clockwise in a vertical plane, its size in space. */
  moment: Float64Array;
  /** Twisting moment at the base joint, N m, right-handed about the wood; 0 in a plane. */
  twistMoment: Float64Array;
  /** Joint angle over joint length, 1/m: counter-clockwise in a vertical plane, the size of the bend in space. */
  curvature: Float64Array;
  /** Rest angle over joint length, 1/m. */
  restCurvature: Float64Array;
  /** Largest fibre stress over the pipes, Pa. */
  stress: Float64Array;
}

/** A grown plant at the end of one growth step. */
export interface Plant {
  /** Where it is. */
  polylines: Polylines;
  /** What it is made of. */
  segments: Segments;
  /** The complete params that made it. */
  params: Params;
  /** The version of Bough that made it. */
  version: string;
  /** How it was solved. */
  report: Report;
}

/** Whether the largest fibre stress is past the modulus of rupture. */
export function isBroken({ safetyFactor }: Report): boolean {
  return safetyFactor !== null && safetyFactor < 1;
}
