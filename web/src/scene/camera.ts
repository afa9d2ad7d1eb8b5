/** The eye: straight at the axis's plane, or anywhere around the plant. */
import { MathUtils, MOUSE, PerspectiveCamera, Spherical, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Glide } from "./glide.ts";

/**
 * `"plane"` looks along z with a shifted lens: the camera stands above the middle and sees the ground, yet the plane of the
 * axis is undistorted, so that lengths and angles can be read off it. `"space"` can be turned.
 */
export type View = "plane" | "space";

/** Vertical, degrees: a long lens, which hardly distorts. */
const fieldOfView = 24;
/** At this distance a length of 1 fills the height. */
const distance = 0.5 / Math.tan(MathUtils.degToRad(fieldOfView / 2));
/** How far the camera of the plane view stands above the middle. */
const lift = 0.24;

/** Where the camera is: around its target, and how far its lens is shifted. */
interface Pose {
  readonly target: Vector3;
  readonly offset: Spherical;
  readonly shift: number;
}

/** Poses that show a frame of height 1 around the origin. */
const home: Readonly<Record<View, Pose>> = {
  plane: { target: new Vector3(0, lift, 0), offset: new Spherical(distance, Math.PI / 2, 0), shift: lift },
  space: {
    target: new Vector3(0, 0, 0),
    offset: new Spherical(distance, MathUtils.degToRad(77), MathUtils.degToRad(32)),
    shift: 0,
  },
};

/** The camera in scene units: the frame is 1 high, and its middle is the origin. */
export class Camera {
  readonly eye = new PerspectiveCamera(fieldOfView, 1, 0.05, 40);
  /** How it looks; `look` changes it. */
  view: View = "plane";
  readonly #element: HTMLElement;
  readonly #controls: OrbitControls;
  #engaged = false;
  readonly #glide = new Glide();
  #from: Pose = home.plane;
  #shift = lift;
  #moved = false;

  /** Takes gestures on an element; calls `changed` whenever the picture must be drawn anew. */
  constructor(element: HTMLElement, changed: () => void) {
    this.#element = element;
    this.#controls = new OrbitControls(this.eye);
    this.#controls.zoomToCursor = true;
    this.#controls.maxPolarAngle = MathUtils.degToRad(93);
    this.#controls.minDistance = 0.02;
    this.#controls.maxDistance = 4 * distance;
    this.#controls.maxTargetRadius = 2;
    this.#controls.addEventListener("start", () => this.#take());
    this.#controls.addEventListener("change", () => {
      // By keys, too, which have no start.
      this.#take();
      changed();
    });
    this.#allow();
    this.#put(home.plane);
    this.engaged = true;
  }

  /** Whether it takes gestures; if not, they are all the page's. */
  set engaged(engaged: boolean) {
    if (engaged === this.#engaged) return;
    this.#engaged = engaged;
    if (engaged) {
      this.#controls.connect(this.#element);
      this.#controls.listenToKeyEvents(this.#element);
    } else {
      this.#controls.disconnect();
      this.#element.style.removeProperty("cursor");
    }
  }

  /** Whether a person has moved the camera away from where the frame fits. */
  get moved(): boolean {
    return this.#moved;
  }

  /** Looks at the plant in the given way; the same view again changes nothing. */
  look(view: View, now: number, jumps: boolean): void {
    if (view === this.view) return;
    this.view = view;
    this.#allow();
    this.fit(now, jumps);
  }

  /** Goes back to where the frame fits. */
  fit(now: number, jumps: boolean): void {
    this.#from = this.#pose();
    this.#moved = false;
    if (jumps) this.#glide.finish();
    else this.#glide.start(now);
    this.advance(now);
  }

  /** Comes closer by a factor, or goes away. */
  zoom(factor: number): void {
    this.#take();
    this.#controls.dollyIn(1 / factor);
  }

  /** Goes on with a passage; whether it goes on after this. */
  advance(now: number): boolean {
    if (this.#moved) return false;
    const share = this.#glide.share(now);
    this.#put(blend(this.#from, home[this.view], share));
    return share < 1;
  }

  /** Takes the size of the picture, in CSS px. */
  resize(width: number, height: number): void {
    this.eye.aspect = width / height;
    this.eye.setViewOffset(width, height, 0, this.#shift * height, width, height);
  }

  dispose(): void {
    this.engaged = false;
  }

  /** From now on the camera is where the person puts it. */
  #take(): void {
    this.#moved = true;
    this.#glide.finish();
  }

  #allow(): void {
    const turns = this.view === "space";
    this.#controls.enableRotate = turns;
    this.#controls.mouseButtons = {
      LEFT: turns ? MOUSE.ROTATE : MOUSE.PAN,
      MIDDLE: MOUSE.DOLLY,
      RIGHT: MOUSE.PAN,
    };
    this.#controls.touches = { ONE: turns ? TOUCH.ROTATE : TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
  }

  #pose(): Pose {
    const target = this.#controls.target.clone();
    const offset = new Spherical().setFromVector3(this.eye.position.clone().sub(target));
    return { target, offset, shift: this.#shift };
  }

  #put({ target, offset, shift }: Pose): void {
    this.#controls.target.copy(target);
    this.eye.position.setFromSpherical(offset).add(target);
    this.#shift = shift;
    const { view } = this.eye;
    if (view) view.offsetY = shift * view.fullHeight;
    this.eye.lookAt(target);
    this.eye.updateProjectionMatrix();
    this.eye.updateMatrixWorld();
  }
}

function blend(from: Pose, to: Pose, share: number): Pose {
  const mix = (a: number, b: number) => MathUtils.lerp(a, b, share);
  return {
    target: from.target.clone().lerp(to.target, share),
    offset: new Spherical(
      mix(from.offset.radius, to.offset.radius),
      mix(from.offset.phi, to.offset.phi),
      mix(from.offset.theta, to.offset.theta),
    ),
    shift: mix(from.shift, to.shift),
  };
}
