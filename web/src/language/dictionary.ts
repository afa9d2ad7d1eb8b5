/** What another language must have words for. */
import type { Text } from "./english.ts";

export interface Dictionary {
  /** The texts of the page, by what they are in English; {0}, {1} are places for values. */
  readonly texts: Readonly<Record<Text, string>>;
  /** Label and help of each parameter, by path. */
  readonly parameters: Readonly<Record<string, readonly [label: string, help: string]>>;
  /** Title and note of each preset, by id. */
  readonly presets: Readonly<Record<string, readonly [title: string, note: string]>>;
  /** Names of groups and options, by identifier. */
  readonly names: Readonly<Record<string, string>>;
  /**
   * What is wrong with an entry, by code, or by code and path: {0} is the parameter, {1} what it takes, {2} what was given,
   * {3} the largest value that is possible.
   */
  readonly issues: Readonly<Record<string, string>>;
  /** Words of the sources: "section", "figures", "and". */
  readonly sources: Readonly<Record<string, string>>;
}
