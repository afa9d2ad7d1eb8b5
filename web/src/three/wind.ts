/** Wind that moves plants on the graphics card, by the weights that limbs and leaves have in their attribute `sway`. */
import { type Mesh, MeshDepthMaterial, type Object3D, Vector3 } from "three";
import { Leaves } from "./leaves.ts";

type Shader = Parameters<MeshDepthMaterial["onBeforeCompile"]>[0];

const head = /* glsl */ `
attribute float sway;
uniform vec3 windLean;
uniform float windTime;

// Gusts that travel with the wind: a plant is reached as a whole, and answers with its own slower and quicker swing.
vec3 windShift() {
  float phase = dot(modelMatrix[3].xyz, windLean) / max(length(windLean), 1e-9);
  float gust = 0.55 + 0.3 * sin(1.1 * windTime - 0.7 * phase) + 0.15 * sin(2.9 * windTime - 1.9 * phase);
  return windLean * gust * sway;
}
`;

const project = /* glsl */ `
vec4 mvPosition = vec4(transformed, 1.0);
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelMatrix * mvPosition;
mvPosition.xyz += windShift();
mvPosition = viewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;

const place = /* glsl */ `
#include <worldpos_vertex>
#if defined(USE_ENVMAP) || defined(DISTANCE) || defined(USE_SHADOWMAP) || defined(USE_TRANSMISSION) || NUM_SPOT_LIGHT_COORDS > 0
worldPosition.xyz += windShift();
#endif
`;

/** One wind for a whole scene: give it all plants once, and the time before each frame. */
export class Wind {
  /** How far the part that moves most leans in the strongest gust: direction and size, in world units. */
  readonly lean: Vector3;
  readonly #uniforms: { windLean: { value: Vector3 }; windTime: { value: number } };
  readonly #moved = new WeakSet<object>();
  /** What all shadows are drawn with. */
  readonly #shadow = new MeshDepthMaterial();

  constructor(lean: Vector3 = new Vector3(0.1, 0, 0)) {
    this.lean = lean;
    this.#uniforms = { windLean: { value: lean }, windTime: { value: 0 } };
  }

  /** The time, s. */
  set time(seconds: number) {
    this.#uniforms.windTime.value = seconds;
  }

  /**
   * Lets everything below an object move that has the attribute `sway`, its shadow too. Materials are changed: others that share
   * them move as well. Clones need it too, for their shadows, and are made after their original was given.
   */
  blow(plant: Object3D): void {
    plant.traverse((part) => {
      if (part instanceof Leaves) part.weigh();
      const mesh = part as Mesh;
      if (!mesh.isMesh || !mesh.geometry.hasAttribute("sway")) return;
      for (const material of [mesh.material].flat()) this.#move(material);
      mesh.customDepthMaterial ??= this.#shadow;
      this.#move(mesh.customDepthMaterial);
    });
  }

  #move(
    material: Pick<MeshDepthMaterial, "onBeforeCompile" | "customProgramCacheKey" | "needsUpdate">,
  ): void {
    if (this.#moved.has(material)) return;
    this.#moved.add(material);
    const before = material.onBeforeCompile;
    const key = material.customProgramCacheKey();
    material.onBeforeCompile = (shader: Shader, renderer) => {
      before.call(material, shader, renderer);
      Object.assign(shader.uniforms, this.#uniforms);
      shader.vertexShader = `${head}${shader.vertexShader}`
        .replace("#include <project_vertex>", project)
        .replace("#include <worldpos_vertex>", place);
    };
    // Programs are shared by what their change is called: ours is called the same for all.
    material.customProgramCacheKey = () => `bough-wind ${key}`;
    material.needsUpdate = true;
  }
}
