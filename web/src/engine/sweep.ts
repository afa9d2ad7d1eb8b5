/** Many plants at once, told in columns. */
import { type AnyValue, groupAndField, parameterAt } from "../params/declaration.ts";
import { BoughError, type Issue } from "../params/issue.ts";
import type { ParamsInput } from "../params/params.ts";
import { type Measures, measureNames, measuresOf } from "../plant/measures.ts";
import type { Status } from "../plant/plant.ts";
import { LostError } from "./failure.ts";
import type { Pool, PoolOptions } from "./pool.ts";

/** Values for parameters by their paths: `{"loads.gravity": [0, 5, 10]}`. */
export type SweepAxes = Readonly<Record<string, ArrayLike<AnyValue>>>;

/** How a sweep is run; what a pool takes is for the one that is started for it. */
export interface SweepOptions extends PoolOptions {
  /** A pool to ask instead; it is left running. */
  pool?: Pool;
  /** The growth step to look at; the last one if it is left out. */
  step?: number | null;
  /** Ends the sweep: it rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Is told the share of the plants that are done, 0 to 1. */
  onProgress?: (share: number) => void;
}

/** A row without a plant. */
export interface SweepProblem {
  /** Its number, from 0. */
  row: number;
  /** Why, in a sentence or several. */
  message: string;
  /** Every problem with its params; empty where it was not for them. */
  issues: readonly Issue[];
}

/** The results, a row a plant. Of a grid the last axis changes fastest; of a list, each of its params has a grid of its own. */
export interface Sweep {
  /** How many rows there are. */
  rows: number;
  /** What each swept parameter is in every row, by its path; numbers as a Float64Array. */
  axes: Record<string, ArrayLike<AnyValue>>;
  /** Every measure of every plant; NaN where there is no plant. */
  columns: Record<keyof Measures, Float64Array>;
  /** How each plant was solved; null where there is none. */
  status: (Status | null)[];
  /** The rows without a plant, in their order. */
  problems: SweepProblem[];
}

/**
 * Grows the plant of every combination. `start` makes the pool, if none is given. A row whose params are bad is a problem of this
 * row alone. A plant whose worker died is tried once more.
 * @throws {BoughError} if an axis is no parameter
 */
export async function sweepOver(
  start: (options: PoolOptions) => Promise<Pool>,
  params: ParamsInput | readonly ParamsInput[],
  axes: SweepAxes,
  options: SweepOptions,
): Promise<Sweep> {
  const { step = null, signal, onProgress } = options;
  signal?.throwIfAborted();
  const plan = new Plan(Array.isArray(params) ? params : [params as ParamsInput], axes);
  const pool = options.pool ?? (await start(options));
  const { rows } = plan;
  const columns = emptyColumns(rows);
  const status: (Status | null)[] = new Array(rows).fill(null);
  const problems: SweepProblem[] = [];
  let next = 0;
  let done = 0;
  /** Takes one row after the other. There are some more of these than workers, so that none waits for us. */
  const take = async () => {
    while (next < rows) {
      const row = next++;
      try {
        const plant = await persistently(() =>
          pool.plant(plan.paramsOf(row), step, signal ? { signal } : {}),
        );
        status[row] = plant.report.status;
        const measures = measuresOf(plant);
        for (const name of measureNames) columns[name][row] = measures[name];
      } catch (error) {
        if (!(error instanceof BoughError || error instanceof LostError)) throw error;
        problems.push({
          row,
          message: error.message,
          issues: error instanceof BoughError ? error.issues : [],
        });
      }
      onProgress?.(++done / rows);
    }
  };
  try {
    await Promise.all(Array.from({ length: 2 * pool.size }, take));
  } finally {
    // Nobody starts anything any more, whoever has failed.
    next = rows;
    if (!options.pool) pool.dispose();
  }
  return {
    rows,
    axes: plan.columns(),
    columns,
    status,
    problems: problems.sort((a, b) => a.row - b.row),
  };
}

function emptyColumns(rows: number): Sweep["columns"] {
  const columns = measureNames.map((name) => [name, new Float64Array(rows).fill(Number.NaN)]);
  return Object.fromEntries(columns) as Sweep["columns"];
}

/** Tries once more when a worker died. */
async function persistently<Result>(ask: () => Promise<Result>): Promise<Result> {
  try {
    return await ask();
  } catch (error) {
    if (error instanceof LostError) return ask();
    throw error;
  }
}

/** Which params each row has. */
class Plan {
  readonly rows: number;
  readonly #bases: readonly ParamsInput[];
  readonly #axes: readonly { path: string; values: ArrayLike<AnyValue> }[];
  /** Rows of one grid. */
  readonly #grid: number;

  constructor(bases: readonly ParamsInput[], axes: SweepAxes) {
    const unknown = Object.keys(axes).filter((path) => !parameterAt(path));
    if (unknown.length > 0) {
      throw new BoughError(
        unknown.map((path) => {
          const message = `${path} is not a parameter, so it cannot be swept.`;
          return { code: "unknownKey", path, value: axes[path], message };
        }),
      );
    }
    this.#bases = bases;
    this.#axes = Object.entries(axes).map(([path, values]) => ({ path, values }));
    this.#grid = this.#axes.reduce((product, { values }) => product * values.length, 1);
    this.rows = bases.length * this.#grid;
  }

  paramsOf(row: number): ParamsInput {
    const groups: Record<string, Record<string, unknown>> = { ...this.#bases[Math.floor(row / this.#grid)] };
    for (const { path, value } of this.#valuesOf(row)) {
      const [group, field] = groupAndField(path);
      groups[group] = { ...groups[group], [field]: value };
    }
    return groups as ParamsInput;
  }

  columns(): Record<string, ArrayLike<AnyValue>> {
    const columns: Record<string, AnyValue[]> = {};
    for (const { path } of this.#axes) columns[path] = [];
    for (let row = 0; row < this.rows; row++) {
      for (const { path, value } of this.#valuesOf(row)) columns[path]?.push(value);
    }
    const typed = Object.entries(columns).map(([path, values]) => {
      const isNumeric = values.every((value) => typeof value === "number");
      return [path, isNumeric ? Float64Array.from(values as number[]) : values];
    });
    return Object.fromEntries(typed);
  }

  #valuesOf(row: number): { path: string; value: AnyValue }[] {
    let rest = row % this.#grid;
    let size = this.#grid;
    return this.#axes.map(({ path, values }) => {
      size /= values.length;
      const value = values[Math.floor(rest / size)] as AnyValue;
      rest %= size;
      return { path, value };
    });
  }
}
