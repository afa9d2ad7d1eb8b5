/** What the declaration says to people, in the language that is spoken. */
import { dictionary } from "../language/say.ts";
import { type Parameter, presets } from "../params/declaration.ts";

/** Names of groups, where the declaration has only identifiers. */
const names: Readonly<Record<string, string>> = {
  axis: "Axis",
  material: "Wood",
  tropism: "Direction of growth",
  growth: "Thickening",
  branching: "Branching",
  arrangement: "Arrangement",
  loads: "Loads",
  solver: "Computation",
};

/** The name of a group or an option: its own if it has one, else its words ("secondOrder" is "Second order"). */
export function nameOf(identifier: string): string {
  const words = identifier.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  const known = dictionary()?.names ?? names;
  return known[identifier] ?? `${words.charAt(0).toUpperCase()}${words.slice(1)}`;
}

/** The label of a parameter. */
export function labelOf({ path, label }: Pick<Parameter, "path" | "label">): string {
  return dictionary()?.parameters[path]?.[0] ?? label;
}

/** Title and note of a preset. */
export function presetWords(id: string): readonly [title: string, note: string] {
  const preset = presets[id];
  return dictionary()?.presets[id] ?? [preset?.title ?? id, preset?.note ?? ""];
}
