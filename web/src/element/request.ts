/** What an author asks of a widget, as it was written: nothing in it has been checked. */

/** The attributes that say something, and the properties of the same names. */
export const attributes = [
  "preset",
  "params",
  "link",
  "step",
  "view",
  "color",
  "drawing",
  "theme",
  "controls",
  "fields",
  "poster",
  "alt",
  "loading",
] as const;

/** Name of an attribute. */
export type Attribute = (typeof attributes)[number];

/** The attributes' texts; null is one that is not there. */
export type Request = Readonly<Record<Exclude<Attribute, "params">, string | null>> & {
  /** JSON as text, or the params themselves, if they were set as a property. */
  readonly params: unknown;
};
