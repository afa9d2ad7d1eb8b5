/** The model as a diagram: a rod for each rigid segment, a ring for each spring, a dot for each mass. */
import {
  Color,
  Group,
  InstancedMesh,
  LatheGeometry,
  Matrix4,
  MeshStandardMaterial,
  Quaternion,
  Vector2,
  Vector3,
} from "three";
import type { Model } from "../geometry/model.ts";
import type { Shades } from "../geometry/shade.ts";
import type { Palette } from "./palette.ts";

const up = new Vector3(0, 1, 0);

/** What is the same many times over. */
class Copies {
  readonly material = new MeshStandardMaterial({ roughness: 1, metalness: 0 });
  mesh: InstancedMesh;
  readonly #matrix = new Matrix4();
  readonly #rotation = new Quaternion();
  readonly #scale = new Vector3();
  readonly #parent: Group;
  readonly #geometry: LatheGeometry;

  /** Copies of a body of revolution about y. */
  constructor(parent: Group, profile: Vector2[], around: number) {
    this.#parent = parent;
    this.#geometry = new LatheGeometry(profile, around);
    this.mesh = this.#make(0);
  }

  /** Makes room for so many, and forgets the old ones. */
  start(count: number): void {
    if (count > this.mesh.instanceMatrix.count) {
      this.#parent.remove(this.mesh);
      this.mesh.dispose();
      this.mesh = this.#make(Math.ceil(1.5 * count));
    }
    this.mesh.count = 0;
  }

  /** Adds one: its middle, the unit direction of its axis, how long it is in that direction, and how wide across. */
  add(at: Vector3, axis: Vector3, long: number, wide: number, color: Color): void {
    const index = this.mesh.count++;
    this.#rotation.setFromUnitVectors(up, axis);
    this.mesh.setMatrixAt(index, this.#matrix.compose(at, this.#rotation, this.#scale.set(wide, long, wide)));
    this.mesh.setColorAt(index, color);
  }

  finish(): void {
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.dispose();
    this.#geometry.dispose();
    this.material.dispose();
  }

  #make(room: number): InstancedMesh {
    const mesh = new InstancedMesh(this.#geometry, this.material, room);
    mesh.castShadow = true;
    mesh.frustumCulled = false;
    this.#parent.add(mesh);
    return mesh;
  }
}

export class ModelMesh {
  readonly group = new Group();
  readonly #rods = new Copies(this.group, [new Vector2(1, -0.5), new Vector2(1, 0.5)], 10);
  readonly #springs = new Copies(this.group, arc(1, 0.12, Math.PI * 2, 8), 28);
  readonly #masses = new Copies(this.group, arc(0, 1, Math.PI, 12), 20);
  readonly #colors = { rod: new Color(), spring: new Color(), mass: new Color() };

  tint({ rod, spring, mass }: Palette): void {
    this.#colors.rod.set(rod);
    this.#colors.spring.set(spring);
    this.#colors.mass.set(mass);
  }

  /** Takes the shape of a model; rods are coloured by the shades, if there are any. */
  show(model: Model, shades: Shades | null, colors: readonly string[]): void {
    this.#showRods(model, shades, colors);
    const at = new Vector3();
    const axis = new Vector3();
    this.#springs.start(model.joints.length / 3);
    for (let k = 0; k < model.joints.length; k += 3) {
      at.fromArray(model.joints, k);
      axis.fromArray(model.pivots, k);
      this.#springs.add(at, axis, model.spring, model.spring, this.#colors.spring);
    }
    this.#springs.finish();
    this.#masses.start(model.dots.length);
    model.dots.forEach((radius, point) => {
      if (radius > 0)
        this.#masses.add(at.fromArray(model.masses, 3 * point), up, radius, radius, this.#colors.mass);
    });
    this.#masses.finish();
  }

  dispose(): void {
    this.#rods.dispose();
    this.#springs.dispose();
    this.#masses.dispose();
  }

  #showRods({ rods, rod }: Model, shades: Shades | null, colors: readonly string[]): void {
    // A colour is made out only on something broad enough.
    const radius = shades ? 2 * rod : rod;
    const start = new Vector3();
    const along = new Vector3();
    const color = new Color();
    this.#rods.start(rods.length / 6);
    for (let k = 0; k < rods.length; k += 6) {
      start.fromArray(rods, k);
      along.fromArray(rods, k + 3).sub(start);
      const length = along.length();
      start.addScaledVector(along, 0.5);
      if (length > 0) along.divideScalar(length);
      else along.copy(up);
      const shade = shades?.values[k / 6];
      if (shade === undefined) color.copy(this.#colors.rod);
      else color.set(at(colors, shade));
      this.#rods.add(start, along, length, radius, color);
    }
    this.#rods.finish();
  }
}

/** The colour at a place on a scale. */
function at(colors: readonly string[], shade: number): Color {
  const place = shade * (colors.length - 1);
  const below = Math.min(Math.floor(place), colors.length - 2);
  return new Color(colors[below]).lerp(new Color(colors[below + 1]), place - below);
}

/** Part of a circle around a place on the horizontal axis, from below upwards. */
function arc(middle: number, radius: number, angle: number, steps: number): Vector2[] {
  return Array.from({ length: steps + 1 }, (_, i) => {
    const turned = (i / steps) * angle - Math.PI / 2;
    return new Vector2(middle + radius * Math.cos(turned), radius * Math.sin(turned));
  });
}
