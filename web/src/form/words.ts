/** Names for people, of options and groups, where the declaration has only identifiers. */

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

/** The name of an identifier: its own if it has one, else its words ("secondOrder" is "Second order"). */
export function nameOf(identifier: string): string {
  const words = identifier.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return names[identifier] ?? `${words.charAt(0).toUpperCase()}${words.slice(1)}`;
}
