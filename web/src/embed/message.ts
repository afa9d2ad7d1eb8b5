/** What the page around an embedded plant can say, and what it is answered. Version 1. */
import type { Issue } from "../params/issue.ts";

/** Names a message in the answer to it. */
export type Id = string | number;

/** What may be asked, once its shape has been checked. */
export type Ask =
  | { readonly type: "get"; readonly id?: Id; readonly follow?: boolean }
  | { readonly type: "set"; readonly id?: Id; readonly change: Change };

/** What can be set: the element's properties of these names. */
export type Change = Readonly<Partial<Record<keyof typeof kinds, unknown>>>;

/** Something that cannot be answered. */
export interface Refusal {
  readonly type: "error";
  readonly id?: Id;
  readonly message: string;
  readonly issues: readonly Issue[];
}

/** What each property takes. */
const kinds = {
  link: "text",
  preset: "text",
  params: "object",
  step: "number",
  view: "text",
  color: "text",
  drawing: "text",
  theme: "text",
  controls: "text",
  plays: "flag",
} as const;

/** Longest text that is read. */
const longest = 10_000;

/** Reads a message of any kind; null is one that is not meant for us. Never throws. */
export function read(data: unknown): Ask | Refusal | null {
  if (!isRecord(data) || !("bough" in data)) return null;
  const { bough, type, id: given, ...rest } = data;
  const id = isId(given) ? { id: given } : {};
  const refuse = (message: string): Refusal => ({ ...id, type: "error", message, issues: [] });
  if (bough !== 1) return refuse("Only version 1 of the protocol is spoken here: bough must be 1.");
  if (given !== undefined && !isId(given))
    return refuse("id must be a number or a text of at most 100 letters.");
  if (type === "get") {
    const { follow, ...others } = rest;
    if (follow !== undefined && typeof follow !== "boolean") return refuse("follow must be true or false.");
    const [stray] = Object.keys(others);
    if (stray !== undefined) return refuse(`get takes nothing but follow; ${shortened(stray)} is not known.`);
    return { ...id, type, ...(follow !== undefined && { follow }) };
  }
  if (type !== "set") return refuse("type must be get or set.");
  for (const [key, value] of Object.entries(rest)) {
    if (!Object.hasOwn(kinds, key)) {
      return refuse(`There is no ${shortened(key)} to set; there are ${Object.keys(kinds).join(", ")}.`);
    }
    const kind = kinds[key as keyof typeof kinds];
    if (value !== null && !fits(value, kind)) return refuse(`${key} must be ${wanted[kind]}, or null.`);
  }
  return { ...id, type, change: rest };
}

const wanted = {
  text: `a text of at most ${longest} letters`,
  object: "an object",
  number: "a number",
  flag: "true or false",
} as const;

function fits(value: unknown, kind: keyof typeof wanted): boolean {
  switch (kind) {
    case "text":
      return typeof value === "string" && value.length <= longest;
    case "object":
      return isRecord(value);
    case "number":
      return typeof value === "number";
    case "flag":
      return typeof value === "boolean";
  }
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return Object.prototype.toString.call(value) === "[object Object]";
}

function isId(value: unknown): value is Id {
  return typeof value === "number" || (typeof value === "string" && value.length <= 100);
}

function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}
