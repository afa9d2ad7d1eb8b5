/** A plant ready to be put into a scene. */
import { Group, type Material } from "three";
import { moment, order, sway, uv } from "../geometry/attribute.ts";
import { boundsOf } from "../geometry/bounds.ts";
import type { Detail } from "../geometry/detail.ts";
import { foliageOf, habitFor, type LeafHabit } from "../geometry/foliage.ts";
import { paintOf } from "../geometry/legend.ts";
import { type Color, shadesOf } from "../geometry/shade.ts";
import type { Axes } from "../geometry/tube.ts";
import type { Bark } from "./bark.ts";
import { Leaves } from "./leaves.ts";
import { Limbs } from "./limbs.ts";

/** How a plant is shown. */
export interface PlantLook {
  /** The plant at full age, where a younger one is shown: colours mean the same at all ages then, and leaves stay in their places. */
  readonly grown?: Axes | undefined;
  /** What the colour of limbs means; their own bark, if it is left out. */
  readonly color?: Color | undefined;
  /** Leaves along young wood: as they suit the plant, or as wished; none with `false`. */
  readonly leaves?: boolean | Partial<LeafHabit> | undefined;
  /** How finely limbs are cut; as fine as is drawn without effort, if it is left out. */
  readonly detail?: Detail | undefined;
  /** How many times too thick limbs are drawn. */
  readonly girth?: number | undefined;
}

/** Materials that plants may share. */
export interface PlantMaterials {
  readonly bark?: Bark | undefined;
  readonly leaf?: Material | undefined;
}

/** Everything of a plant, in m, y up, its base in the origin: limbs in bark, and leaves as instances. */
export class PlantGroup extends Group {
  readonly limbs: Limbs;
  readonly leaves: Leaves;
  /** The materials that it has made itself, and disposes of. */
  readonly #own: readonly Material[];

  /** Shows a plant. Materials that are given stay the caller's: `dispose` leaves them alone. */
  constructor(plant: Axes, look: PlantLook = {}, { bark, leaf }: PlantMaterials = {}) {
    super();
    this.limbs = new Limbs(bark, [uv, order, moment, sway]);
    this.leaves = new Leaves(leaf);
    this.#own = [...(bark ? [] : [this.limbs.material]), ...(leaf ? [] : [this.leaves.material])];
    this.add(this.limbs, this.leaves);
    this.update(plant, look);
  }

  /** Shows another plant, or the same at another age. */
  update(plant: Axes, look: PlantLook = {}): this {
    const { grown = plant, color = "bark", leaves = true, detail, girth = 1 } = look;
    const paint = paintOf(plant, color, grown);
    const shades = paint && shadesOf(paint.color, plant, paint.range);
    this.limbs.geometry.update(plant, { detail, girth, shades });
    const { material } = this.limbs;
    const { min, max } = boundsOf(grown.polylines);
    material.measure(1 / Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]));
    material.age(grown.report.steps);
    material.paint(paint?.colors ?? null);
    this.leaves.visible = leaves !== false;
    if (leaves !== false) {
      const habit = habitFor(grown, leaves === true ? {} : leaves);
      this.leaves.update(foliageOf(plant, habit, girth));
    }
    return this;
  }

  /** The same in another place: geometries and materials are shared, and stay those of the first. */
  override clone(recursive?: boolean): this {
    return new Group().copy(this, recursive) as this;
  }

  /** Frees what the graphics card holds. */
  override dispose(): void {
    super.dispose();
    this.limbs.geometry.dispose();
    this.leaves.geometry.dispose();
    this.leaves.instanceMatrix.dispose();
    for (const material of this.#own) material.dispose();
  }
}
