/** What is wrong with an entry, in the language that is spoken. */
import { local } from "../language/number.ts";
import { dictionary, filled } from "../language/say.ts";
import { parameterAt } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import { described, shortened, shown } from "../params/wording.ts";
import { unitText } from "./quantity.ts";
import { labelOf, nameOf } from "./words.ts";

/** The sentence on an issue; it names the parameter by its label. */
export function issueText({ code, path, value, message, max }: Issue): string {
  const known = dictionary()?.issues;
  const parameter = parameterAt(path);
  // The core's sentence names the parameter by its path; for a person its label is clearer.
  if (!known) return parameter ? message.replaceAll(path, parameter.label) : message;
  const pattern = known[`${code} ${path}`] ?? (parameter ? known.mustBe : known[code]) ?? message;
  const name = parameter ? labelOf(parameter) : shortened(path || "params");
  return filled(pattern, [name, wantedAt(path), givenText(value), local(shown(max ?? Number.NaN))]);
}

/** What a parameter takes: "a number from 0 to 1e6 m/s²". */
export function wantedAt(path: string): string {
  const parameter = parameterAt(path);
  const known = dictionary()?.issues;
  if (!parameter || !known) return "";
  const { kind, min, max, unit, options = [] } = parameter;
  const range = [local(shown(min)), local(shown(max)), unit && ` ${unitText(unit)}`];
  return filled(known[kind] ?? "", kind === "choice" ? [options.map(nameOf).join(", ")] : range);
}

function givenText(value: unknown): string {
  const known = dictionary()?.issues;
  if (typeof value === "string" && known?.text) return filled(known.text, [shortened(value)]);
  if (Array.isArray(value) && known?.list) return filled(known.list, [value.length]);
  if (typeof value === "object" && value !== null && known?.object) return known.object;
  return typeof value === "number" ? local(shown(value)) : described(value);
}
