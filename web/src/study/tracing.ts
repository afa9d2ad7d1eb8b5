/** A photo under a person's clicks: laid over the picture, brought to scale, traced. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import type { Traced } from "../fit/line.ts";
import { quantityText } from "../form/quantity.ts";
import { measure } from "../geometry/measure.ts";
import { local } from "../language/number.ts";
import type { Vector } from "../params/declaration.ts";
import type { Plant } from "../plant/plant.ts";
import type { Stage } from "../scene/stage.ts";
import type { Project } from "./desk.ts";
import { drawHandle, placeText } from "./handle.ts";
import { lineThrough } from "./overlay.ts";
import {
  changedAround,
  type Frame,
  movedTo,
  type Photo,
  type Pixel,
  readPhoto,
  toPhoto,
  toWorld,
} from "./photo.ts";
import { words } from "./words.ts";

/** What a click on the picture does. */
const modes = ["pull", "move", "base", "scale", "trace"] as const;
type Mode = (typeof modes)[number];

/** Without a photo, points are kept in the world as they are. */
const plain: Frame = { x: 0, y: 0, size: 1, turn: 0 };
/** A photo fills so much of the picture's height at first. */
const filled = 0.8;

export class Tracing {
  readonly #stage: Stage;
  readonly #plant: () => Plant | null;
  readonly #onChange: () => void;
  #photo: Photo | null = null;
  #frame: Frame = plain;
  #opacity = 0.6;
  #mode: Mode = "pull";
  /** The traced points, and the ends of the known length, on the photo. */
  #points: Pixel[] = [];
  #known: Pixel[] = [];
  #length = "0.1";
  #problem: string | null = null;
  #grasped: Pixel | null = null;

  constructor(stage: Stage, plant: () => Plant | null, onChange: () => void) {
    this.#stage = stage;
    this.#plant = plant;
    this.#onChange = onChange;
  }

  /** The traced points, m. */
  get traced(): Traced[] {
    return this.#points.map((pixel) => toWorld(this.#frame, pixel));
  }

  /** The width of a pixel of the photo, m; null without one. */
  get pixel(): number | null {
    return this.#photo && this.#frame.size;
  }

  /** Lays a photo over the picture, or says why that cannot be done. */
  async take(file: File): Promise<void> {
    this.#problem = null;
    try {
      const photo = await readPhoto(file);
      this.#drop();
      this.#photo = photo;
      this.#mode = "base";
      const { left, right, top, bottom } = this.#stage.canvas.getBoundingClientRect();
      const at = (x: number, y: number) => this.#stage.unproject(x, y, [0, 0, 0]);
      const [low, high] = [at((left + right) / 2, bottom), at((left + right) / 2, top)];
      const size = (filled * (high[1] - low[1])) / photo.height;
      const middle = (high[1] + low[1]) / 2;
      this.#frame = {
        x: low[0] - (size * photo.width) / 2,
        y: middle + (size * photo.height) / 2,
        size,
        turn: 0,
      };
    } catch (error) {
      this.#problem = error instanceof Error ? error.message : String(error);
    }
    this.#onChange();
    if (!this.#problem) return;
    // A photo may be dropped far from where its problem is said.
    await new Promise(requestAnimationFrame);
    document.querySelector("#photo-problem")?.scrollIntoView({ block: "nearest" });
  }

  #drop(): void {
    if (this.#photo) URL.revokeObjectURL(this.#photo.address);
    this.#photo = null;
    this.#frame = plain;
    this.#points = [];
    this.#known = [];
    if (this.#mode !== "trace") this.#mode = "pull";
    this.#onChange();
  }

  /** The base of the measured axis, m. */
  get #base(): { x: number; y: number } {
    const plant = this.#plant();
    const [x, y] = plant ? measure(plant).base : [0, 0];
    return { x, y };
  }

