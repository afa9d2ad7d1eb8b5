/** The limbs as a body of their own: in metres, as thick as they are, with the colours of the picture at its vertices. */
import { BufferAttribute, BufferGeometry, Color, Mesh, MeshStandardMaterial } from "three";
import { detailFor } from "../geometry/detail.ts";
import { type Paint, shadesOf } from "../geometry/shade.ts";
import { type Axes, Tubes } from "../geometry/tube.ts";
import { palettes } from "../scene/palette.ts";

/** The mesh of a plant; `paint` is what its colour means, null its own bark. */
export function meshOf(axes: Axes, paint: Paint | null, grownSteps: number): Mesh {
  const tubes = new Tubes();
  tubes.update(axes, detailFor(axes.polylines), 1, paint && shadesOf(paint.color, axes, paint.range));
  const count = tubes.vertexCount;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(tubes.positions.slice(0, 3 * count), 3));
  geometry.setAttribute("normal", new BufferAttribute(unit(tubes.normals.slice(0, 3 * count)), 3));
  geometry.setAttribute("color", new BufferAttribute(colors(tubes, paint, grownSteps), 3));
  geometry.setIndex(new BufferAttribute(tubes.index.slice(0, tubes.indexCount), 1));
  const material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.82, metalness: 0 });
  material.name = "wood";
  const mesh = new Mesh(geometry, material);
  mesh.name = "plant";
  return mesh;
}

/** Of length 1, which a drawing need not be so exact about. */
function unit(normals: Float32Array): Float32Array {
  for (let at = 0; at < normals.length; at += 3) {
    const [x = 0, y = 0, z = 0] = normals.subarray(at, at + 3);
    const size = Math.hypot(x, y, z);
    // Where a limb has no girth there is no outside.
    normals.set(size > 0 ? [x / size, y / size, z / size] : [0, 1, 0], at);
  }
  return normals;
}

/** Red, green and blue of every vertex, linear. */
function colors({ vertexCount, shades, ages }: Tubes, paint: Paint | null, grownSteps: number): Float32Array {
  const scale = paint?.colors.map((css) => new Color(css));
  const { shoot, youngWood, bark } = palettes.light;
  const wood = [shoot, youngWood, bark].map((css) => new Color(css));
  const all = new Float32Array(3 * vertexCount);
  const color = new Color();
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    if (scale) blend(color, scale, shades[vertex] ?? 0);
    else ripen(color, wood, (ages[vertex] ?? 0) / Math.max(1, grownSteps));
    color.toArray(all, 3 * vertex);
  }
  return all;
}

/** The colour at a place on a scale, 0 to 1. */
function blend(color: Color, scale: readonly Color[], shade: number): void {
  const place = shade * (scale.length - 1);
  const below = Math.max(0, Math.min(Math.floor(place), scale.length - 2));
  const [from, to] = [scale[below], scale[below + 1]];
  if (from && to) color.copy(from).lerp(to, place - below);
}

/** As the skin of limbs in the picture: green shoots that turn to bark, without its furrows. */
function ripen(color: Color, [shoot, youngWood, bark]: readonly Color[], maturity: number): void {
  if (!shoot || !youngWood || !bark) return;
  color
    .copy(shoot)
    .lerp(youngWood, smooth(maturity / 0.22))
    .lerp(bark, smooth((maturity - 0.02) / 0.58));
}

function smooth(share: number): number {
  const held = Math.min(1, Math.max(0, share));
  return held * held * (3 - 2 * held);
}
