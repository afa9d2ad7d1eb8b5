/** A plant in several finenesses, of which each distance takes the one that is fine enough. */
import { LOD } from "three";
import { boundsOf } from "../geometry/bounds.ts";
import { detailFor } from "../geometry/detail.ts";
import { habitFor } from "../geometry/foliage.ts";
import type { Axes } from "../geometry/tube.ts";
import { PlantGroup, type PlantLook, type PlantMaterials } from "./plant-group.ts";

/** From near to far: at how many sizes of the plant it begins, and how many leaves one leaf stands for. */
const levels = [
  { from: 0, leaves: 1 },
  { from: 5, leaves: 3 },
  { from: 15, leaves: 10 },
];
/** Most vertices near by; each level farther away has at most a quarter of the one before. */
const mostVertices = 60_000;

/** A plant in three finenesses. Far away it has fewer and larger leaves. Takes the look of `PlantGroup`, but for its detail. */
export class PlantLod extends LOD {
  /** Shows a plant. */
  constructor(plant: Axes, look: Omit<PlantLook, "detail"> = {}, materials: PlantMaterials = {}) {
    super();
    const { grown = plant, leaves = true } = look;
    const { min, max } = boundsOf(grown.polylines);
    const size = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
    const habit = habitFor(grown, typeof leaves === "object" ? leaves : {});
    let { bark, leaf } = materials;
    let vertices = mostVertices;
    for (const level of levels) {
      const sparse = {
        ...habit,
        spacing: habit.spacing * level.leaves,
        size: habit.size * Math.sqrt(level.leaves),
      };
      const detail = detailFor(plant.polylines, vertices);
      const group = new PlantGroup(plant, { ...look, detail, leaves: leaves && sparse }, { bark, leaf });
      // All levels share the materials of the first.
      bark ??= group.limbs.material;
      leaf ??= group.leaves.material;
      vertices = group.limbs.geometry.getAttribute("position").count / 4;
      this.addLevel(group, level.from * size);
    }
  }

  /** The same in another place: geometries and materials are shared, and stay those of the first. */
  override clone(): this {
    return new LOD().copy(this) as this;
  }

  /** Frees what the graphics card holds. */
  override dispose(): void {
    super.dispose();
    for (const { object } of this.levels) (object as PlantGroup).dispose();
  }
}
