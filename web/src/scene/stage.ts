/** The picture of a plant: everything that is drawn, in an element of the page. */
import { type Matrix4, PCFShadowMap, Vector3, WebGLRenderer } from "three";
import type { Vector } from "../geometry/bounds.ts";
import type { Frame } from "../geometry/frame.ts";
import { paintOf } from "../geometry/legend.ts";
import { measure } from "../geometry/measure.ts";
import { type Lumping, mostModelled } from "../geometry/model.ts";
import { headingOf, type Pick, pick } from "../geometry/pick.ts";
import type { Color, Paint } from "../geometry/shade.ts";
import type { Axes } from "../geometry/tube.ts";
import type { Plant } from "../plant/plant.ts";
import { Annotation, type Place } from "./annotation.ts";
import { Camera, type View } from "./camera.ts";
import type { Force } from "./force.ts";
import { Framing } from "./framing.ts";
import { Morph } from "./morph.ts";
import type { Tone } from "./palette.ts";
import { toClip, toPicture, unproject } from "./sight.ts";
import { World } from "./world.ts";

/** How a plant is drawn. */
export type Style = "limb" | "model";

/** How a plant is shown. */
export interface Showing {
  /** The plant at full age: the frame fits it, and so stays still while younger ages are shown. */
  readonly grown: Plant;
  readonly view: View;
  /** What the plant's colour means; its own bark unless said otherwise. `legend` explains it. */
  readonly color?: Color;
  /** As limbs, unless said otherwise, or as the model that was computed: segments, springs and masses. */
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

/** What is in the picture, and how. */
interface Shown {
  readonly plant: Plant;
  readonly grown: Plant;
  readonly paint: Paint | null;
  readonly model: Lumping | null;
  readonly tone: Tone;
}

/** Most device pixels a CSS pixel: more cannot be seen, and costs with its square. */
const finest = 2;
/** So far beside a limb it is still meant. px */
const fingerBreadth = 22;

/**
 * Draws on demand: there are no frames while nothing changes. The canvas dispatches `bough-due` when a picture is asked
 * for, and `bough-drawn` when it is there. The constructor throws when the browser has no WebGL 2.
 * When the graphics card drops the picture, the last good one stays, and the canvas dispatches `bough-lost`, later
 * `bough-restored`.
 */
export class Stage {
  /** Takes the gestures and the keyboard focus. */
  readonly canvas: HTMLCanvasElement;
  readonly #host: HTMLElement;
  readonly #renderer: WebGLRenderer;
  readonly #poster = document.createElement("canvas");
  readonly #annotation = new Annotation();
  readonly #world = new World();
  readonly #framing = new Framing();
  readonly #morph = new Morph();
  readonly #camera: Camera;
  readonly #resizes: ResizeObserver;
  readonly #stillness = matchMedia("(prefers-reduced-motion: reduce)");
  #force: Force | null = null;
  #request = 0;
  #width = 0;
  #height = 0;
  #shown: Shown | null = null;
  /** What the mesh holds. */
  #drawn: { axes: Axes; shown: Shown; girth: number } | null = null;

