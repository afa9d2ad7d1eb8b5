/** The ground: a breath of soil on the paper, the plant's shadow, and the dark where the limb meets it. */
import { Color, Group, Mesh, MeshBasicMaterial, PlaneGeometry, ShadowMaterial } from "three";
import type { Palette } from "./palette.ts";

const blend = /* glsl */ `
float fromMiddle = length(vPlace - middle);
float fade = 1.0 - smoothstep(0.12, 0.95, fromMiddle);
float shade = (1.0 - getShadowMask()) * opacity * (1.0 - smoothstep(0.8, 1.4, fromMiddle));
float contact = 0.85 * opacity * exp(-dot(vPlace, vPlace) / max(foot * foot, 1e-12));
float dark = 1.0 - (1.0 - shade) * (1.0 - contact);
float covered = soilCover * fade * fade;
float alpha = dark + covered * (1.0 - dark);
gl_FragColor = vec4(mix(soil, color, dark / max(alpha, 1e-4)), alpha);
`;

/** A horizontal plane in scene units, around the base of the plant. */
export class Ground {
  readonly group = new Group();
  readonly #plane = new PlaneGeometry(8, 8);
  readonly #material = new ShadowMaterial();
  /** Not seen itself, it hides what is in the soil. */
  readonly #cover = new MeshBasicMaterial({ colorWrite: false });
  readonly #uniforms = {
    soil: { value: new Color() },
    soilCover: { value: 0 },
    /** Radius of the dark around the foot of the plant. */
    foot: { value: 0 },
    /** Middle of the picture, from the base of the plant: x and z. */
    middle: { value: [0, 0] },
  };

  constructor() {
    this.#material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#uniforms);
      shader.vertexShader = `varying vec2 vPlace;\n${shader.vertexShader}`.replace(
        "#include <begin_vertex>",
        "#include <begin_vertex>\nvPlace = position.xy * vec2(1.0, -1.0);",
      );
      shader.fragmentShader =
        `varying vec2 vPlace;\nuniform vec2 middle;\nuniform vec3 soil;\nuniform float soilCover;\nuniform float foot;\n${shader.fragmentShader}`.replace(
          "gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );",
          blend,
        );
    };
    const soil = new Mesh(this.#plane, this.#material);
    soil.receiveShadow = true;
    const cover = new Mesh(this.#plane, this.#cover);
    cover.renderOrder = -1;
    this.group.rotation.x = -Math.PI / 2;
    this.group.add(cover, soil);
  }

  tint({ soil, soilCover, shadow, shadowDepth }: Palette): void {
    this.#uniforms.soil.value.set(soil);
    this.#uniforms.soilCover.value = soilCover;
    this.#material.color.set(shadow);
    this.#material.opacity = shadowDepth;
  }

  /** Lies under the base of the plant, all in scene units. */
  place(base: { x: number; z: number }, height: number, foot: number): void {
    this.group.position.set(base.x, height, base.z);
    this.#uniforms.middle.value = [-base.x, -base.z];
    this.#uniforms.foot.value = foot;
  }

  dispose(): void {
    this.#plane.dispose();
    this.#material.dispose();
    this.#cover.dispose();
  }
}
