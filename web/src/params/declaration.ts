/** The one declaration of every parameter, as the core prints it. Nothing in the page names a parameter twice. */
import { declaration } from "../../generated/declaration.ts";
import type { ParamsInput, PointForce } from "../../generated/params.ts";

/** What kind of value a parameter takes. */
export type Kind = "number" | "optional" | "integer" | "choice" | "flag" | "vector" | "forces";

/** Three numbers x, y, z. */
export type Vector = [x: number, y: number, z: number];

/** A parameter's value: a number (or none, if it may be left open), the name of an option, true or false, or three numbers. */
export type Value = number | string | boolean | Vector | null;

/** A value of any parameter, the lists that have no place in links and forms included. */
export type AnyValue = Value | readonly PointForce[];

export type { PointForce };

/** One parameter as declared. */
export interface Parameter {
  /** Where it stands in the params: `"axis.segmentLength"`. */
  path: string;
  /** Short key in a link. */
  key: string;
  /** Symbol used in the equations, or empty. */
  symbol: string;
  /** SI unit, `"deg"` for angles, empty for pure numbers. */
  unit: string;
  kind: Kind;
  /** The named options of a choice. */
  options?: readonly string[];
  default: Value;
  /** Smallest value that is accepted; of a vector, for each number. */
  min: number;
  /** Largest value that is accepted. */
  max: number;
  /** A friendly range, and how the travel maps to the value. */
  slider: { min: number; max: number; scale: "linear" | "log" };
  /** A word or two for a form. */
  label: string;
  /** Where its numbers begin in the flat form. */
  offset: number;
  /** How many numbers it takes in the flat form. */
  width: number;
}

/** A plant worth looking at. A released preset never changes. */
export interface Preset {
  /** A short title. */
  title: string;
  /** A sentence on what to see. */
  note: string;
  /** The params that differ from the defaults. */
  params: ParamsInput;
  /** The growth step to show, when it is not the last. */
  step?: number;
}

interface Declaration {
  version: string;
  flatLength: number;
  parameters: readonly Parameter[];
  presets: readonly (Preset & { id: string })[];
}

// Defaults and presets become parts of the params of plants, which users may write to: not to these.
const declared = frozen(declaration as Declaration);

/** Version of the core that was declared with. */
export const version: string = declared.version;

/** How many numbers complete params take in flat form. */
export const flatLength: number = declared.flatLength;

/** All parameters, lists included, in declared order. */
export const declaredParameters: readonly (Omit<Parameter, "default"> & { default: AnyValue })[] =
  declared.parameters;

/** The parameters that links carry and forms show, in declared order: all but lists. */
export const parameters: readonly Parameter[] = declared.parameters.filter(({ kind }) => kind !== "forces");

/** All presets by id, in the order in which they are shown. */
export const presets: Readonly<Record<string, Preset>> = frozen(
  Object.fromEntries(declared.presets.map(({ id, ...preset }) => [id, preset])),
);

const byPath = new Map(declared.parameters.map((parameter) => [parameter.path, parameter]));

/** The parameter with this path, if there is one. */
export function parameterAt(path: string): Parameter | undefined {
  return byPath.get(path);
}

/** The preset with this id, if there is one. */
export function presetNamed(id: string): Preset | undefined {
  return Object.hasOwn(presets, id) ? presets[id] : undefined;
}

/** A path's two parts: every parameter belongs to one group. */
export function groupAndField(path: string): [group: string, field: string] {
  const [group = "", field = ""] = path.split(".", 2);
  return [group, field];
}

/** A value that nobody can change any more, down to the last part. */
function frozen<Declared>(value: Declared): Declared {
  if (typeof value === "object" && value !== null) Object.values(Object.freeze(value)).forEach(frozen);
  return value;
}
