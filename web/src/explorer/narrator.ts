/** Says in words what is shown, once it is at rest: not at every tick. */

/** After this rest. ms */
const quiet = 700;

export class Narrator {
  /** What was said last. */
  text = "";
  readonly #onText: (text: string) => void;
  #silence: ReturnType<typeof setTimeout> | undefined;

  /** `onText` is told what is to be said. */
  constructor(onText: (text: string) => void) {
    this.#onText = onText;
  }

  /** Takes what there is to say, in case that it stays so; null while all is on the move. */
  follow(words: (() => string) | null): void {
    clearTimeout(this.#silence);
    if (words) this.#silence = setTimeout(() => this.#say(words()), quiet);
  }

  #say(text: string): void {
    if (text === this.text) return;
    this.text = text;
    this.#onText(text);
  }
}
