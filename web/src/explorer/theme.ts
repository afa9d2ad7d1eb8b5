/** Light or dark: what the state says, or else what the system says. */
import type { State } from "../params/state.ts";
import type { Tone } from "../scene/palette.ts";

export class Theme {
  /** What is in force. */
  tone: Tone = "light";
  readonly #system = matchMedia("(prefers-color-scheme: dark)");
  #wanted: State["theme"] = "auto";

  /** `onChange` is told when the system changes its mind, and that counts. */
  constructor(onChange: () => void) {
    this.#system.addEventListener("change", () => {
      if (this.#wanted !== "auto") return;
      this.apply("auto");
      onChange();
    });
  }

  /** Puts a theme in force for the whole page. */
  apply(wanted: State["theme"]): void {
    this.#wanted = wanted;
    this.tone = wanted === "auto" ? (this.#system.matches ? "dark" : "light") : wanted;
    document.documentElement.dataset.theme = this.tone;
  }
}
