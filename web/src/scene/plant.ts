/** The plant as a mesh. */
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh } from "three";
import { detailFor } from "../geometry/detail.ts";
import type { Shades } from "../geometry/shade.ts";
import { type Axes, Tubes } from "../geometry/tube.ts";
import { Bark } from "./bark.ts";

/** Vertex attributes: their names in the shader, in `Tubes`, and numbers a vertex. */
const attributes = [
  ["position", "positions", 3],
  ["normal", "normals", 3],
  ["grain", "grain", 3],
  ["age", "ages", 1],
  ["shade", "shades", 1],
] as const;

/** All limbs of the plant in one mesh; a plant of about the same size is written over the last one. */
export class PlantMesh {
  readonly material = new Bark();
  readonly mesh = new Mesh(new BufferGeometry(), this.material);
  readonly #tubes = new Tubes();

  constructor() {
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    // The camera follows the plant: it is never out of sight as a whole.
    this.mesh.frustumCulled = false;
  }

  /** Takes the shape of a plant, with radii drawn `girth` times as thick, and what colours it, if that is not its own. */
  show(axes: Axes, girth: number, shades: Shades | null): void {
    const tubes = this.#tubes;
    if (tubes.update(axes, detailFor(axes.polylines), girth, shades)) this.#allocate();
    const { geometry } = this.mesh;
    for (const [name, , size] of attributes) {
      upload(geometry.getAttribute(name) as BufferAttribute, size * tubes.vertexCount);
    }
    if (geometry.index && tubes.recut) upload(geometry.index, tubes.indexCount);
    geometry.setDrawRange(0, tubes.indexCount);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }

  #allocate(): void {
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    for (const [name, array, size] of attributes) {
      geometry.setAttribute(name, dynamic(this.#tubes[array], size));
    }
    geometry.setIndex(dynamic(this.#tubes.index, 1));
    this.mesh.geometry = geometry;
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
