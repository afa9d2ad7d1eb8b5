/** The limbs of a plant, in bark. */
import { Mesh } from "three";
import type { VertexAttribute } from "../geometry/attribute.ts";
import { Bark } from "./bark.ts";
import { LimbGeometry } from "./limb-geometry.ts";

/** All limbs of a plant as one mesh, which casts shadows and receives them. */
export class Limbs extends Mesh<LimbGeometry, Bark> {
  /** Empty until its geometry is updated; `extras` is what a shader of one's own wants besides. */
  constructor(bark: Bark = new Bark(), extras: readonly VertexAttribute[] = []) {
    super(new LimbGeometry(extras), bark);
    this.castShadow = true;
    this.receiveShadow = true;
  }

  /** The same limbs in another place: geometry and material are shared. */
  override clone(recursive?: boolean): this {
    return new Mesh(this.geometry, this.material).copy(this, recursive) as this;
  }

  /** Frees what the graphics card holds. */
  override dispose(): void {
    super.dispose();
    this.geometry.dispose();
    this.material.dispose();
  }
}
