/** The limbs of a plant as a geometry of three.js. */
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import type { VertexAttribute } from "../geometry/attribute.ts";
import { type Detail, detailFor } from "../geometry/detail.ts";
import type { Shades } from "../geometry/shade.ts";
import { type Axes, Tubes } from "../geometry/tube.ts";

/** Vertex attributes: their names in the shader, in `Tubes`, and numbers a vertex. */
const attributes = [
  ["position", "positions", 3],
  ["normal", "normals", 3],
  ["grain", "grain", 3],
  ["age", "ages", 1],
  ["shade", "shades", 1],
] as const;

/** How limbs are cut and coloured. */
export interface LimbOptions {
  /** How finely; as fine as is drawn without effort, if it is left out. */
  readonly detail?: Detail | undefined;
  /** How many times too thick: for a plant that would be a hair's breadth in the picture. */
  readonly girth?: number | undefined;
  /** What the attribute `shade` has, where colour means something. */
  readonly shades?: Shades | null | undefined;
}

/**
 * All limbs of a plant in one mesh, in m, each limb closed: every edge belongs to exactly two triangles (with `uv`, whose rings
 * have a seam, two edges in the same place stand for one). A plant of about the same size is written over the last one.
 *
 * Attributes: `position`, `normal`, `grain` (cosine and sine of the angle around the axis, arc length from its start in m),
 * `age` (growth steps), `shade` (0 to 1), and what else is asked for. After an update to a smaller plant the arrays are longer
 * than the draw range.
 */
export class LimbGeometry extends BufferGeometry {
  readonly #tubes: Tubes;
  readonly #extras: readonly VertexAttribute[];

  /** Empty until the first `update`; `extras` is what a shader of one's own wants besides: `uv`, `order`, `moment`, `sway`. */
  constructor(extras: readonly VertexAttribute[] = []) {
    super();
    this.#extras = extras;
    this.#tubes = new Tubes(extras.some(({ seam }) => seam));
  }

  /** Takes the shape of a plant. */
  update(axes: Axes, { detail, girth = 1, shades = null }: LimbOptions = {}): this {
    const tubes = this.#tubes;
    if (tubes.update(axes, detail ?? detailFor(axes.polylines), girth, shades)) this.#allocate();
    for (const { name, fill } of this.#extras) {
      fill(axes, tubes, this.getAttribute(name).array as Float32Array);
    }
    for (const attribute of Object.values(this.attributes) as BufferAttribute[]) {
      upload(attribute, attribute.itemSize * tubes.vertexCount);
    }
    if (this.index && tubes.recut) upload(this.index, tubes.indexCount);
    this.setDrawRange(0, tubes.indexCount);
    this.boundingBox = null;
    this.boundingSphere = null;
    return this;
  }

  #allocate(): void {
    // The graphics card lets go of the old arrays.
    this.dispose();
    const tubes = this.#tubes;
    for (const [name, array, size] of attributes) this.setAttribute(name, dynamic(tubes[array], size));
    for (const { name, itemSize } of this.#extras) {
      this.setAttribute(name, dynamic(new Float32Array(itemSize * tubes.ages.length), itemSize));
    }
    this.setIndex(dynamic(tubes.index, 1));
  }
}

function dynamic(array: Float32Array | Uint32Array, size: number): BufferAttribute {
  return new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
}

/** Sends the first `count` numbers to the graphics card, not the reserve behind them. */
function upload(attribute: BufferAttribute, count: number): void {
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, count);
  attribute.needsUpdate = true;
}
