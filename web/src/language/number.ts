/** Numbers as the spoken language writes them. */
import { language } from "./say.ts";

const marks = new Map<string, string>();

/** A number that is written with a decimal point, with the mark of the language in its place. Thousands are not set apart. */
export function local(number: string): string {
  return number.replace(".", markOf(language()));
}

function markOf(tag: string): string {
  let mark = marks.get(tag);
  if (mark === undefined) {
    mark = new Intl.NumberFormat(tag).formatToParts(0.5).find(({ type }) => type === "decimal")?.value ?? ".";
    marks.set(tag, mark);
  }
  return mark;
}
