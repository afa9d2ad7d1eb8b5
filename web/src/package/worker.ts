/** Bough off the main thread: promises, progress, abort signals. `init` is not needed here. */
import { startPool } from "../engine/engine.ts";
import { type Sweep, type SweepAxes, type SweepOptions, sweepOver } from "../engine/sweep.ts";
import type { ParamsInput } from "../params/params.ts";

export { startEngine, startPool } from "../engine/engine.ts";
export * from "./worker-api.ts";

/**
 * Grows many plants at once and tells of them in columns: of one set of params or of a list of them, with every combination of
 * the axes' values. Bad params spoil their own row only.
 * @throws {BoughError} if an axis is no parameter
 */
export function sweep(
  params: ParamsInput | readonly ParamsInput[],
  axes: SweepAxes = {},
  options: SweepOptions = {},
): Promise<Sweep> {
  return sweepOver(startPool, params, axes, options);
}
