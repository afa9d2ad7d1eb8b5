/** Daylight: a soft sky, a sun that casts the shadow, and a weak light from behind that parts limbs from the paper. */
import { DirectionalLight, Group, HemisphereLight } from "three";
import type { Palette } from "./palette.ts";

/** How far the lit part reaches from the middle of the picture, in picture heights. */
const reach = 1.5;

export class Light {
  readonly group = new Group();
  readonly #sky = new HemisphereLight();
  readonly #sun = new DirectionalLight();
  readonly #rim = new DirectionalLight();

  constructor() {
    this.#sun.position.set(-1.1, 3.2, 1.5);
    this.#rim.position.set(1.6, 1.2, -2);
    this.#sun.castShadow = true;
    const { shadow } = this.#sun;
    shadow.mapSize.set(2048, 2048);
    shadow.radius = 3.5;
    shadow.normalBias = 0.004;
    shadow.bias = -0.0004;
    shadow.camera.left = -reach;
    shadow.camera.right = reach;
    shadow.camera.top = reach;
    shadow.camera.bottom = -reach;
    shadow.camera.near = 0.5;
    shadow.camera.far = 7;
    this.group.add(this.#sky, this.#sun, this.#rim);
  }

  tint(palette: Palette): void {
    this.#sky.color.set(palette.sky);
    this.#sky.groundColor.set(palette.bounce);
    this.#sky.intensity = palette.ambient;
    this.#sun.color.set(palette.sun);
    this.#sun.intensity = palette.sunlight;
    this.#rim.color.set(palette.sky);
    this.#rim.intensity = palette.rim;
  }

  dispose(): void {
    this.#sun.dispose();
  }
}
