/** The picture of a plant: everything that is drawn, in an element of the page. */
import type { Vector } from "../geometry/bounds.ts";
import type { Frame } from "../geometry/frame.ts";
import { paintOf } from "../geometry/legend.ts";
import { measure } from "../geometry/measure.ts";
import { mostModelled } from "../geometry/model.ts";
import { headingOf, type Pick, pick } from "../geometry/pick.ts";
import type { Color } from "../geometry/shade.ts";
import type { Axes } from "../geometry/tube.ts";
import { say } from "../language/say.ts";
import type { Plant } from "../plant/plant.ts";
import { Annotation, type Place } from "./annotation.ts";
import type { Bearing } from "./burden.ts";
import { Camera, type View } from "./camera.ts";
import type { Force } from "./force.ts";
import { Framing } from "./framing.ts";
import { Morph } from "./morph.ts";
import type { Tone } from "./palette.ts";
import { Press, type Sheet } from "./press.ts";
import { Projection } from "./projection.ts";
import { breakOf, lookOf, looksLike, lumpingOf, type Shown } from "./shown.ts";
import { unproject } from "./sight.ts";
import { placedAt } from "./world.ts";

/** How a plant is drawn: with leaves and fruit where it bears any, without, or as its model. */
export type Style = "limb" | "bare" | "model";

/** How a plant is shown. */
export interface Showing {
  /** The plant at full age: the frame fits it, and so stays still while younger ages are shown. */
  readonly grown: Plant;
  readonly view: View;
  /** What the plant's colour means; its own bark unless said otherwise. `legend` explains it. */
  readonly color?: Color;
  /** As limbs, unless said otherwise, with what they bear or bare, or as the model that was computed: segments, springs and masses. */
  readonly style?: Style;
  readonly tone: Tone;
  /** False in the midst of a gesture. */
  readonly settled: boolean;
  /** Whether the frame stays where it is, whatever sticks out: for a plant that a hand is on. */
  readonly still?: boolean;
  /** How long the passage from the growth step before may take, ms; 0 for a plant that is not replayed. */
  readonly passage: number;
}

/** Told with every drawn picture: the detail of the event `bough-drawn` on the canvas, which bubbles. */
export interface Drawn {
  /** From homogeneous world coordinates in m to clip coordinates, column by column. */
  readonly projection: readonly number[];
  /** Whether the next picture is already due. */
  readonly moving: boolean;
}

/** Draws leaves and fruit, once that is loaded: most plants bear none. */
let orchard: typeof import("./burden.ts") | null = null;

/** Most device pixels a CSS pixel: more cannot be seen, and costs with its square. */
const finest = 2;
/** So far beside a limb it is still meant. px */
const fingerBreadth = 22;

/**
 * Draws on demand: there are no frames while nothing changes. The canvas dispatches `bough-due` when a picture is asked
 * for, and `bough-drawn` when it is there, or `bough-idle` when it cannot be drawn now. The last good picture stays when the
 * press is taken away, and when the graphics card drops it: then the canvas dispatches `bough-lost`, later `bough-restored`.
 */
export class Stage {
  /** Takes the gestures and the keyboard focus. */
  readonly canvas: HTMLCanvasElement;
  readonly #host: HTMLElement;
  readonly #pen: CanvasRenderingContext2D;
  readonly #annotation = new Annotation();
  readonly #framing = new Framing();
  readonly #morph = new Morph();
  readonly #camera: Camera;
  readonly #resizes: ResizeObserver;
  readonly #stillness = matchMedia("(prefers-reduced-motion: reduce)");
  readonly #projection: Projection;
  #press: Press | null = null;
  #farewell = new AbortController();
  #force: Force | null = null;
  #request = 0;
  /** How often something that belongs into the picture is being loaded. */
  #expects = 0;
  #isDue = false;
  #density = 1;
  #shown: Shown | null = null;
  #sheet: { sheet: Sheet; shown: Shown } | null = null;

