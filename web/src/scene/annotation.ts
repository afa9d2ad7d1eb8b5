/** What a plate writes over its drawing: the ground line, the angle of elevation, and the scale bar. */
import type { Vector } from "../geometry/bounds.ts";
import { clip } from "../geometry/clip.ts";
import type { Frame } from "../geometry/frame.ts";
import { rulerWithin } from "../geometry/ruler.ts";
import { local } from "../language/number.ts";
import { say } from "../language/say.ts";
import type { View } from "./camera.ts";
import { type Force, ForceArrow } from "./force.ts";
import { freest } from "./label.ts";

/** A place on the picture, CSS px from its upper left corner. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** What the annotation is about. */
export interface Subject {
  readonly frame: Frame;
  /** The ground line is drawn only where the ground is seen from its edge. */
  readonly view: View;
  /** The axes on the picture: labels keep away from them. */
  readonly present: readonly (readonly Place[])[];
  /** The axes of the plant when it is full grown, where that is still to come. */
  readonly future: readonly (readonly Place[])[];
  /** Where the axis that stands for all is attached, m, and the horizontal direction that its elevation is counted from. */
  readonly base: Vector;
  readonly heading: Vector;
  /** Direction of the base above the horizontal, degrees. */
  readonly elevation: number;
  /** How many times too thick limbs are drawn. */
  readonly girth: number;
  /** Drawn radius of the plant's base, m. */
  readonly foot: number;
  /** px a metre at the base. */
  readonly scale: number;
  /** A force that is to be shown. */
  readonly force: Force | null;
  /** Where the plant breaks first under its load, m; null where it holds. */
  readonly broken: Vector | null;
  readonly width: number;
  readonly height: number;
  /** From m to the picture. */
  project(point: Vector): Place;
}

const svg = "http://www.w3.org/2000/svg";
const inset = 20;
/** From this width on there is room for the whole legend. px */
const wide = 480;

/** An SVG over the picture. It is for the eye only: the page tells the same in words. */
export class Annotation {
  readonly element = document.createElementNS(svg, "svg");
  readonly #ground = this.#add("path", "ground-line");
  readonly #future = this.#add("path", "future");
  readonly #horizontal = this.#add("path", "horizontal");
  readonly #rest = this.#add("path", "rest-direction");
  readonly #arc = this.#add("path", "elevation-arc");
  readonly #angle = this.#add("text", "angle");
  readonly #bar = this.#add("path", "scale-bar");
  readonly #length = this.#add("text", "length");
  readonly #break = this.#add("path", "break");
  readonly #breakText = this.#add("text", "break");
  readonly #force = new ForceArrow();
  /** Height of the angle's letters, px; its size may be a style's, so it is read anew with every size of the picture. */
  #letter = 16;
  #size = "";

