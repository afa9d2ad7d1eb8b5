/** The leaves of a plant as instances of one blade. */
import { type BufferGeometry, InstancedBufferAttribute, InstancedMesh, type Material } from "three";
import type { Foliage } from "../geometry/foliage.ts";
import { bladeGeometry, leafMaterial } from "./leaf.ts";

/** All leaves of a plant, drawn at once; `visible = false` turns them off. */
export class Leaves extends InstancedMesh<BufferGeometry, Material> {
  /** How far each leaf gives way to wind, as `sway` of limbs. */
  #sways = new InstancedBufferAttribute(new Float32Array(0), 1);

  /** None until the first `update`. */
  constructor(material: Material = leafMaterial(), blade: BufferGeometry = bladeGeometry()) {
    super(blade, material, 0);
    this.castShadow = true;
    this.receiveShadow = true;
  }

  /** Takes the leaves of a plant. */
  update({ count, matrices, sways }: Foliage): this {
    if (count > this.instanceMatrix.count) this.#reserve(Math.ceil(1.5 * count));
    this.count = count;
    this.boundingBox = null;
    this.boundingSphere = null;
    (this.instanceMatrix.array as Float32Array).set(matrices);
    this.instanceMatrix.needsUpdate = true;
    (this.#sways.array as Float32Array).set(sways);
    this.#sways.needsUpdate = true;
    return this;
  }

  /**
   * Gives shaders the instance attribute `sway`: the weight for wind, as limbs have it. three's GLTFExporter takes instance attributes
   * for those of vertices: what is exported should not have it.
   */
  weigh(): void {
    this.geometry.setAttribute("sway", this.#sways);
  }

  /** The same leaves in another place, with the same blade: a mesh of three's own, which cannot be updated. */
  override clone(recursive?: boolean): this {
    return new InstancedMesh(this.geometry, this.material, 0).copy(this, recursive) as this;
  }

  /** Frees what the graphics card holds. */
  override dispose(): void {
    super.dispose();
    this.geometry.dispose();
    this.material.dispose();
  }

  #reserve(room: number): void {
    // The graphics card lets go of the old arrays.
    this.instanceMatrix.dispose();
    this.instanceMatrix = new InstancedBufferAttribute(new Float32Array(16 * room), 16);
    const isWeighed = this.geometry.getAttribute("sway") === this.#sways;
    this.#sways = new InstancedBufferAttribute(new Float32Array(room), 1);
    if (!isWeighed) return;
    this.geometry.dispose();
    this.weigh();
  }
}
