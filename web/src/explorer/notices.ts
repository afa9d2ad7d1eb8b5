/** Sentences to a person. */
import type { Notice } from "./model.ts";

export class Notices {
  #list: readonly Notice[] = [];
  readonly #onChange: () => void;

  /** `onChange` is told when there are others than before. */
  constructor(onChange: () => void) {
    this.#onChange = onChange;
  }

  /** All that have not been dismissed, the oldest first. */
  get list(): readonly Notice[] {
    return this.#list;
  }

  /** Says a sentence, unless it is being said already. */
  add(text: string, { tone = "info", passes = false }: Partial<Notice> = {}): void {
    if (this.#list.some((notice) => notice.text === text)) return;
    this.#list = [...this.#list, { text, tone, passes }];
    this.#onChange();
  }

  /** Says a sentence in the place of another one; null is none. */
  replace(old: string | null, text: string | null): void {
    if (old === text) return;
    if (old !== null) this.dismiss((notice) => notice.text === old);
    if (text !== null) this.add(text);
  }

  /** Takes sentences back. */
  dismiss(which: (notice: Notice) => boolean): void {
    const left = this.#list.filter((notice) => !which(notice));
    if (left.length === this.#list.length) return;
    this.#list = left;
    this.#onChange();
  }
}