  /** Fills an element, which must have a size of its own and be positioned. */
  constructor(host: HTMLElement) {
    this.#renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    this.canvas = this.#renderer.domElement;
    this.canvas.className = "picture";
    this.#poster.className = "poster";
    this.#poster.hidden = true;
    this.#host = host;
    host.append(this.#poster, this.canvas, this.#annotation.element);
    this.#camera = new Camera(this.canvas, () => this.#invalidate());
    this.canvas.addEventListener("webglcontextlost", () => this.#lose());
    this.canvas.addEventListener("webglcontextrestored", () => this.#restore());
    this.#resizes = new ResizeObserver(() => this.#resize());
    this.#resizes.observe(host);
    this.#resize();
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
    this.#world.tint(tone);
    const isTooMuch = style === "model" && plant.segments.point.length > mostModelled;
    const model = style === "model" && !isTooMuch ? lumpingOf(plant) : null;
    this.#shown = { plant, grown, paint: paintOf(plant, color, grown), model, tone };
    this.#invalidate();
    return isTooMuch
      ? `Above ${mostModelled} segments the model cannot be made out: these are the limbs.`
      : null;
  }

  /** Whether a picture is due. */
  get moving(): boolean {
    return this.#request !== 0;
  }

  /** Where a point of the world (m) is on the picture, in CSS px from its upper left corner. */
  project([x, y, z]: Vector): Place {
    const point = new Vector3(x, y, z).applyMatrix4(this.#world.meters.matrixWorld).project(this.#camera.eye);
    return { x: (0.5 + 0.5 * point.x) * this.#width, y: (0.5 - 0.5 * point.y) * this.#height };
  }

  /**
   * The place on the plant under a pointer, or within a finger's breadth of it; null where there is none. Takes client
   * coordinates, as pointer events have them.
   */
  pick(clientX: number, clientY: number): Pick | null {
    const axes = this.#drawn?.axes;
    if (!axes) return null;
    const { x, y } = this.#onPicture(clientX, clientY);
    const clip = this.#clip();
    const { elements } = clip;
    const depth = elements[15] ?? 1;
    const sight = {
      toPicture: toPicture(clip, this.#width, this.#height).elements,
      scale: this.#pixelsPerMeter(this.#framing.at(performance.now())?.frame.height ?? 1),
      depth,
      girth: this.#framing.girth,
    };
    return pick(axes, sight, x, y, fingerBreadth);
  }

  /**
   * The point of the world (m) under a pointer, on a vertical plane through a given point: in the plane view, that of the
   * picture; in the space view, that of the axis which bears the `segment`, or without one the plane that faces the eye.
   */
  unproject(clientX: number, clientY: number, through: Vector, segment?: number): Vector {
    const axes = this.#drawn?.axes;
    const own = axes && segment !== undefined ? headingOf(axes, segment) : null;
    const heading = this.#camera.view === "plane" ? ([1, 0, 0] as const) : own;
    const picture = toPicture(this.#clip(), this.#width, this.#height);
    return unproject(picture, this.#onPicture(clientX, clientY), through, heading);
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

  /** Frees the graphics card: browsers keep few contexts. */
  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#resizes.disconnect();
    this.#camera.dispose();
    this.#world.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
    this.#host.replaceChildren();
  }

  #invalidate(): void {
    if (this.#request !== 0) return;
    this.#request = requestAnimationFrame((now) => this.#draw(now));
    this.canvas.dispatchEvent(new CustomEvent("bough-due", { bubbles: true }));
  }

  #draw(now: number): void {
    this.#request = 0;
    const placed = this.#framing.at(now);
    const shape = this.#morph.at(now);
    const isLost = this.#renderer.getContext().isContextLost();
    if (!placed || !shape || !this.#shown || this.#width === 0 || isLost) return;
    const turns = this.#camera.advance(now);
    if (placed.moves || shape.moves || turns) this.#invalidate();
    this.#fill(shape.axes, this.#shown);
    this.#world.place(placed.frame, this.#framing.foot);
    this.#renderer.render(this.#world.scene, this.#camera.eye);
    this.#keep();
    this.#annotate(placed.frame, shape.axes, this.#shown);
    const detail: Drawn = { projection: this.#clip().toArray(), moving: this.moving };
    this.canvas.dispatchEvent(new CustomEvent("bough-drawn", { bubbles: true, detail }));
  }

  /** Makes the mesh anew, if it is about anything else than before. */
  #fill(axes: Axes, shown: Shown): void {
    const { girth, extent } = this.#framing;
    const drawn = this.#drawn;
    if (drawn && drawn.axes === axes && drawn.girth === girth && looksLike(drawn.shown, shown)) return;
    const { grown, paint, model } = shown;
    this.#world.show(axes, { grownSteps: grown.report.steps, girth, paint, model, extent });
    this.#drawn = { axes, shown, girth };
  }

  #annotate(frame: Frame, axes: Axes, { plant, grown, model }: Shown): void {
    const { base, heading } = measure(plant);
    this.#annotation.draw({
      frame,
      view: this.#camera.view,
      base,
      heading,
      present: this.#lines(axes),
      future: plant.report.steps < grown.report.steps ? this.#lines(grown) : [],
      elevation: plant.params.axis.elevation,
      girth: model ? 1 : this.#framing.girth,
      scale: this.#pixelsPerMeter(frame.height),
      force: this.#force,
      width: this.#width,
      height: this.#height,
      project: (point) => this.project(point),
    });
  }

  /** The centre lines of the axes on the picture; of the first hundred, which is as many as can be told apart. */
  #lines(axes: Axes): Place[][] {
    const count = Math.min(axes.polylines.offsets.length - 1, 100);
    return Array.from({ length: count }, (_, axis) => this.#line(axes, axis));
  }

  #line({ polylines: { points, offsets } }: Axes, axis: number): Place[] {
    const first = offsets[axis] ?? 0;
    const last = (offsets[axis + 1] ?? 0) - 1;
    // Some fifty points are dense enough on a screen; the last one always counts.
    const stride = Math.max(1, Math.ceil((last - first) / 50));
    const count = Math.ceil((last - first) / stride) + 1;
    return Array.from({ length: count }, (_, i) => {
      const at = 3 * Math.min(first + i * stride, last);
      return this.project([points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0]);
    });
  }

  #pixelsPerMeter(height: number): number {
    const { elements } = this.#camera.eye.matrixWorld;
    const step = 0.01 * height;
    const [right, up, back] = [0, 1, 2].map((k) => (elements[k] ?? 0) * step) as [number, number, number];
    const [a, b] = [this.project([0, 0, 0]), this.project([right, up, back])];
    return Math.hypot(b.x - a.x, b.y - a.y) / step;
  }

  /** From m to clip coordinates. */
  #clip(): Matrix4 {
    return toClip(this.#camera.eye, this.#world.meters.matrixWorld);
  }

  /** From client coordinates to those of the picture. */
  #onPicture(clientX: number, clientY: number): Place {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  /** Copies the picture while it is there: it is all that is left when the graphics card drops the context. */
  #keep(): void {
    const { width, height } = this.canvas;
    if (this.#poster.width !== width) this.#poster.width = width;
    if (this.#poster.height !== height) this.#poster.height = height;
    const pen = this.#poster.getContext("2d");
    pen?.clearRect(0, 0, width, height);
    pen?.drawImage(this.canvas, 0, 0);
  }

  #lose(): void {
    this.#poster.hidden = false;
    this.canvas.dispatchEvent(new CustomEvent("bough-lost", { bubbles: true }));
  }

  #restore(): void {
    this.#poster.hidden = true;
    this.#invalidate();
    this.canvas.dispatchEvent(new CustomEvent("bough-restored", { bubbles: true }));
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#host;
    const density = Math.min(devicePixelRatio, finest);
    if (width === 0 || height === 0) return;
    if (width === this.#width && height === this.#height && density === this.#renderer.getPixelRatio())
      return;
    this.#width = width;
    this.#height = height;
    this.#renderer.setPixelRatio(density);
    this.#renderer.setSize(width, height);
    this.#camera.resize(width, height);
    this.#framing.resize({ width, height });
    this.#invalidate();
  }
}

/** Whether the same shape gives the same mesh. */
function looksLike(a: Shown, b: Shown): boolean {
  const isPainted = a.paint !== null || b.paint !== null || a.model !== null;
  return (
    a.grown === b.grown &&
    a.model === b.model &&
    a.paint?.color === b.paint?.color &&
    a.paint?.range.max === b.paint?.range.max &&
    // The colours of the model are in its mesh.
    (!isPainted || a.tone === b.tone)
  );
}

function lumpingOf({ params }: Plant): Lumping {
  return params.solver.discretization === "paper" ? "distal" : "ends";
}
