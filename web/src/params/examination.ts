/** One list of everything that is wrong with given params: what their structure shows, and what the core finds. */
import { parameterAt } from "./declaration.ts";
import type { Issue } from "./issue.ts";
import { flatten, type Params, valueAt } from "./params.ts";
import { structure } from "./structure.ts";

/** Params whose structure has been checked, and not yet their ranges. */
export interface Examination {
  /** Complete params; values of the wrong structure are at their defaults. */
  params: Params;
  /**
   * The flat form for the core. A value of the wrong structure is NaN there, so that the core neither accepts it nor
   * looks at combinations with it.
   */
  flat: Float64Array<ArrayBuffer>;
  /** What the structure shows. */
  issues: readonly Issue[];
}

/** Checks the structure of any value. Never throws. */
export function examined(input: unknown): Examination {
  const { params, issues } = structure(input);
  const flat = flatten(params);
  for (const { path } of issues) {
    const parameter = parameterAt(path);
    if (!parameter) continue;
    // Where a number may be left open, NaN would say that it is.
    const nothing = parameter.kind === "optional" ? Number.POSITIVE_INFINITY : Number.NaN;
    flat.fill(nothing, parameter.offset, parameter.offset + parameter.width);
  }
  return { params, flat, issues };
}

/** All issues: of whole groups, then in declared order, then unknown keys. `found` is what the core says. */
export function allIssues({ params, issues }: Examination, found: readonly Issue[]): Issue[] {
  const misshapen = new Set(issues.map(({ path }) => path));
  const ranges = found
    .filter(({ path }) => !misshapen.has(path))
    .map((issue) => ({
      ...issue,
      value: issue.path === "loads.forces" ? params.loads.forces : valueAt(params, issue.path),
    }));
  return [...issues, ...ranges].sort((a, b) => rank(a) - rank(b));
}

function rank({ path, code }: Issue): number {
  if (code === "unknownKey") return Number.MAX_SAFE_INTEGER;
  return parameterAt(path)?.offset ?? -1;
}
