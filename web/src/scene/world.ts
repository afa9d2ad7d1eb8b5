/** What is in the picture, lit and in its place. One scene unit is the height of the frame, whatever the plant's size. */
import { Group, Matrix4, Scene, Vector3 } from "three";
import type { Frame } from "../geometry/frame.ts";
import { type Lumping, modelOf } from "../geometry/model.ts";
import { type Paint, shadesOf } from "../geometry/shade.ts";
import type { Axes } from "../geometry/tube.ts";
import { Limbs } from "../three/limbs.ts";
import type { Bearing, Burden } from "./burden.ts";
import { Ground } from "./ground.ts";
import { Light } from "./light.ts";
import { ModelMesh } from "./model.ts";
import { palettes, type Tone } from "./palette.ts";
import { Stand } from "./stand.ts";

/** How a plant is drawn. */
export interface Look {
  /** How many growth steps the full-grown plant has. */
  readonly grownSteps: number;
  /** How many times too thick limbs are drawn. */
  readonly girth: number;
  /** What colours it; null is its own bark. */
  readonly paint: Paint | null;
  /** As the model that was computed, where masses are lumped so; null is as limbs. */
  readonly model: Lumping | null;
  /** How large the full-grown plant is, m. */
  readonly extent: number;
  /** Leaves and fruit, if there are any to be seen. */
  readonly bearing: Bearing | null;
}

export class World {
  readonly scene = new Scene();
  /** Holds the plant in m and turns it into scene units. */
  readonly #meters = new Group();
  readonly #limbs = new Limbs();
  readonly #model = new ModelMesh();
  readonly #light = new Light();
  readonly #ground = new Ground();
  readonly #stand = new Stand();
  #burden: Burden | null = null;
  #tone: Tone | null = null;

  constructor() {
    this.#meters.matrixAutoUpdate = false;
    // The camera follows the plant: it is never out of sight as a whole.
    this.#limbs.frustumCulled = false;
    this.#meters.add(this.#limbs, this.#model.group);
    this.scene.add(this.#light.group, this.#ground.group, this.#stand.mesh, this.#meters);
  }

  /** Takes the colours of a tone. */
  tint(tone: Tone): void {
    if (tone === this.#tone) return;
    this.#tone = tone;
    this.#burden?.tint(tone);
    const palette = palettes[tone];
    this.#limbs.material.tint(palette);
    this.#model.tint(palette);
    this.#light.tint(palette);
    this.#ground.tint(palette);
    this.#stand.tint(palette);
  }

  /** Takes the shape of a plant. */
  show(axes: Axes, { grownSteps, girth, paint, model, extent, bearing }: Look): void {
    const shades = paint && shadesOf(paint.color, axes, paint.range);
    this.#limbs.visible = model === null;
    this.#model.group.visible = model !== null;
    this.#bear(bearing, axes, girth);
    if (model) {
      this.#model.show(modelOf(axes, extent, model), shades, paint?.colors ?? []);
      return;
    }
    this.#limbs.geometry.update(axes, { girth, shades });
    this.#limbs.material.age(grownSteps);
    this.#limbs.material.paint(paint?.colors ?? null);
  }

  #bear(bearing: Bearing | null, axes: Axes, girth: number): void {
    if (this.#burden) this.#burden.visible = bearing !== null;
    if (!bearing) return;
    if (!this.#burden) {
      this.#burden = bearing.make();
      this.#meters.add(this.#burden);
    }
    bearing.hang(this.#burden, axes, girth);
    if (this.#tone) this.#burden.tint(this.#tone);
  }

  /** Puts a frame in front of the camera; `foot` is the drawn radius of the plant's base, m. */
  place(frame: Frame, foot: number): void {
    const unit = 1 / frame.height;
    placedAt(frame, this.#meters.matrix);
    const { x, y, z } = new Vector3().setFromMatrixPosition(this.#meters.matrix);
    this.#limbs.material.measure(unit);
    this.#ground.place({ x, z }, y + frame.ground * unit, frame.ground < 0 ? 0 : foot * unit);
    this.#stand.place({ x, y, z }, y + frame.ground * unit, foot * unit);
    this.scene.updateMatrixWorld();
  }

  dispose(): void {
    this.#limbs.dispose();
    this.#model.dispose();
    this.#light.dispose();
    this.#ground.dispose();
    this.#stand.dispose();
    this.#burden?.dispose();
  }
}

/** From m to scene units, for a frame in front of the camera. */
export function placedAt({ center: [x, y, z], height }: Frame, matrix: Matrix4): void {
  matrix.makeTranslation(-x, -y, -z).premultiply(new Matrix4().makeScale(1 / height, 1 / height, 1 / height));
}
