/** Which language to speak, and its dictionary when it is first wanted. */
import { languages } from "../params/state.ts";
import type { Dictionary } from "./dictionary.ts";
import { adopt, language } from "./say.ts";

type Language = Exclude<(typeof languages)[number], "auto">;

/** What each language is called by those who speak it. */
export const ownNames: Readonly<Record<Language, string>> = {
  en: "English",
  de: "Deutsch",
  fr: "Français",
  es: "Español",
  zh: "中文",
};

const dictionaries: Readonly<Record<Exclude<Language, "en">, () => Promise<Dictionary>>> = {
  de: async () => (await import("./german.ts")).german,
  fr: async () => (await import("./french.ts")).french,
  es: async () => (await import("./spanish.ts")).spanish,
  zh: async () => (await import("./chinese.ts")).chinese,
};

/** The language that is meant: the wanted one, or the first of the reader's own that there is. */
export function languageFor(wanted: (typeof languages)[number], own: readonly string[]): Language {
  if (wanted !== "auto") return wanted;
  const tags = own.map((tag) => tag.toLowerCase().split("-", 1)[0]);
  const known = languages.filter((one): one is Language => one !== "auto");
  return tags.flatMap((tag) => known.filter((one) => one === tag))[0] ?? "en";
}

/**
 * Speaks the language that is meant from now on, and says so to the page's readers. Returns whether it is another than before;
 * rejects, and changes nothing, when its dictionary cannot be loaded.
 */
export async function speak(wanted: (typeof languages)[number]): Promise<boolean> {
  const meant = languageFor(wanted, navigator.languages);
  if (meant === language()) return false;
  adopt(meant, meant === "en" ? null : await dictionaries[meant]());
  document.documentElement.lang = meant;
  return true;
}
