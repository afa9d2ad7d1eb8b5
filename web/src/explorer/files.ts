/** Files that come to the page: dropped, chosen, or pasted. */

/** Whether a file is a picture, by what the browser says of its type. */
export function isPicture({ type }: { type: string }): boolean {
  return type.startsWith("image/");
}

export class Files {
  readonly #open: (file: File) => boolean;
  readonly #waiting: File[] = [];

  /** `open` opens a file, or answers false while there is nobody yet who could. */
  constructor(open: (file: File) => boolean) {
    this.#open = open;
  }

  /** Takes what is dropped, wherever on the page (the browser would go there instead), and a picture that is pasted. */
  listen(): void {
    addEventListener("dragover", (event) => {
      if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
    });
    addEventListener("drop", (event) => {
      const files = [...(event.dataTransfer?.files ?? [])];
      const file = files.find(isPicture) ?? files[0];
      if (!file) return;
      event.preventDefault();
      this.take(file);
    });
    addEventListener("paste", (event) => {
      const file = [...(event.clipboardData?.files ?? [])].find(isPicture);
      if (file) this.take(file);
    });
  }

  /** Opens a file, now or when there is somebody who can. */
  take(file: File): void {
    if (!this.#open(file)) this.#waiting.push(file);
  }

  /** Now there is somebody more who opens files. */
  retry(): void {
    for (const file of this.#waiting.splice(0)) this.take(file);
  }
}
