/** Where what is in the world is in the picture, as that was drawn last. */
import { Matrix4, type PerspectiveCamera, Vector3 } from "three";
import type { Vector } from "../geometry/bounds.ts";
import type { Axes } from "../geometry/tube.ts";
import type { Place } from "./annotation.ts";
import { toClip, toPicture } from "./sight.ts";

export class Projection {
  /** From m to scene units, in the last picture. */
  readonly meters = new Matrix4();
  readonly #eye: PerspectiveCamera;
  #width = 0;
  #height = 0;

  constructor(eye: PerspectiveCamera) {
    this.#eye = eye;
  }

  /** CSS px. */
  get width(): number {
    return this.#width;
  }

  /** CSS px. */
  get height(): number {
    return this.#height;
  }

  /** Takes the size of the picture, CSS px. */
  resize(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
  }

  /** From m to clip coordinates. */
  get clip(): Matrix4 {
    return toClip(this.#eye, this.meters);
  }

  /** From m to CSS px from the upper left corner. */
  get picture(): Matrix4 {
    return toPicture(this.clip, this.#width, this.#height);
  }

  /** Where a point of the world (m) is, in CSS px from the upper left corner. */
  place([x, y, z]: Vector): Place {
    const point = new Vector3(x, y, z).applyMatrix4(this.meters).project(this.#eye);
    return { x: (0.5 + 0.5 * point.x) * this.#width, y: (0.5 - 0.5 * point.y) * this.#height };
  }

  /** How long a metre is at the base, in a frame of that height (m). */
  pixelsPerMeter(height: number): number {
    const { elements } = this.#eye.matrixWorld;
    const step = 0.01 * height;
    const [right, up, back] = [0, 1, 2].map((k) => (elements[k] ?? 0) * step) as [number, number, number];
    const [a, b] = [this.place([0, 0, 0]), this.place([right, up, back])];
    return Math.hypot(b.x - a.x, b.y - a.y) / step;
  }

  /** The centre lines of axes; of the first hundred, which is as many as can be told apart. */
  lines(axes: Axes): Place[][] {
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
      return this.place([points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0]);
    });
  }
}
