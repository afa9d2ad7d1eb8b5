/**
 * Whether unknown JavaScript values have the structure of params. Numbers, NaN and Infinity included, pass on to
 * the core, which knows the ranges.
 */
import {
  type AnyValue,
  declaredParameters,
  groupAndField,
  type PointForce,
  type Vector,
} from "./declaration.ts";
import type { Issue } from "./issue.ts";
import { nearest } from "./nearest.ts";
import { assemble, type Params } from "./params.ts";
import { described, shortened, wanted } from "./wording.ts";

/** What could be read of given params. */
export interface Structure {
  /** Complete params; what is missing or has the wrong structure is at its default. */
  params: Params;
  /** Every problem: parameters in declared order, then unknown keys. */
  issues: Issue[];
}

type Declared = (typeof declaredParameters)[number];

/** Most unknown keys that are listed one by one. */
const MOST_UNKNOWN_KEYS = 50;

const groups = new Map<string, string[]>();
for (const { path } of declaredParameters) {
  const [group, field] = groupAndField(path);
  groups.set(group, [...(groups.get(group) ?? []), field]);
}
const paths = declaredParameters.map(({ path }) => path);

/** Reads params from any value. Never throws, whatever the value is. */
export function structure(input: unknown): Structure {
  const issues: Issue[] = [];
  const given = objectAt("", input, issues);
  const fieldsOf = new Map<string, Reading>();
  for (const group of groups.keys()) {
    const content = given.value(group, group, issues);
    fieldsOf.set(group, content === undefined ? nothing : objectAt(group, content, issues));
  }
  const params = assemble((parameter) => {
    const [group, field] = groupAndField(parameter.path);
    return valueFrom(parameter, fieldsOf.get(group)?.value(parameter.path, field, issues), issues);
  });
  issues.push(...unknownKeys(given, fieldsOf));
  return { params, issues };
}

/** An object's own values, read without ever throwing. */
interface Reading {
  keys: readonly string[];
  /** The value of a key, undefined when it is missing or unreadable. */
  value(path: string, key: string, issues: Issue[]): unknown;
}

const nothing: Reading = { keys: [], value: () => undefined };

/** The given value as a plain object; anything else is an issue, and reads as empty. */
function objectAt(path: string, given: unknown, issues: Issue[]): Reading {
  const name = path === "" ? "params" : path;
  try {
    if (Object.prototype.toString.call(given) !== "[object Object]") {
      const message = `${name} must be an object with named values; it is ${described(given)}.`;
      issues.push({ code: "wrongType", path, value: given, message });
      return nothing;
    }
    const source = given as Record<string, unknown>;
    return { keys: Object.keys(source), value: (...reading) => read(source, ...reading) };
  } catch (error) {
    issues.push(unreadable(path, name, given, error));
    return nothing;
  }
}

/** Inherited values do not count: `__proto__` is an unknown key like any other. */
function read(source: Record<string, unknown>, path: string, key: string, issues: Issue[]): unknown {
  try {
    return Object.hasOwn(source, key) ? source[key] : undefined;
  } catch (error) {
    issues.push(unreadable(path, path, undefined, error));
    return undefined;
  }
}

function unreadable(path: string, name: string, value: unknown, error: unknown): Issue {
  const reason = error instanceof Error ? `: ${shortened(String(error.message))}` : "";
  return { code: "unreadable", path, value, message: `${name} cannot be read${reason}.` };
}

/** A parameter's value, or its default with an issue. */
function valueFrom(parameter: Declared, given: unknown, issues: Issue[]): AnyValue {
  if (given === undefined) return parameter.default;
  const value = parsed(parameter, given);
  if (value !== undefined) return value;
  issues.push(wrongValue(parameter, given));
  return parameter.default;
}

