/**
 * Says the texts of the page in the language that is spoken. English is written where it is used and is its own key; other
 * languages are dictionaries, loaded when they are first wanted (`load.ts`).
 */
import type { Dictionary } from "./dictionary.ts";
import type { Text } from "./english.ts";

let tag = "en";
let known: Dictionary | null = null;

/** Speaks a language from now on: its BCP 47 tag, and its words; English needs none. */
export function adopt(language: string, dictionary: Dictionary | null): void {
  tag = language;
  known = dictionary;
}

/** The language that is spoken, as a BCP 47 tag. */
export function language(): string {
  return tag;
}

/** Its words; null is English. */
export function dictionary(): Dictionary | null {
  return known;
}

/** A text of the page, with values in the places of {0}, {1} and so on. */
export function say(text: Text, ...values: readonly (string | number)[]): string {
  return filled(known?.texts[text] ?? text, values);
}

/** The same in pieces, for values that are not text. */
export function pieces(text: Text, ...values: readonly unknown[]): unknown[] {
  return (known?.texts[text] ?? text)
    .split(/\{(\d)\}/)
    .map((piece, place) => (place % 2 === 0 ? piece : values[Number(piece)]));
}

/** A pattern with its values. */
export function filled(pattern: string, values: readonly (string | number)[]): string {
  return pattern.replace(/\{(\d)\}/g, (_, place: string) => String(values[Number(place)] ?? ""));
}
