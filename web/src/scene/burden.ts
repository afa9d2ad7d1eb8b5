/** Leaves and fruit in the picture. Loaded when the first plant bears any. */
import {
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  MeshStandardMaterial,
  SphereGeometry,
} from "three";
import { clothingOf, fruitsOf, leavesOf } from "../geometry/burden.ts";
import type { Axes } from "../geometry/tube.ts";
import type { Plant } from "../plant/plant.ts";
import { Leaves } from "../three/leaves.ts";
import type { Tone } from "./palette.ts";

const colors = {
  light: { leaf: "#7fa355", needle: "#55744a", fruit: "#b8422f", flower: "#fbfaf3" },
  dark: { leaf: "#7ba052", needle: "#587a4f", fruit: "#c2523c", flower: "#f1efe4" },
} as const;

/** Whoever draws it. The same object is the same leaves in their places. */
export interface Bearing {
  /** Hangs leaves and fruit on a plant whose limbs are drawn `girth` times as thick. */
  readonly hang: (burden: Burden, axes: Axes, girth: number) => void;
  /** To draw them with; made once for each press. */
  readonly make: () => Burden;
}

/** What a plant is to be seen to bear; `grown` is it at full age. */
export function bearingOf(plant: Plant, grown: Plant): Bearing {
  const { tipMass, picked } = plant.params.loads;
  const clothing = clothingOf(grown);
  const hang = (burden: Burden, axes: Axes, girth: number) => {
    burden.leaves.visible = clothing !== null;
    if (clothing) burden.leaves.update(leavesOf(axes, clothing, girth));
    burden.isNeedles = clothing !== null && clothing.slenderness < 1;
    burden.fruit(fruitsOf(axes, picked ? 0 : tipMass));
  };
  return { hang, make: () => new Burden() };
}

/** The meshes. */
export class Burden extends Group {
  readonly leaves = new Leaves();
  isNeedles = false;
  readonly #fruits = new InstancedMesh(
    new SphereGeometry(1, 20, 14),
    new MeshStandardMaterial({ roughness: 0.5 }),
    0,
  );
  #areFlowers = false;

  constructor() {
    super();
    for (const mesh of [this.leaves, this.#fruits]) mesh.frustumCulled = false;
    this.#fruits.castShadow = true;
    this.add(this.leaves, this.#fruits);
  }

  /** Takes the fruit of a plant; they hang a little longer than broad where they are flowers. */
  fruit(fruits: ReturnType<typeof fruitsOf>): void {
    this.#fruits.visible = fruits !== null;
    if (!fruits) return;
    const { centers, radius, areFlowers } = fruits;
    this.#areFlowers = areFlowers;
    const count = centers.length / 3;
    if (count > this.#fruits.instanceMatrix.count) this.#reserve(count);
    this.#fruits.count = count;
    const [broad, long] = areFlowers ? [0.8 * radius, 1.5 * radius] : [radius, 0.92 * radius];
    const matrix = new Matrix4().makeScale(broad, long, broad);
    for (let i = 0; i < count; i++) {
      matrix.setPosition(centers[3 * i] ?? 0, centers[3 * i + 1] ?? 0, centers[3 * i + 2] ?? 0);
      this.#fruits.setMatrixAt(i, matrix);
    }
    this.#fruits.instanceMatrix.needsUpdate = true;
  }

  /** Takes the colours of a tone. */
  tint(tone: Tone): void {
    const { leaf, needle, fruit, flower } = colors[tone];
    (this.leaves.material as MeshStandardMaterial).color.set(this.isNeedles ? needle : leaf);
    this.#fruits.material.color.set(this.#areFlowers ? flower : fruit);
  }

  override dispose(): void {
    this.leaves.dispose();
    this.#fruits.geometry.dispose();
    this.#fruits.material.dispose();
    this.#fruits.dispose();
  }

  #reserve(count: number): void {
    // The graphics card lets go of the old array.
    this.#fruits.dispose();
    this.#fruits.instanceMatrix = new InstancedBufferAttribute(new Float32Array(16 * count), 16);
  }
}
