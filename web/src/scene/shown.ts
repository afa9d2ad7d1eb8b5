/** What a stage shows: what of it makes the mesh, and what is marked on it. */
import type { Vector } from "../geometry/bounds.ts";
import type { Lumping } from "../geometry/model.ts";
import type { Paint } from "../geometry/shade.ts";
import type { Axes } from "../geometry/tube.ts";
import { isBroken, type Plant } from "../plant/plant.ts";
import type { Bearing } from "./burden.ts";
import type { Tone } from "./palette.ts";
import type { Look } from "./world.ts";

/** What is in the picture, and how. */
export interface Shown {
  readonly plant: Plant;
  readonly grown: Plant;
  readonly paint: Paint | null;
  readonly model: Lumping | null;
  readonly bearing: Bearing | null;
  readonly tone: Tone;
}

/** Whether the same shape gives the same mesh. */
export function looksLike(a: Shown, b: Shown): boolean {
  const isPainted = a.paint !== null || b.paint !== null || a.model !== null;
  return (
    a.grown === b.grown &&
    a.model === b.model &&
    a.bearing === b.bearing &&
    a.paint?.color === b.paint?.color &&
    a.paint?.range.max === b.paint?.range.max &&
    // The colours of the model are in its mesh.
    (!isPainted || a.tone === b.tone)
  );
}

/** How its mesh is drawn, limbs `girth` times too thick, in a picture of a plant that grows so large (`extent`, m). */
export function lookOf({ grown, paint, model, bearing }: Shown, girth: number, extent: number): Look {
  // Bark comes with age: what stays a stalk never gets any.
  const grownSteps = grown.report.steps * (isStalk(grown) ? 4 : 1);
  return { grownSteps, girth, paint, model, extent, bearing };
}

/** Whether it is a thin stalk with leaves or a flower, and not wood: it does not thicken. */
function isStalk({ params: { axis, growth, loads } }: Plant): boolean {
  return growth.thickening === "none" && axis.radius < 0.003 && (loads.foliage > 0 || loads.tipMass > 0);
}

/** Where a plant breaks first, as it is drawn, m; null where it holds. */
export function breakOf({ report }: Plant, { polylines, segments }: Axes): Vector | null {
  if (!isBroken(report) || report.breaksFirst === null) return null;
  const at = 3 * ((segments.point[report.breaksFirst] ?? 1) - 1);
  const [x = 0, y = 0, z = 0] = polylines.points.subarray(at, at + 3);
  return [x, y, z];
}

/** Where the masses of the model are: as the plant was computed. */
export function lumpingOf({ params }: Plant): Lumping {
  return params.solver.discretization === "paper" ? "distal" : "ends";
}