  /**
   * Fills an element, which must have a size of its own and be positioned. Without a press it has no pictures until it
   * gets one. Throws when the browser has no WebGL 2.
   */
  constructor(host: HTMLElement, press: Press | null = new Press()) {
    this.canvas = document.createElement("canvas");
    const pen = this.canvas.getContext("2d");
    if (!pen) throw new Error("This browser has no canvas to draw on.");
    this.#pen = pen;
    this.canvas.className = "picture";
    this.#host = host;
    host.append(this.canvas, this.#annotation.element);
    this.#camera = new Camera(this.canvas, () => this.#invalidate());
    this.#projection = new Projection(this.#camera.eye);
    // The browser may drop the canvas's own picture, too.
    this.canvas.addEventListener("contextrestored", () => this.#invalidate());
    this.#resizes = new ResizeObserver(() => this.#resize());
    this.#resizes.observe(host);
    this.#resize();
    this.attach(press);
  }

  /** The press that prints the pictures, if there is one. */
  get press(): Press | null {
    return this.#press;
  }

  /** Takes another press, or none: then the last picture stays. */
  attach(press: Press | null): void {
    if (press === this.#press) return;
    this.#farewell.abort();
    press?.join();
    this.#press?.leave();
    this.#press = press;
    if (!press) return;
    this.#farewell = new AbortController();
    const { signal } = this.#farewell;
    press.addEventListener("lost", () => this.#tell("bough-lost"), { signal });
    press.addEventListener("restored", () => this.#restore(), { signal });
    if (this.#isDue) this.#invalidate();
  }

  /** Whether the last picture of a plant is not what it should be: without a press it stays so. */
  get isDue(): boolean {
    return this.#isDue && this.#shown !== null;
  }

  /** Whether pointer, wheel and keys move the camera. Where they do not, a touch scrolls the page. */
  set engaged(engaged: boolean) {
    this.#camera.engaged = engaged;
  }

  /**
   * Shows a plant; the picture follows in the next frame. Returns a sentence if it cannot be drawn in the style that is
   * asked for, else null.
   */
  show(
    plant: Plant,
    { grown, view, color = "bark", style = "limb", tone, settled, still = false, passage }: Showing,
  ): string | null {
    const now = performance.now();
    const jumps = this.#shown === null || this.#stillness.matches;
    if (!still) this.#framing.aim({ plant, grown, settled, turns: view === "space" }, now);
    this.#camera.look(view, now, jumps);
    if (jumps) this.#framing.finish();
    if (this.#shown?.plant !== plant) this.#morph.turn(plant, now, jumps ? 0 : passage);
    const isTooMuch = style === "model" && plant.segments.point.length > mostModelled;
    const model = style === "model" && !isTooMuch ? lumpingOf(plant) : null;
    const bearing = style === "limb" ? this.#bearingOf(plant, grown) : null;
    this.#shown = { plant, grown, paint: paintOf(plant, color, grown), model, bearing, tone };
    this.#invalidate();
    return isTooMuch
      ? say("Above {0} segments the model cannot be made out: these are the limbs.", mostModelled)
      : null;
  }

  /** Another plant, which is drawn over the picture: the frame takes it in, unless the shown one were lost beside it. */
  set beside(plant: Plant | null) {
    this.#framing.takeIn(plant, performance.now());
    if (this.#stillness.matches) this.#framing.finish();
    this.#invalidate();
  }

  /** What a plant is seen to bear: nothing until it is known how to draw that, and then in another picture. */
  #bearingOf(plant: Plant, grown: Plant): Bearing | null {
    const { foliage, tipMass, removed } = plant.params.loads;
    if (removed || !(foliage > 0 || tipMass > 0)) return null;
    const old = this.#shown;
    if (old?.bearing && old.plant === plant && old.grown === grown) return old.bearing;
    if (orchard) return orchard.bearingOf(plant, grown);
    void this.#plantOrchard(plant, grown);
    return null;
  }

  async #plantOrchard(plant: Plant, grown: Plant): Promise<void> {
    this.#expects++;
    try {
      orchard = await import("./burden.ts");
      const shown = this.#shown;
      if (shown?.plant === plant && shown.grown === grown) {
        this.#shown = { ...shown, bearing: orchard.bearingOf(plant, grown) };
      }
    } catch {
      // Without the network the limbs are what there is to see.
    }
    this.#expects--;
    this.#invalidate();
  }

  /** Whether a picture is due. */
  get moving(): boolean {
    return this.#request !== 0 || this.#expects > 0;
  }

  /** Where a point of the world (m) is on the picture, in CSS px from its upper left corner. */
  project(point: Vector): Place {
    return this.#projection.place(point);
  }

  /**
   * The place on the plant under a pointer, or within a finger's breadth of it; null where there is none. Takes client
   * coordinates, as pointer events have them.
   */
  pick(clientX: number, clientY: number): Pick | null {
    const axes = this.#sheet?.sheet.axes;
    if (!axes) return null;
    const { x, y } = this.#onPicture(clientX, clientY);
    const projection = this.#projection;
    const sight = {
      toPicture: projection.picture.elements,
      scale: projection.pixelsPerMeter(this.#framing.at(performance.now())?.frame.height ?? 1),
      depth: projection.clip.elements[15] ?? 1,
      girth: this.#framing.girth,
    };
    return pick(axes, sight, x, y, fingerBreadth);
  }

  /**
   * The point of the world (m) under a pointer, on a vertical plane through a given point: in the plane view, that of the
   * picture; in the space view, that of the axis which bears the `segment`, or without one the plane that faces the eye.
   */
  unproject(clientX: number, clientY: number, through: Vector, segment?: number): Vector {
    const axes = this.#sheet?.sheet.axes;
    const own = axes && segment !== undefined ? headingOf(axes, segment) : null;
    const heading = this.#camera.view === "plane" ? ([1, 0, 0] as const) : own;
    return unproject(this.#projection.picture, this.#onPicture(clientX, clientY), through, heading);
  }

  /** What is written over the picture, in CSS px. */
  get annotation(): SVGSVGElement {
    return this.#annotation.element;
  }

  /**
   * The present picture once more on a canvas of its own, with `scale` pixels a CSS px; null before the first. It has a press of
   * its own, so that the size of this one is not kept. Throws a `RangeError` where the graphics card has no room for it.
   */
  reprint(scale: number): HTMLCanvasElement | null {
    const placed = this.#framing.at(performance.now());
    if (!placed || !this.#sheet) return null;
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(this.#projection.width * scale);
    canvas.height = Math.round(this.#projection.height * scale);
    const pen = canvas.getContext("2d");
    if (!pen) throw new RangeError("This browser has no canvas of that size.");
    const press = new Press();
    press.join();
    try {
      const { sheet, shown } = this.#sheet;
      const { foot } = this.#framing;
      press.print({ sheet, tone: shown.tone, frame: placed.frame, foot, eye: this.#camera.eye }, pen);
    } finally {
      press.leave();
    }
    return canvas;
  }

  /** Draws a force as an arrow with its size in newtons and grams-force, until another one or null is given. */
  showForce(force: Force | null): void {
    this.#force = force;
    this.#invalidate();
  }

  /** Shows the whole plant again after the camera was moved. */
  fit(): void {
    this.#camera.fit(performance.now(), this.#stillness.matches);
    this.#invalidate();
  }

  /** Comes closer by a factor, or goes away (below 1). */
  zoom(factor: number): void {
    this.#camera.zoom(factor);
    this.#invalidate();
  }

  /** Lets go of the press, and leaves the element. */
  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#resizes.disconnect();
    this.#camera.dispose();
    this.attach(null);
    this.canvas.remove();
    this.#annotation.element.remove();
  }

  #invalidate(): void {
    this.#isDue = true;
    if (this.#request !== 0) return;
    this.#request = requestAnimationFrame((now) => this.#draw(now));
    this.#tell("bough-due");
  }

  #draw(now: number): void {
    this.#request = 0;
    const placed = this.#framing.at(now);
    const shape = this.#morph.at(now);
    const press = this.#press?.isLost ? null : this.#press;
    if (!placed || !shape || !this.#shown || !press || this.#projection.width === 0) {
      this.#tell("bough-idle");
      return;
    }
    const turns = this.#camera.advance(now);
    this.#isDue = false;
    if (placed.moves || shape.moves || turns) this.#invalidate();
    const { frame } = placed;
    const { foot } = this.#framing;
    const { eye } = this.#camera;
    placedAt(frame, this.#projection.meters);
    const sheet = this.#sheetOf(shape.axes, this.#shown);
    // Only now, as it wipes the canvas.
    this.#sharpen();
    press.print({ sheet, tone: this.#shown.tone, frame, foot, eye }, this.#pen);
    this.#annotate(frame, shape.axes, this.#shown);
    const detail: Drawn = { projection: this.#projection.clip.toArray(), moving: this.moving };
    this.#tell("bough-drawn", detail);
  }

  /** Gives the canvas as many pixels as the screen has there. */
  #sharpen(): void {
    const of = this.#projection;
    const [width, height] = [of.width, of.height].map((size) => Math.round(size * this.#density));
    if (width && this.canvas.width !== width) this.canvas.width = width;
    if (height && this.canvas.height !== height) this.canvas.height = height;
  }

  /** What is to be printed; the very same as before, if nothing in it changed. */
  #sheetOf(axes: Axes, shown: Shown): Sheet {
    const { girth, extent } = this.#framing;
    const old = this.#sheet;
    const isSame = old?.sheet.axes === axes && old.sheet.look.girth === girth && looksLike(old.shown, shown);
    if (old && isSame) return old.sheet;
    const sheet = { axes, look: lookOf(shown, girth, extent) };
    this.#sheet = { sheet, shown };
    return sheet;
  }

  #annotate(frame: Frame, axes: Axes, { plant, grown, model }: Shown): void {
    const { base, heading } = measure(plant);
    const projection = this.#projection;
    this.#annotation.draw({
      frame,
      view: this.#camera.view,
      base,
      heading,
      present: projection.lines(axes),
      future: plant.report.steps < grown.report.steps ? projection.lines(grown) : [],
      elevation: plant.params.axis.elevation,
      girth: model ? 1 : this.#framing.girth,
      foot: this.#framing.foot,
      scale: projection.pixelsPerMeter(frame.height),
      force: this.#force,
      broken: breakOf(plant, axes),
      width: projection.width,
      height: projection.height,
      project: (point) => projection.place(point),
    });
  }

  /** From client coordinates to those of the picture. */
  #onPicture(clientX: number, clientY: number): Place {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  #restore(): void {
    this.#invalidate();
    this.#tell("bough-restored");
  }

  #tell(type: string, detail?: Drawn): void {
    this.canvas.dispatchEvent(new CustomEvent(type, { bubbles: true, detail }));
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#host;
    const density = Math.min(devicePixelRatio, finest);
    if (width === 0 || height === 0) return;
    const old = this.#projection;
    if (width === old.width && height === old.height && density === this.#density) return;
    this.#projection.resize(width, height);
    this.#density = density;
    this.#camera.resize(width, height);
    this.#framing.resize({ width, height });
    this.#invalidate();
  }
}
