/** The picture of a widget: printed when it is due and in view, kept when it is not. */
import type { Plant } from "../plant/plant.ts";
import type { Tone } from "../scene/palette.ts";
import { type Showing, Stage } from "../scene/stage.ts";
import type { Face } from "./face.ts";
import { sharedPress } from "./workshop.ts";

/** How long a press is kept for the next picture, ms: where each widget is a document of its own, each holds one of the few. */
const patience = 10_000;

/** Someone who waits for the picture to be done. */
interface Waiting {
  resolve(): void;
  reject(reason: Error): void;
}

export class Picture {
  readonly stage: Stage;
  readonly #face: Face;
  readonly #onFailure: (message: string) => void;
  readonly #waiting = new Set<Waiting>();
  readonly #end = new AbortController();
  #timer: ReturnType<typeof setTimeout> | undefined;
  #inView = false;
  #isStuck = false;
  /** Why there is no picture at all. */
  #lack: string | null = null;

  /** `onTone` is told that the page has turned dark or light; `onFailure` why there is no picture. */
  constructor(face: Face, onTone: () => void, onFailure: (message: string) => void) {
    this.#face = face;
    this.#onFailure = onFailure;
    this.stage = new Stage(face.scene, null);
    this.stage.engaged = false;
    const { canvas } = this.stage;
    canvas.setAttribute("part", "picture");
    const { signal } = this.#end;
    canvas.addEventListener("bough-due", () => this.#supply(), { signal });
    canvas.addEventListener("bough-drawn", () => this.#rest(), { signal });
    canvas.addEventListener("bough-lost", () => this.stage.attach(null), { signal });
    face.tone.addEventListener("transitionend", onTone, { signal });
  }

  /** Whether the page is dark here; browsers that cannot tell have it light. */
  get tone(): Tone {
    return getComputedStyle(this.#face.tone).color === "rgb(4, 3, 2)" ? "dark" : "light";
  }

  /** Says what the picture shows. */
  set label(text: string) {
    this.stage.canvas.setAttribute("role", "img");
    this.stage.canvas.setAttribute("aria-label", text);
  }

  /** Whether anybody can see it. */
  set inView(inView: boolean) {
    this.#inView = inView;
    this.#isStuck = false;
    if (inView) this.#supply();
    else if (this.#waiting.size === 0) this.stage.attach(null);
  }

  /** Shows a plant; returns a sentence if that cannot be done as it is wanted. */
  show(plant: Plant, how: Omit<Showing, "tone">): string | null {
    const objection = this.stage.show(plant, { ...how, tone: this.tone });
    // The stage may have told of the picture that is due before it had a plant.
    this.#supply();
    return objection;
  }

  /** The picture once it is done, whether anybody sees it or not. */
  async toBlob(type: string, quality: number | undefined): Promise<Blob> {
    if (this.#lack !== null) throw new Error(this.#lack);
    if (this.stage.isDue || !this.#face.poster.hidden) {
      await new Promise<void>((resolve, reject) => {
        this.#waiting.add({ resolve, reject });
        this.#supply();
      });
    }
    const { canvas } = this.stage;
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, type, quality));
    if (!blob) throw new Error("The picture is too large for this browser to be saved.");
    return blob;
  }

  /** A plant is on its way: whoever asks for the picture may wait. */
  expect(): void {
    this.#lack = null;
  }

  /** Tells everyone who waits that there will be no picture. */
  giveUp(why: string): void {
    this.#lack = why;
    for (const { reject } of this.#waiting) reject(new Error(why));
    this.#waiting.clear();
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#end.abort();
    this.giveUp("The element was taken off the page.");
    this.stage.dispose();
    this.#face.poster.hidden = false;
  }

  /** Gives the stage the press, if it needs and may have it. */
  #supply(): void {
    clearTimeout(this.#timer);
    const isWanted = this.#inView || this.#waiting.size > 0;
    if (!isWanted || !this.stage.isDue || this.stage.press || this.#isStuck) return;
    try {
      this.stage.attach(sharedPress());
    } catch {
      this.#isStuck = true;
      const why = "This browser draws no 3D pictures (WebGL 2 is missing or switched off).";
      this.giveUp(why);
      this.#onFailure(why);
    }
  }

  #rest(): void {
    this.#face.poster.hidden = true;
    if (this.stage.moving) return;
    for (const { resolve } of this.#waiting) resolve();
    this.#waiting.clear();
    clearTimeout(this.#timer);
    if (this.#inView) this.#timer = setTimeout(() => this.stage.attach(null), patience);
    else this.stage.attach(null);
  }
}
