/** Growth as an animated clip: the picture recorded while it plays, by the browser itself. */

/** What browsers record, best first. */
const types = [
  "video/mp4;codecs=avc1.42E01F",
  "video/webm;codecs=vp9",
  "video/webm;codecs=vp8",
  "video/webm",
];
/** Pictures a second, and how long the last one stays, ms. */
const [rate, rest] = [30, 800];

/** The type of clip this browser can record; null if it can record none. */
export function clipType(): string | null {
  const canCapture = "captureStream" in HTMLCanvasElement.prototype && typeof MediaRecorder === "function";
  return (canCapture && types.find((type) => MediaRecorder.isTypeSupported(type))) || null;
}

/** "mp4" or "webm". */
export function endingOf(type: string): string {
  return /^video\/(\w+)/.exec(type)?.[1] ?? "webm";
}

/** Records what is drawn on a canvas, on paper of a colour, until it is told to stop. */
export class Clip {
  /** Settles when the browser begins to record, which takes it a while: what is drawn earlier is lost. */
  readonly started: Promise<void>;
  readonly #source: HTMLCanvasElement;
  readonly #canvas = document.createElement("canvas");
  readonly #recorder: MediaRecorder;
  readonly #paper: string;
  readonly #parts: Blob[] = [];
  #request = 0;

  constructor(source: HTMLCanvasElement, paper: string, type: string) {
    this.#source = source;
    this.#paper = paper;
    // Most codecs take even sizes only.
    this.#canvas.width = source.width & ~1;
    this.#canvas.height = source.height & ~1;
    this.#draw();
    this.#recorder = new MediaRecorder(this.#canvas.captureStream(rate), {
      mimeType: type,
      videoBitsPerSecond: 8_000_000,
    });
    this.#recorder.addEventListener("dataavailable", ({ data }) => this.#parts.push(data));
    this.started = new Promise((resolve, reject) => {
      this.#recorder.addEventListener("start", () => resolve());
      this.#recorder.addEventListener("error", () => reject(new Error("The browser's recorder failed.")));
    });
    this.#recorder.start();
  }

  /** Ends the recording after a moment of rest; what was recorded. */
  async finish(): Promise<Blob> {
    await new Promise((resolve) => setTimeout(resolve, rest));
    const ended = new Promise((resolve) => this.#recorder.addEventListener("stop", resolve));
    this.cancel();
    await ended;
    return new Blob(this.#parts, { type: this.#recorder.mimeType });
  }

  /** Ends it at once. */
  cancel(): void {
    cancelAnimationFrame(this.#request);
    if (this.#recorder.state !== "inactive") this.#recorder.stop();
    for (const track of this.#recorder.stream.getTracks()) track.stop();
  }

  /** Draws all the time: recorders take no picture of what does not change. */
  #draw(): void {
    this.#request = requestAnimationFrame(() => this.#draw());
    const pen = this.#canvas.getContext("2d");
    if (!pen) return;
    pen.fillStyle = this.#paper;
    pen.fillRect(0, 0, this.#canvas.width, this.#canvas.height);
    pen.drawImage(this.#source, 0, 0, this.#canvas.width, this.#canvas.height);
  }
}
