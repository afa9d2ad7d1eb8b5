/** The plant as a document: JSON that opens to the same again. No DOM. */
import { presetNamed, version } from "../params/declaration.ts";
import { stepsOf } from "../params/params.ts";
import { colors, type State, styles, views } from "../params/state.ts";
import { structure } from "../params/structure.ts";

const format = "bough-plant";
/** Counts the ways in which it was ever written. */
const edition = 1;
/** What is larger than this was not written here. bytes */
export const largest = 1_000_000;

/** The document of a state. Theme and language are the reader's own. */
export function documentOf({ preset, params, step, view, color, style }: State): string {
  const document = { format, edition, bough: version, preset, params, step, view, color, style };
  return `${JSON.stringify(document, null, 2)}\n`;
}

/** Why a text is no document of ours. */
export type Refusal = "notJson" | "notAPlant" | "newer";

/**
 * What a document says: params as they stand there, to be checked, and the rest of the state as far as it is known here.
 * Plain params, as programs write them, are a document too.
 */
export function read(text: string): { params: unknown; state: Partial<State> } | Refusal {
  let content: unknown;
  try {
    content = JSON.parse(text.replace(/^\uFEFF/, ""));
  } catch {
    return "notJson";
  }
  if (Object.prototype.toString.call(content) !== "[object Object]") return "notAPlant";
  const document = content as Record<string, unknown>;
  if (!("format" in document)) return { params: document, state: { preset: null, step: null } };
  if (document.format !== format || typeof document.edition !== "number") return "notAPlant";
  if (document.edition > edition) return "newer";
  const { params, preset, step, view, color, style } = document;
  const last = stepsOf(structure(params).params);
  const isStep = typeof step === "number" && Number.isInteger(step) && step >= 1 && step <= last;
  return {
    params,
    state: {
      preset: typeof preset === "string" && presetNamed(preset) ? preset : null,
      step: isStep ? step : null,
      ...named("view", view, views),
      ...named("color", color, colors),
      ...named("style", style, styles),
    },
  };
}

function named<Key extends string, Name extends string>(
  key: Key,
  given: unknown,
  names: readonly Name[],
): Partial<Record<Key, Name>> {
  const name = names.find((one) => one === given);
  return (name === undefined ? {} : { [key]: name }) as Partial<Record<Key, Name>>;
}
