/** What holds up the base of a plant that hangs below it: a plain post, clearly no wood of the plant. */
import { LatheGeometry, Mesh, MeshStandardMaterial, Vector2 } from "three";
import type { Palette } from "./palette.ts";

export class Stand {
  readonly mesh: Mesh;
  readonly #material = new MeshStandardMaterial({ roughness: 0.9, metalness: 0 });
  /** What the geometry was made for. */
  #shape = { radius: 0, height: 0 };

  constructor() {
    this.mesh = new Mesh(new LatheGeometry(), this.#material);
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
  }

  tint({ stand }: Palette): void {
    this.#material.color.set(stand);
  }

  /** Stands behind the base, from the ground to a little above it; scene units. A base on the ground needs none. */
  place(base: { x: number; y: number; z: number }, ground: number, limb: number): void {
    const height = base.y - ground;
    this.mesh.visible = height > 1e-4;
    if (!this.mesh.visible) return;
    const radius = Math.max(1.5 * limb, 0.012);
    this.mesh.position.set(base.x, ground, base.z - radius);
    if (radius === this.#shape.radius && height === this.#shape.height) return;
    this.#shape = { radius, height };
    this.mesh.geometry.dispose();
    this.mesh.geometry = new LatheGeometry(profile(radius, height + 2.5 * radius), 40);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}

/** From the flared foot to the round top. */
function profile(radius: number, height: number): Vector2[] {
  const flare = Math.min(2.5 * radius, 0.4 * height);
  const foot = Array.from({ length: 9 }, (_, i) => {
    const up = i / 8;
    return new Vector2(radius * (1 + 0.7 * (1 - up) ** 3), flare * up);
  });
  const top = Array.from({ length: 9 }, (_, i) => {
    const angle = (i * Math.PI) / 16;
    return new Vector2(radius * Math.cos(angle), height - radius * (1 - Math.sin(angle)));
  });
  return [...foot, ...top];
}
