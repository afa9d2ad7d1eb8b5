/** All that a link holds: which plant, how old, and how it is looked at. */
import { presetNamed } from "./declaration.ts";
import { complete, defaults, type Params, sameParams } from "./params.ts";

/** The drawing: in the axis's plane, or in space. */
export const views = ["plane", "space"] as const;
/** What the plant's colour means. */
export const colors = ["bark", "moment", "stress", "curvature", "age"] as const;
/** How the plant is drawn: as limbs with what they bear, as bare limbs, or as the rods, springs and masses that are computed with. */
export const styles = ["limb", "bare", "model"] as const;
/** Light or dark, or as the reader's system has it. */
export const themes = ["auto", "light", "dark"] as const;

/** The language of the page, as a BCP 47 tag, or the reader's own. */
export const languages = ["auto", "en", "de", "fr", "es", "zh"] as const;

/** The state of the page. Immutable. */
export interface State {
  /** Id of the preset that the params started from, or null. */
  readonly preset: string | null;
  readonly params: Params;
  /** The growth step shown; null is full grown, however many steps that takes. */
  readonly step: number | null;
  readonly view: (typeof views)[number];
  readonly color: (typeof colors)[number];
  readonly style: (typeof styles)[number];
  readonly theme: (typeof themes)[number];
  readonly lang: (typeof languages)[number];
}

/** The state of the bare page. */
export const initialState: State = {
  preset: null,
  params: defaults,
  step: null,
  view: "plane",
  color: "bark",
  style: "limb",
  theme: "auto",
  lang: "auto",
};

/** What choosing a preset changes; null, or a name that does not exist, is the default plant. */
export function presetState(id: string | null): Pick<State, "preset" | "params" | "step"> {
  const preset = id === null ? undefined : presetNamed(id);
  if (!preset) return { preset: null, params: defaults, step: null };
  return { preset: id, params: complete(preset.params), step: preset.step ?? null };
}

/** Whether two states are equal. */
export function sameState(a: State, b: State): boolean {
  return (
    a.preset === b.preset &&
    a.step === b.step &&
    a.view === b.view &&
    a.color === b.color &&
    a.style === b.style &&
    a.theme === b.theme &&
    a.lang === b.lang &&
    sameParams(a.params, b.params)
  );
}