  constructor() {
    this.element.append(this.#force.element);
    this.element.setAttribute("class", "annotation");
    this.element.setAttribute("aria-hidden", "true");
    this.element.setAttribute("preserveAspectRatio", "none");
  }

  draw(subject: Subject): void {
    const size = `${subject.width} ${subject.height}`;
    if (size !== this.#size) {
      this.#letter = Number.parseFloat(getComputedStyle(this.#angle).fontSize) || 16;
      // As the canvas does, it fits itself into whatever room it is printed in.
      this.element.setAttribute("viewBox", `0 0 ${size}`);
    }
    this.#size = size;
    this.#drawGround(subject);
    const { width, height } = subject;
    const future = subject.future.flatMap((line) => clip(line, width, height));
    put(this.#future, { d: future.map(pathOf).join("") });
    this.#drawElevation(subject);
    this.#drawScale(subject);
    this.#drawBreak(subject);
    this.#force.draw(subject.force, subject.project, 0.01 * subject.frame.height, subject);
  }

  #drawGround({ frame, view, project }: Subject): void {
    this.#ground.style.display = view === "plane" ? "" : "none";
    const reach = 0.46 * frame.height;
    const [x] = frame.center;
    const span = Math.max(Math.abs(x) + 0.25 * frame.height, reach);
    line(this.#ground, [project([x - span, frame.ground, 0]), project([x + span, frame.ground, 0])]);
  }

  #drawElevation(subject: Subject): void {
    const { frame, base, heading, elevation, present, future, foot, scale, project } = subject;
    const radius = 0.1 * frame.height;
    const towards = (angle: number, distance: number): Place => {
      const radians = (angle * Math.PI) / 180;
      const [across, up] = [distance * Math.cos(radians), distance * Math.sin(radians)];
      return project([base[0] + across * heading[0], base[1] + up, base[2] + across * heading[2]]);
    };
    const corner = project(base);
    const horizontal = [corner, towards(0, 1.4 * radius)];
    const rest = [corner, towards(elevation, 1.7 * radius)];
    const steps = Math.max(2, Math.ceil(Math.abs(elevation) / 5));
    const arc = Array.from({ length: steps + 1 }, (_, i) => towards((elevation * i) / steps, radius));
    line(this.#horizontal, horizontal);
    line(this.#rest, rest);
    line(this.#arc, arc);
    const ground = project([base[0], frame.ground, base[2]]);
    const stem = [corner, ground];
    const earth = [
      { x: 0, y: ground.y },
      { x: subject.width, y: ground.y },
    ];
    const text = `${local(String(Number(elevation.toFixed(1))))}°`.replace("-", "−");
    const room = { width: 0.55 * this.#letter * text.length, height: 0.8 * this.#letter };
    const obstacles = [
      ...present.map((places) => ({ places, thickness: foot * scale })),
      ...future.map((places) => ({ places, thickness: 1 })),
      ...[horizontal, rest, arc, earth].map((places) => ({ places, thickness: 1 })),
      { places: stem, thickness: 2 * foot * scale },
    ];
    write(this.#angle, freest(places(elevation, radius, towards), room, obstacles, subject), text, "middle");
  }

  #drawBreak({ broken, project, width }: Subject): void {
    for (const element of [this.#break, this.#breakText]) element.style.display = broken ? "" : "none";
    if (!broken) return;
    const { x, y } = project(broken);
    const at = `${x.toFixed(1)} ${y.toFixed(1)}`;
    put(this.#break, { d: `M${at}m-9 0a9 9 0 1 0 18 0a9 9 0 1 0-18 0m5-4l8 8m0-8l-8 8` });
    const isFree = x < width - 110;
    write(this.#breakText, { x: x + (isFree ? 15 : -15), y: y - 8 }, "breaks here", isFree ? "start" : "end");
  }

  #drawScale({ scale, girth, future, width, height }: Subject): void {
    const { length, text } = rulerWithin(Math.min(160, 0.4 * width) / scale);
    const [left, bottom] = [inset, height - inset];
    const right = left + length * scale;
    const tick = 5;
    put(this.#bar, { d: `M${left} ${bottom - tick}V${bottom}H${right.toFixed(1)}V${bottom - tick}` });
    const legend = [text];
    if (girth > 1) legend.push(say("girth ×{0}", girth));
    if (future.length > 0 && width > wide) legend.push(say("dotted: full grown"));
    write(this.#length, { x: left, y: bottom - 10 }, legend.join(" · "), "start");
  }

  #add<Name extends "path" | "text">(name: Name, className: string): SVGElementTagNameMap[Name] {
    const element = document.createElementNS(svg, name);
    element.setAttribute("class", className);
    this.element.append(element);
    return element;
  }
}

/** Where a label of the angle may stand, best first: within the angle and beside it, ever farther out, then on the other side. */
function places(
  elevation: number,
  radius: number,
  towards: (angle: number, distance: number) => Place,
): Place[] {
  const side = elevation < 0 ? -1 : 1;
  const beside = [elevation / 2, elevation + 16 * side, elevation + 38 * side, elevation + 65 * side];
  const across = [180 - elevation / 2, -30 * side, -60 * side, 180 + 30 * side];
  return [beside, across].flatMap((angles) =>
    [1.4, 1.7, 2.1, 2.6, 3.2].flatMap((distance) => angles.map((angle) => towards(angle, distance * radius))),
  );
}

function line(path: SVGPathElement, places: readonly Place[]): void {
  put(path, { d: pathOf(places) });
}

function pathOf(places: readonly Place[]): string {
  return `M${places.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
}

function write(
  text: SVGTextElement,
  { x, y }: Place,
  content: string,
  anchor: "start" | "middle" | "end",
): void {
  put(text, { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor });
  if (text.textContent !== content) text.textContent = content;
}

/** Sets only what is other than before: the browser lays text out anew for every attribute that is set. */
function put(element: SVGElement, attributes: Readonly<Record<string, string>>): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
}
