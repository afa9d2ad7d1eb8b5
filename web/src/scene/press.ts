/**
 * The press: one WebGL context, which prints the pictures of one stage or of many, each onto its own canvas. Browsers keep
 * but a few contexts, and many plants on a page would each need one. What was printed stays, whatever becomes of the press.
 */
import { PCFShadowMap, type PerspectiveCamera, WebGLRenderer } from "three";
import type { Frame } from "../geometry/frame.ts";
import type { Axes } from "../geometry/tube.ts";
import type { Tone } from "./palette.ts";
import { type Look, World } from "./world.ts";

/** What is printed. The same object is the same mesh, which is then not made anew. */
export interface Sheet {
  readonly axes: Axes;
  readonly look: Look;
}

/** How it is printed. */
export interface Print {
  readonly sheet: Sheet;
  readonly tone: Tone;
  readonly frame: Frame;
  /** Drawn radius of the plant's base, m. */
  readonly foot: number;
  readonly eye: PerspectiveCamera;
}

/** Dispatches `lost` when the graphics card drops the context, and `restored` when it is there again. */
export class Press extends EventTarget {
  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  /** What the mesh holds. */
  #sheet: Sheet | null = null;
  #users = 0;

  /** Throws when the browser has no WebGL 2. */
  constructor() {
    super();
    this.#renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    const { domElement } = this.#renderer;
    domElement.addEventListener("webglcontextlost", () => this.dispatchEvent(new Event("lost")));
    domElement.addEventListener("webglcontextrestored", () => this.dispatchEvent(new Event("restored")));
  }

  /** Whether there is no graphics card at hand: it dropped the context, or the last user has left. */
  get isLost(): boolean {
    return this.#renderer.getContext().isContextLost();
  }

  /** Counts another user. */
  join(): void {
    this.#users++;
  }

  /** One user less; after the last one the graphics card is free, and the press of no more use. */
  leave(): void {
    if (--this.#users > 0) return;
    this.#world.dispose();
    this.#renderer.dispose();
    if (!this.isLost) this.#renderer.forceContextLoss();
  }

  /** Prints onto a canvas, over all of it. */
  print({ sheet, tone, frame, foot, eye }: Print, pen: CanvasRenderingContext2D): void {
    const world = this.#world;
    world.tint(tone);
    if (sheet !== this.#sheet) world.show(sheet.axes, sheet.look);
    this.#sheet = sheet;
    world.place(frame, foot);
    const { width, height } = pen.canvas;
    const { domElement: bed } = this.#renderer;
    // It only grows: to change its size for every picture would cost more than the picture.
    if (bed.width < width || bed.height < height) {
      this.#renderer.setSize(Math.max(bed.width, width), Math.max(bed.height, height), false);
    }
    const { drawingBufferWidth, drawingBufferHeight } = this.#renderer.getContext();
    // Browsers make it smaller than was asked for, and say nothing.
    if (drawingBufferWidth < width || drawingBufferHeight < height) {
      throw new RangeError("The graphics card has no room for a picture of that size.");
    }
    this.#renderer.setViewport(0, 0, width, height);
    this.#renderer.setScissor(0, 0, width, height);
    this.#renderer.setScissorTest(true);
    this.#renderer.render(world.scene, eye);
    pen.globalCompositeOperation = "copy";
    pen.drawImage(bed, 0, bed.height - height, width, height, 0, 0, width, height);
  }
}