  render(): TemplateResult {
    const { measure: own } = words;
    const choose = (event: Event) => {
      const input = event.target as HTMLInputElement;
      const [file] = input.files ?? [];
      input.value = "";
      if (file) void this.take(file);
    };
    const offered = modes.filter((mode) => this.#photo || mode === "pull" || mode === "trace");
    return html`<h3>${own.photo}</h3>
      <p class="note">${own.photoNote}</p>
      <p class="deeds">
        <label class="file">${own.choose}<input class="visually-hidden" type="file" accept="image/*" @change=${choose} /></label>
        ${this.#photo ? html`<button type="button" @click=${() => this.#drop()}>${own.remove}</button>` : nothing}
      </p>
      ${this.#problem ? html`<p class="issue" id="photo-problem" role="alert">${this.#problem}</p>` : nothing}
      ${this.#photo ? this.#layout() : nothing}
      <fieldset class="modes">
        <legend>${own.click}</legend>
        ${offered.map(
          (mode) => html`<label class="option"
            ><input
              type="radio"
              name="click"
              .checked=${live(mode === this.#mode)}
              @change=${() => {
                this.#mode = mode;
                this.#onChange();
              }}
            />${own.modes[mode]}</label
          >`,
        )}
      </fieldset>
      ${this.#modeNote()}`;
  }

  #layout(): TemplateResult {
    const { measure: own } = words;
    const slider = (
      name: string,
      value: number,
      min: number,
      max: number,
      enter: (value: number) => void,
    ) => html`<label
      class="slide"
      >${name}<input
        type="range"
        min=${min}
        max=${max}
        step="any"
        .value=${live(String(value))}
        @input=${(event: Event) => {
          enter((event.target as HTMLInputElement).valueAsNumber);
          this.#onChange();
        }}
    /></label>`;
    return html`${slider(own.opacity, this.#opacity, 0, 1, (value) => {
      this.#opacity = value;
    })}
    ${slider(own.turn, (this.#frame.turn * 180) / Math.PI, -45, 45, (value) => {
      this.#frame = changedAround(this.#frame, this.#base, { turn: (value * Math.PI) / 180 });
    })}`;
  }

  #modeNote(): TemplateResult | typeof nothing {
    const { measure: own } = words;
    if (this.#mode === "base") return html`<p class="note">${own.baseNote}</p>`;
    if (this.#mode === "scale") {
      return html`<p class="note">${own.scaleNote}</p>
        <p class="deeds">
          <label class="known"
            >${own.known}
            <span class="box"
              ><input type="text" inputmode="decimal" .value=${live(this.#length)} @input=${(
                event: Event,
              ) => {
                this.#length = (event.target as HTMLInputElement).value;
              }}
            /></span
          ></label>
          <button type="button" ?disabled=${this.#known.length < 2} @click=${() => this.#setScale()}>${own.setScale}</button>
        </p>`;
    }
    if (this.#mode !== "trace") return nothing;
    const count = this.#points.length;
    const take = (points: Pixel[]) => {
      this.#points = points;
      this.#onChange();
    };
    return html`<p class="note">${own.traceNote}</p>
      <p class="deeds">
        <span role="status">${own.points(count)}</span>
        <button type="button" @click=${() => take([...this.#points, this.#next()])}>${own.add}</button>
        <button type="button" ?disabled=${count === 0} @click=${() => take(this.#points.slice(0, -1))}>${own.undo}</button>
        <button type="button" ?disabled=${count === 0} @click=${() => take([])}>${own.clear}</button>
      </p>`;
  }

  /** Where a point that is added without a pointer begins: beside the last one, or at the base. */
  #next(): Pixel {
    const last = this.#points[this.#points.length - 1];
    const from = last ? toWorld(this.#frame, last) : this.#base;
    const plant = this.#plant();
    const away = last && plant ? 0.05 * measure(plant).length : 0;
    return toPhoto(this.#frame, { x: from.x + away, y: from.y });
  }

  #setScale(): void {
    const length = Number(this.#length.replace(",", "."));
    const [a, b] = this.#known;
    if (!a || !b) return;
    const pixels = Math.hypot(b.u - a.u, b.v - a.v);
    if (!(length > 0 && Number.isFinite(length) && pixels > 0)) {
      this.#problem = words.measure.badLength;
    } else {
      this.#problem = null;
      this.#frame = changedAround(this.#frame, this.#base, { size: length / pixels });
      this.#known = [];
      this.#mode = "trace";
    }
    this.#onChange();
  }

  #pixelUnder(event: PointerEvent): Pixel {
    const [x, y] = this.#stage.unproject(event.clientX, event.clientY, [this.#base.x, this.#base.y, 0]);
    return toPhoto(this.#frame, { x, y });
  }

  #press(event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return;
    const pixel = this.#pixelUnder(event);
    switch (this.#mode) {
      case "move":
        this.#grasped = pixel;
        (event.currentTarget as Element).setPointerCapture(event.pointerId);
        return;
      case "base":
        this.#frame = movedTo(this.#frame, pixel, this.#base);
        break;
      case "scale":
        this.#known = this.#known.length < 2 ? [...this.#known, pixel] : [pixel];
        break;
      default:
        this.#points = [...this.#points, pixel];
    }
    this.#onChange();
  }

  #drag(event: PointerEvent): void {
    if (!this.#grasped || event.buttons === 0) return;
    const [x, y] = this.#stage.unproject(event.clientX, event.clientY, [this.#base.x, this.#base.y, 0]);
    this.#frame = movedTo(this.#frame, this.#grasped, { x, y });
    this.#onChange();
  }

  /** `isOpen`: whether clicks are wanted now. */
  draw(project: Project, isOpen: boolean): SVGTemplateResult {
    const at = (pixel: Pixel): Vector => {
      const { x, y } = toWorld(this.#frame, pixel);
      return [x, y, 0];
    };
    const handles = this.#points.map((pixel, index) =>
      drawHandle(
        {
          at: at(pixel),
          kind: "trace",
          name: words.measure.point(index + 1, placeText(at(pixel))),
          move: ([x, y]) => {
            this.#points = this.#points.map((old, k) => (k === index ? toPhoto(this.#frame, { x, y }) : old));
            this.#onChange();
          },
          remove: () => {
            this.#points = this.#points.filter((_, k) => k !== index);
            this.#onChange();
          },
        },
        this.#stage,
        project,
      ),
    );
    const known = this.#known.map((pixel) => project(at(pixel)));
    return svg`${this.#picture((pixel) => project(at(pixel)))}
      ${isOpen && this.#mode !== "pull" ? this.#sheet() : nothing}
      ${lineThrough(
        this.#points.map((pixel) => project(at(pixel))),
        "traced",
      )}
      ${lineThrough(known, "known")}
      ${known.map(({ x, y }) => svg`<circle class="known" cx=${x.toFixed(1)} cy=${y.toFixed(1)} r="4" />`)}
      ${isOpen ? handles : nothing}`;
  }

  #picture(place: (pixel: Pixel) => { x: number; y: number }): SVGTemplateResult | typeof nothing {
    const photo = this.#photo;
    if (!photo) return nothing;
    const [origin, right, down] = [
      place({ u: 0, v: 0 }),
      place({ u: photo.width, v: 0 }),
      place({ u: 0, v: photo.height }),
    ];
    const across = [(right.x - origin.x) / photo.width, (right.y - origin.y) / photo.width];
    const along = [(down.x - origin.x) / photo.height, (down.y - origin.y) / photo.height];
    const matrix = [...across, ...along, origin.x, origin.y].map((number) => number.toFixed(6)).join(" ");
    return svg`<image
      href=${photo.address}
      width=${photo.width}
      height=${photo.height}
      preserveAspectRatio="none"
      opacity=${this.#opacity.toFixed(2)}
      transform="matrix(${matrix})"
    />`;
  }

  /** What takes the clicks; the wheel goes on to the camera. */
  #sheet(): SVGTemplateResult {
    const pass = (event: WheelEvent) => {
      event.preventDefault();
      this.#stage.canvas.dispatchEvent(new WheelEvent("wheel", event));
    };
    return svg`<rect
      class="sheet ${this.#mode}"
      width="100%"
      height="100%"
      @pointerdown=${(event: PointerEvent) => this.#press(event)}
      @pointermove=${(event: PointerEvent) => this.#drag(event)}
      @pointerup=${() => {
        this.#grasped = null;
      }}
      @wheel=${pass}
    />`;
  }
}

/** "3.2 mm (2.1 px of the photo)". */
export function distanceText(meters: number, pixel: number | null): string {
  const text = quantityText(meters, "m", 2);
  return pixel ? `${text} (${local((meters / pixel).toFixed(1))} px)` : text;
}
