/** The skin of limbs: green young wood that turns to furrowed bark with age. */
import { Color, DataTexture, LinearFilter, MeshStandardMaterial, SRGBColorSpace } from "three";

/** The colours of wood as it ages, as CSS hex. */
export interface BarkColors {
  /** The newest wood, at the tips. */
  readonly shoot: string;
  readonly youngWood: string;
  readonly bark: string;
}

/** Colours for a light background, and for a dark one. */
export const barkColors: Readonly<Record<"light" | "dark", BarkColors>> = {
  light: { shoot: "#a9bd5c", youngWood: "#84a04e", bark: "#80644b" },
  dark: { shoot: "#bfd074", youngWood: "#98b45e", bark: "#a08064" },
};

const vertexHead = /* glsl */ `
attribute vec3 grain;
attribute float age;
attribute float shade;
uniform float unit;
uniform float grownSteps;
varying vec3 vGrain;
varying float vMaturity;
varying float vShade;
`;

const vertexBody = /* glsl */ `
vGrain = vec3(grain.xy, grain.z * unit);
vMaturity = age / grownSteps;
vShade = shade;
`;

const fragmentHead = /* glsl */ `
uniform vec3 shoot;
uniform vec3 youngWood;
uniform vec3 bark;
uniform float grownSteps;
varying vec3 vGrain;
varying float vMaturity;
varying float vShade;
uniform sampler2D scale;
uniform float painted;

float hash(ivec3 cell) {
  uvec3 q = uvec3(cell) * uvec3(1597334673u, 3812015801u, 2798796415u);
  return float((q.x ^ q.y ^ q.z) * 1597334673u) / 4294967295.0;
}

float noise(vec3 at) {
  ivec3 cell = ivec3(floor(at));
  vec3 f = fract(at);
  f = f * f * (3.0 - 2.0 * f);
  vec4 near = vec4(hash(cell), hash(cell + ivec3(1, 0, 0)), hash(cell + ivec3(0, 1, 0)), hash(cell + ivec3(1, 1, 0)));
  vec4 far = vec4(hash(cell + ivec3(0, 0, 1)), hash(cell + ivec3(1, 0, 1)), hash(cell + ivec3(0, 1, 1)), hash(cell + ivec3(1, 1, 1)));
  vec4 plane = mix(near, far, f.z);
  vec2 line = mix(plane.xy, plane.zw, f.y);
  return mix(line.x, line.y, f.x);
}

// Long furrows along the limb, 0 to 1; what is finer than a pixel fades to its mean.
float furrows(vec3 at) {
  float fine = 1.0 - smoothstep(0.4, 1.3, length(fwidth(at)));
  float coarse = noise(at);
  float veins = noise(at * vec3(2.1, 2.1, 1.6) + 11.0);
  float ridged = 1.0 - abs(2.0 * coarse - 1.0);
  return mix(0.55, 0.6 * ridged * ridged + 0.4 * veins, fine);
}

// A fine ring where one internode ends and the next begins: there the age is a whole number.
float nodes(float steps) {
  float width = fwidth(steps);
  float ring = 1.0 - smoothstep(0.03 + width, 0.1 + 2.0 * width, abs(fract(steps + 0.5) - 0.5));
  return ring * (1.0 - smoothstep(0.06, 0.2, width));
}
`;

const colour = /* glsl */ `
float aged = smoothstep(0.02, 0.6, vMaturity + 0.14 * (noise(vec3(vGrain.xy * 1.3, vGrain.z * 20.0)) - 0.5));
float relief = furrows(vec3(vGrain.xy * 4.2, vGrain.z * 34.0));
vec3 green = mix(shoot, youngWood, smoothstep(0.0, 0.22, vMaturity));
vec3 wood = mix(green, bark, aged);
float marks = mix(1.0, 0.58 + 0.72 * relief, 0.16 + 0.84 * aged);
diffuseColor.rgb = wood * marks * (1.0 - 0.14 * (1.0 - aged) * nodes(vMaturity * grownSteps));
if (painted > 0.5) {
  float ends = 0.5 / float(textureSize(scale, 0).x);
  diffuseColor.rgb = texture2D(scale, vec2(mix(ends, 1.0 - ends, vShade), 0.5)).rgb;
}
`;

// A limb is a few pixels wide: a darker edge draws its outline, as ink does on a plate.
// A colour that means something is kept almost free of light and shadow, as it must be found again in the legend.
const edge = /* glsl */ `
outgoingLight = mix(outgoingLight, diffuseColor.rgb, 0.75 * painted);
float facing = abs(dot(normalize(normal), normalize(vViewPosition)));
outgoingLight *= mix(0.6, 1.0, smoothstep(0.0, 0.45, facing));
#include <opaque_fragment>
`;

/** The material of limbs: it takes the attributes `grain`, `age` and `shade` of `LimbGeometry`. */
export class Bark extends MeshStandardMaterial {
  readonly #uniforms = {
    shoot: { value: new Color() },
    youngWood: { value: new Color() },
    bark: { value: new Color() },
    /** Scene units a metre. */
    unit: { value: 1 },
    /** Growth steps of the full-grown plant. */
    grownSteps: { value: 1 },
    /** Colours that mean something, and 1 where they are shown. */
    scale: { value: null as DataTexture | null },
    painted: { value: 0 },
  };

  constructor(colors: BarkColors = barkColors.light) {
    super({ roughness: 0.82, metalness: 0 });
    this.tint(colors);
  }

  /** Takes over the colours. */
  tint({ shoot, youngWood, bark }: BarkColors): void {
    this.#uniforms.shoot.value.set(shoot);
    this.#uniforms.youngWood.value.set(youngWood);
    this.#uniforms.bark.value.set(bark);
  }

  /** Says how many scene units a metre has: the furrows of a plant one unit large are as fine as they look best. */
  measure(unit: number): void {
    this.#uniforms.unit.value = unit;
  }

  /** Says how many growth steps old the oldest wood gets. */
  age(grownSteps: number): void {
    this.#uniforms.grownSteps.value = Math.max(1, grownSteps);
  }

  /** Shows the shades in these colours, from 0 to 1; null is the wood's own look. */
  paint(colors: readonly string[] | null): void {
    this.#uniforms.painted.value = colors ? 1 : 0;
    this.#uniforms.scale.value?.dispose();
    this.#uniforms.scale.value = colors ? textureOf(colors) : null;
  }

  override dispose(): void {
    this.paint(null);
    super.dispose();
  }

  override onBeforeCompile(shader: Parameters<MeshStandardMaterial["onBeforeCompile"]>[0]): void {
    Object.assign(shader.uniforms, this.#uniforms);
    shader.vertexShader = `${vertexHead}${shader.vertexShader}`.replace(
      "#include <begin_vertex>",
      `#include <begin_vertex>\n${vertexBody}`,
    );
    shader.fragmentShader = `${fragmentHead}${shader.fragmentShader}`
      .replace("#include <color_fragment>", colour)
      .replace("#include <opaque_fragment>", edge);
  }
}

function textureOf(colors: readonly string[]): DataTexture {
  const bytes = colors.flatMap((css) => {
    const code = Number.parseInt(css.slice(1), 16);
    return [code >> 16, (code >> 8) & 255, code & 255, 255];
  });
  const texture = new DataTexture(Uint8Array.from(bytes), colors.length, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
