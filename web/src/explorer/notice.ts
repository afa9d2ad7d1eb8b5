/** What a link said that could not be taken, in the language that is spoken. */
import { wantedAt } from "../form/issue.ts";
import { labelOf } from "../form/words.ts";
import { local } from "../language/number.ts";
import { dictionary, say } from "../language/say.ts";
import { parameters } from "../params/declaration.ts";
import { LINK_VERSION, type Notice } from "../params/link.ts";
import { valueAt } from "../params/params.ts";
import { colors, languages, type State, styles, themes, views } from "../params/state.ts";
import { shortened, shown } from "../params/wording.ts";

const names: Readonly<Record<string, readonly string[]>> = {
  view: views,
  color: colors,
  style: styles,
  theme: themes,
  lang: languages,
};

/** The sentence on it; `state` is what was made of the link. */
export function noticeText({ code, key, value, message }: Notice, state: State): string {
  if (!dictionary()) return message;
  const text = shortened(value);
  switch (code) {
    case "version":
      return say(
        "The link is of version {0}, which is not known here; it is read as version {1}.",
        text,
        LINK_VERSION,
      );
    case "unknownKey":
      return say("The link's {0} means nothing here and is ignored.", key);
    case "unknownPreset":
      return say("There is no preset {0}; the default plant is taken instead.", text);
    case "repeated":
      return say("The link gives {0} more than once; the last one, {1}, is taken.", key, text);
    default:
      return repaired(key, text, state);
  }
}

/** A value that was none of its kind, and what was taken instead. */
function repaired(key: string, text: string, state: State): string {
  const parameter = parameters.find((one) => one.key === key);
  if (parameter) {
    const value = valueAt(state.params, parameter.path);
    const taken = typeof value === "number" ? local(shown(value)) : String(value);
    const wanted = wantedAt(parameter.path);
    return say(
      "{0} is “{1}” in the link; it must be {2}, so {3} is taken.",
      labelOf(parameter),
      text,
      wanted,
      taken,
    );
  }
  if (key === "step") {
    const taken = state.step === null ? say("the full-grown plant") : say("step {0}", state.step);
    return say("step is “{0}” in the link, which is no growth step; {1} is shown.", text, taken);
  }
  const taken = String(state[key as keyof State]);
  return say(
    "{0} is “{1}” in the link; it must be one of {2}, so {3} is taken.",
    key,
    text,
    (names[key] ?? []).join(", "),
    taken,
  );
}
