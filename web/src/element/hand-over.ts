/** Who has the picture: the page, which scrolls over it, or the reader, who turns and zooms it. */
import type { Stage } from "../scene/stage.ts";
import type { Face } from "./face.ts";

export class HandOver {
  readonly #face: Face;
  #end: AbortController | null = null;

  constructor(face: Face) {
    this.#face = face;
  }

  /** Hands the picture to the reader, until the focus or the pointer goes elsewhere, or Escape is pressed. */
  toReader(stage: Stage): void {
    if (this.#end) return;
    this.#end = new AbortController();
    const { signal } = this.#end;
    const { root, figure } = this.#face;
    const { canvas } = stage;
    const host = root.host as HTMLElement;
    signal.addEventListener("abort", () => {
      stage.engaged = false;
      canvas.tabIndex = -1;
      figure.classList.remove("active");
    });
    stage.engaged = true;
    canvas.tabIndex = 0;
    figure.classList.add("active");
    canvas.focus({ preventScroll: true });
    const goesElsewhere = ({ relatedTarget }: FocusEvent) =>
      !(relatedTarget instanceof Node && host.contains(relatedTarget));
    host.addEventListener("focusout", (event) => goesElsewhere(event) && this.toPage(), { signal });
    const isElsewhere = (event: Event) => !event.composedPath().includes(host);
    document.addEventListener("pointerdown", (event) => isElsewhere(event) && this.toPage(), { signal });
    figure.addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        this.toPage();
        this.#face.enter.focus({ preventScroll: true });
      },
      { signal },
    );
  }

  /** Gives it back. */
  toPage(): void {
    this.#end?.abort();
    this.#end = null;
  }
}