function parsed({ kind, options = [] }: Declared, given: unknown): AnyValue | undefined {
  switch (kind) {
    case "number":
    case "integer":
      return typeof given === "number" ? unsigned(given) : undefined;
    case "optional":
      // NaN is no number here: in the flat form it stands for none.
      return given === null
        ? null
        : typeof given === "number" && !Number.isNaN(given)
          ? unsigned(given)
          : undefined;
    case "flag":
      return typeof given === "boolean" ? given : undefined;
    case "choice":
      return typeof given === "string" && options.includes(given) ? given : undefined;
    case "vector":
      return vector(given);
    case "forces":
      return forces(given);
  }
}

/** Forces on segments; of the wrong structure as a whole when one is. */
function forces(given: unknown): PointForce[] | undefined {
  try {
    if (!Array.isArray(given)) return undefined;
    // A hole in the list is a value, too.
    const read = Array.from(given, (one: unknown): PointForce | undefined => {
      const { segment, force } = Object(one) as { segment?: unknown; force?: unknown };
      const components = vector(force);
      return typeof segment === "number" && components
        ? { segment: unsigned(segment), force: components }
        : undefined;
    });
    return read.every((one) => one !== undefined) ? read : undefined;
  } catch {
    return undefined;
  }
}

function vector(given: unknown): Vector | undefined {
  try {
    if (!Array.isArray(given) || given.length !== 3) return undefined;
    const [x, y, z] = given as unknown[];
    if (typeof x !== "number" || typeof y !== "number" || typeof z !== "number") return undefined;
    return [unsigned(x), unsigned(y), unsigned(z)];
  } catch {
    return undefined;
  }
}

/** Negative zero is zero: a link cannot tell them apart, and a plant should not either. */
function unsigned(number: number): number {
  return number + 0;
}

function wrongValue(parameter: Declared, value: unknown): Issue {
  const { kind, path, min, max } = parameter;
  const isText = kind === "choice" && typeof value === "string";
  const message = `${path} must be ${wanted(parameter)}; it is ${described(value)}.`;
  const issue: Issue = { code: isText ? "notAnOption" : "wrongType", path, value, message };
  return kind === "choice" || kind === "flag" ? issue : { ...issue, min, max };
}

function unknownKeys(given: Reading, fieldsOf: ReadonlyMap<string, Reading>): Issue[] {
  const strays = [{ group: "", reading: given, known: [...groups.keys()] }];
  for (const [group, known] of groups) strays.push({ group, reading: fieldsOf.get(group) ?? nothing, known });
  const unknown = strays.flatMap(({ group, reading, known }) =>
    reading.keys.filter((key) => !known.includes(key)).map((key) => ({ group, reading, known, key })),
  );
  const issues = unknown.slice(0, MOST_UNKNOWN_KEYS).map(({ group, reading, known, key }): Issue => {
    const path = group === "" ? shortened(key) : `${group}.${shortened(key)}`;
    const message = paths.includes(key)
      ? `${key} must stand inside its group: {${key.replace(".", ": {")}: …}}.`
      : `${path} is not a parameter; ${hint(group, known, key)}`;
    return { code: "unknownKey", path, value: reading.value(path, key, []), message };
  });
  if (unknown.length > MOST_UNKNOWN_KEYS) {
    const message = `${unknown.length - MOST_UNKNOWN_KEYS} more keys are unknown.`;
    issues.push({ code: "unknownKey", path: "", value: undefined, message });
  }
  return issues;
}

function hint(group: string, known: readonly string[], key: string): string {
  const near = nearest(key, known);
  const sibling = near !== undefined && group !== "" ? `${group}.${near}` : near;
  const meant = sibling ?? elsewhere(key);
  return meant === undefined
    ? `${group || "params"} may hold ${known.join(", ")}.`
    : `did you mean ${meant}?`;
}

/** The right name in the wrong group: `{gravity: 3}` means `loads.gravity`. */
function elsewhere(key: string): string | undefined {
  return paths.find((path) => groupAndField(path)[1] === key) ?? nearest(key, paths);
}
