/** Plants for scenes of one's own: `bough/three`. The page and the element draw with exactly this. */
export { moment, order, sway, uv, type VertexAttribute, type Vertices } from "../geometry/attribute.ts";
export { type Detail, detailFor } from "../geometry/detail.ts";
export { type Foliage, foliageOf, habitFor, type LeafHabit } from "../geometry/foliage.ts";
export { type Legend, legend } from "../geometry/legend.ts";
export type { Color, Shades } from "../geometry/shade.ts";
export type { Axes } from "../geometry/tube.ts";
export { Bark, type BarkColors, barkColors } from "./bark.ts";
export { bladeGeometry, leafMaterial } from "./leaf.ts";
export { Leaves } from "./leaves.ts";
export { LimbGeometry, type LimbOptions } from "./limb-geometry.ts";
export { Limbs } from "./limbs.ts";
export { PlantGroup, type PlantLook, type PlantMaterials } from "./plant-group.ts";
export { PlantLod } from "./plant-lod.ts";
export { Wind } from "./wind.ts";
