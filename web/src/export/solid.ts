/** The limbs as files for other programs: GLB (glTF 2.0, binary) and OBJ. */
import type { Mesh } from "three";
import { GLTFExporter } from "three/addons/exporters/GLTFExporter.js";
import { OBJExporter } from "three/addons/exporters/OBJExporter.js";
import type { Plant } from "../plant/plant.ts";

/** GLB of a mesh, with the params that made it in its extras. */
export async function glb(mesh: Mesh, { params, version }: Plant): Promise<ArrayBuffer> {
  mesh.userData = { bough: version, params };
  // Without the option it is a JSON object.
  return (await new GLTFExporter().parseAsync(mesh, { binary: true })) as ArrayBuffer;
}

/** OBJ of a mesh; colours stand behind the vertices, where most programs look for them. */
export function obj(mesh: Mesh, { version }: Plant): string {
  return `# Bough ${version}; unit: metre, y up\n${new OBJExporter().parse(mesh)}`;
}
