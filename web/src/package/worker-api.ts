/** What both entries off the main thread offer besides the engines. */
export type { Engine, EngineOptions, PlantOptions } from "../engine/engine.ts";
export { CoreError, LoadError, LostError } from "../engine/failure.ts";
export type { Pool, PoolOptions } from "../engine/pool.ts";
export type { Sweep, SweepAxes, SweepOptions, SweepProblem } from "../engine/sweep.ts";
export type { Source } from "../engine/wasm.ts";
export { type PointForce, type Preset, presets, type Vector, version } from "../params/declaration.ts";
export { BoughError, type Issue, type IssueCode } from "../params/issue.ts";
export type { Params, ParamsInput, PresetId } from "../params/params.ts";
export { type Measures, measureNames } from "../plant/measures.ts";
export type { Plant, Polylines, Report, Segments, Status } from "../plant/plant.ts";
