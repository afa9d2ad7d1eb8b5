/** Points of plants, as they are grown outside the page. */
import { grow, type ParamsInput, type Plant } from "../../web/src/package/node.ts";

/** A point of the plant, m. */
export function pointOf({ polylines: { points } }: Plant, point: number): [number, number, number] {
  return [points[3 * point] ?? 0, points[3 * point + 1] ?? 0, points[3 * point + 2] ?? 0];
}

/** Where the tip of the main axis is, m. */
export function tipOf(params: ParamsInput): [number, number, number] {
  const plant = grow(params);
  return pointOf(plant, (plant.polylines.offsets[1] ?? 1) - 1);
}
