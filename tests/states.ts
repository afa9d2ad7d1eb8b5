/** Random valid params and states, and what makes them valid by the declaration alone. */
import fc from "fast-check";
import { type Parameter, parameters, presets, type Value } from "../web/src/params/declaration.ts";
import { assemble, type Params, stepsOf, valueAt } from "../web/src/params/params.ts";
import {
  colors,
  languages,
  presetState,
  type State,
  styles,
  themes,
  views,
} from "../web/src/params/state.ts";
import { structure } from "../web/src/params/structure.ts";

/** Any value of a parameter within its hard range; the ends, and numbers of all sizes, included. */
function anyValue({ kind, options = [], min, max }: Parameter): fc.Arbitrary<Value> {
  // Negative zero is zero in params.
  const number = fc.double({ min, max, noNaN: true }).map((value) => value + 0);
  switch (kind) {
    case "number":
      return number;
    case "optional":
      return fc.option(number);
    case "integer":
      return fc.integer({ min, max });
    case "choice":
      return fc.constantFrom(...options);
    case "flag":
      return fc.boolean();
    case "vector":
      return fc.tuple(number, number, number);
    case "forces":
      throw new Error("A list is not among the parameters that links carry.");
  }
}

const paths = parameters.map(({ path }) => path);
const anyChanges = fc.record(
  Object.fromEntries(parameters.map((parameter) => [parameter.path, anyValue(parameter)])),
);

/** Params with any number of values changed from a start; combinations that the core refuses included. */
export function anyParams(start: Params): fc.Arbitrary<Params> {
  return fc.tuple(anyChanges, fc.subarray(paths)).map(([changes, changed]) =>
    assemble(({ path }) => {
      const value = changed.includes(path) ? changes[path] : undefined;
      return value === undefined ? valueAt(start, path) : value;
    }),
  );
}

/** Any valid state. */
export const anyState: fc.Arbitrary<State> = fc
  .constantFrom(null, ...Object.keys(presets))
  .chain((preset) =>
    fc.record({ preset: fc.constant(preset), params: anyParams(presetState(preset).params) }),
  )
  .chain(({ preset, params }) =>
    fc.record({
      preset: fc.constant(preset),
      params: fc.constant(params),
      step: fc.option(fc.integer({ min: 1, max: Math.min(stepsOf(params), Number.MAX_SAFE_INTEGER) })),
      view: fc.constantFrom(...views),
      color: fc.constantFrom(...colors),
      style: fc.constantFrom(...styles),
      theme: fc.constantFrom(...themes),
      lang: fc.constantFrom(...languages),
    }),
  )
  .map((state) => ({ ...state }));

/** What is not valid about a state; empty when all is. */
export function faults({ preset, params, step, view, color, style, theme, lang }: State): string[] {
  const found = structure(params).issues.map(({ message }) => message);
  for (const { kind, path, min, max } of parameters) {
    const numbers = [valueAt(params, path)].flat().filter((value) => typeof value === "number");
    if (numbers.some((number) => !(number >= min && number <= max))) found.push(`${path} is out of range`);
    if (kind === "integer" && !numbers.every(Number.isInteger)) found.push(`${path} is not whole`);
  }
  if (preset !== null && !Object.hasOwn(presets, preset)) found.push("unknown preset");
  const stepIsValid = step === null || (Number.isInteger(step) && step >= 1 && step <= stepsOf(params));
  if (!stepIsValid) found.push(`no step ${step}`);
  const namesAreKnown =
    views.includes(view) &&
    colors.includes(color) &&
    styles.includes(style) &&
    themes.includes(theme) &&
    languages.includes(lang);
  if (!namesAreKnown) found.push("unknown name");
  return found;
}
