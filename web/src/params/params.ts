/** Params as immutable values: completing, reading, changing, and their flat form. */
import type { Params, ParamsInput, PresetId } from "../../generated/params.ts";
import {
  type AnyValue,
  declaredParameters,
  flatLength,
  groupAndField,
  type Parameter,
  type PointForce,
  parameters,
  type Value,
} from "./declaration.ts";

export type { Params, ParamsInput, PresetId };

type Groups = Record<string, Record<string, AnyValue>>;

/** What a value can be made for. */
type Declared = (typeof declaredParameters)[number];

/** Params made of one value for each parameter. */
export function assemble(valueFor: (parameter: Declared) => AnyValue): Params {
  const groups: Groups = {};
  for (const parameter of declaredParameters) {
    const [group, field] = groupAndField(parameter.path);
    // Own names only: whatever a page has put on all objects is no group.
    if (!Object.hasOwn(groups, group)) groups[group] = {};
    (groups[group] as Groups[string])[field] = valueFor(parameter);
  }
  return groups as unknown as Params;
}

/** The params with every value that was left out at its default. */
export function complete(input: ParamsInput): Params {
  const given = input as Partial<Record<string, Partial<Record<string, AnyValue>>>>;
  return assemble(({ path, default: fallback }) => {
    const [group, field] = groupAndField(path);
    return given[group]?.[field] ?? fallback;
  });
}

/** The params that `{}` stands for. */
export const defaults: Params = complete({});

/** The value at a path that links carry and forms show. */
export function valueAt(params: Params, path: string): Value {
  const [group, field] = groupAndField(path);
  const value = (params as unknown as Groups)[group]?.[field];
  if (value === undefined) throw new TypeError(`There is no parameter ${path}.`);
  return value as Value;
}

/** The params with another value at a path; the very same params when it is the same value. */
export function withValue(params: Params, path: string, value: Value): Params {
  if (sameValue(valueAt(params, path), value)) return params;
  const [group, field] = groupAndField(path);
  const groups = params as unknown as Groups;
  return { ...groups, [group]: { ...groups[group], [field]: value } } as unknown as Params;
}

/**
 * How many growth steps the finished plant takes, known before it is grown. The core's own count, which the contract
 * test compares it with, is only there once the wasm is.
 */
export function stepsOf({ axis, branching, arrangement }: Params): number {
  const forks = branching.pattern === "none" ? 0 : branching.generations;
  const { pattern, count, interval } = arrangement;
  let steps = pattern === "flexibleStem" ? (count - 1) * interval : 0;
  let scale = 1;
  for (let generation = 0; generation <= forks; generation++) {
    steps += Math.max(Math.round(axis.segments * scale), 1);
    scale *= branching.lengthRatio;
  }
  return steps;
}

/** Whether two values are equal, vectors by their numbers. */
export function sameValue(a: Value, b: Value): boolean {
  if (Array.isArray(a) && Array.isArray(b)) return a.every((number, index) => Object.is(number, b[index]));
  return Object.is(a, b);
}

/** Whether two complete params are equal. */
export function sameParams(a: Params, b: Params): boolean {
  if (a === b) return true;
  if (!parameters.every(({ path }) => sameValue(valueAt(a, path), valueAt(b, path)))) return false;
  return sameForces(a.loads.forces, b.loads.forces);
}

function sameForces(a: readonly PointForce[], b: readonly PointForce[]): boolean {
  if (a.length !== b.length) return false;
  return a.every(({ segment, force }, index) => {
    const other = b[index];
    return segment === other?.segment && sameValue(force, other.force);
  });
}

/**
 * The flat form in which params cross into the core: the numbers of each parameter in declared order, then segment, x, y,
 * z of each force on a segment.
 */
export function flatten(params: Params): Float64Array<ArrayBuffer> {
  const { forces } = params.loads;
  const flat = new Float64Array(flatLength + 4 * forces.length);
  for (const parameter of parameters) {
    flat.set(numbersOf(parameter, valueAt(params, parameter.path)), parameter.offset);
  }
  forces.forEach(({ segment, force }, index) => {
    flat.set([segment, ...force], flatLength + 4 * index);
  });
  return flat;
}

function numbersOf({ path, options }: Parameter, value: Value): number[] {
  if (Array.isArray(value)) return value;
  if (value === null) return [Number.NaN];
  if (typeof value !== "string") return [Number(value)];
  const index = options?.indexOf(value) ?? -1;
  if (index < 0) throw new TypeError(`${path} has no option ${value}.`);
  return [index];
}
