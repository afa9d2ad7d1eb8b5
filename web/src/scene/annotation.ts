/** What a plate writes over its drawing: the ground line, the angle of elevation, and the scale bar. */
import type { Vector } from "../geometry/bounds.ts";
import type { Frame } from "../geometry/frame.ts";
import { rulerWithin } from "../geometry/ruler.ts";
import type { View } from "./camera.ts";
import { type Force, ForceArrow } from "./force.ts";

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
  /** px a metre at the base. */
  readonly scale: number;
  /** A force that is to be shown. */
  readonly force: Force | null;
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
  readonly #force = new ForceArrow();

  constructor() {
    this.element.append(this.#force.element);
    this.element.setAttribute("class", "annotation");
    this.element.setAttribute("aria-hidden", "true");
  }

  draw(subject: Subject): void {
    this.#drawGround(subject);
    this.#future.setAttribute("d", subject.future.map(pathOf).join(""));
    this.#drawElevation(subject);
    this.#drawScale(subject);
    this.#force.draw(subject.force, subject.project, 0.01 * subject.frame.height, subject);
  }

  #drawGround({ frame, view, project }: Subject): void {
    this.#ground.style.display = view === "plane" ? "" : "none";
    const reach = 0.46 * frame.height;
    const [x] = frame.center;
    const span = Math.max(Math.abs(x) + 0.25 * frame.height, reach);
    line(this.#ground, [project([x - span, frame.ground, 0]), project([x + span, frame.ground, 0])]);
  }

  #drawElevation({ frame, base, heading, elevation, present, future, project }: Subject): void {
    const radius = 0.1 * frame.height;
    const towards = (angle: number, distance: number): Place => {
      const radians = (angle * Math.PI) / 180;
      const [across, up] = [distance * Math.cos(radians), distance * Math.sin(radians)];
      return project([base[0] + across * heading[0], base[1] + up, base[2] + across * heading[2]]);
    };
    const corner = project(base);
    line(this.#horizontal, [corner, towards(0, 1.4 * radius)]);
    line(this.#rest, [corner, towards(elevation, 1.7 * radius)]);
    const steps = Math.max(2, Math.ceil(Math.abs(elevation) / 5));
    const angles = Array.from({ length: steps + 1 }, (_, i) => (elevation * i) / steps);
    line(
      this.#arc,
      angles.map((angle) => towards(angle, radius)),
    );
    const side = elevation < 0 ? -1 : 1;
    const places = [
      towards(elevation / 2, 1.4 * radius),
      towards(elevation + 16 * side, 1.7 * radius),
      towards(elevation, 2.1 * radius),
      towards(elevation + 38 * side, 1.6 * radius),
    ];
    write(
      this.#angle,
      freest(places, [...present, ...future].flat()),
      `${Number(elevation.toFixed(1))}°`.replace("-", "−"),
      "middle",
    );
  }

  #drawScale({ scale, girth, future, width, height }: Subject): void {
    const { length, text } = rulerWithin(Math.min(160, 0.4 * width) / scale);
    const [left, bottom] = [inset, height - inset];
    const right = left + length * scale;
    const tick = 5;
    this.#bar.setAttribute("d", `M${left} ${bottom - tick}V${bottom}H${right.toFixed(1)}V${bottom - tick}`);
    const legend = [text];
    if (girth > 1) legend.push(`girth ×${girth}`);
    if (future.length > 0 && width > wide) legend.push("dotted: full grown");
    write(this.#length, { x: left, y: bottom - 10 }, legend.join(" · "), "start");
  }

  #add<Name extends "path" | "text">(name: Name, className: string): SVGElementTagNameMap[Name] {
    const element = document.createElementNS(svg, name);
    element.setAttribute("class", className);
    this.element.append(element);
    return element;
  }
}

/** At this distance from the plant a label is free. px */
const clearance = 28;

/** The first place that is free of the line, else the one that is farthest from it. */
function freest(places: readonly Place[], line: readonly Place[]): Place {
  const distances = places.map((place) =>
    line.reduce((least, { x, y }) => Math.min(least, Math.hypot(x - place.x, y - place.y)), Infinity),
  );
  const free = distances.findIndex((distance) => distance >= clearance);
  return places[free >= 0 ? free : distances.indexOf(Math.max(...distances))] ?? { x: 0, y: 0 };
}

function line(path: SVGPathElement, places: readonly Place[]): void {
  path.setAttribute("d", pathOf(places));
}

function pathOf(places: readonly Place[]): string {
  return `M${places.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
}

function write(text: SVGTextElement, { x, y }: Place, content: string, anchor: "start" | "middle"): void {
  text.setAttribute("x", x.toFixed(1));
  text.setAttribute("y", y.toFixed(1));
  text.setAttribute("text-anchor", anchor);
  text.textContent = content;
}
