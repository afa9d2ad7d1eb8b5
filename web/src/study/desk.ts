/** What a study has before it, and what it may ask of the page. */
import type { SVGTemplateResult, TemplateResult } from "lit";
import type { Engine } from "../engine/engine.ts";
import type { Vector } from "../params/declaration.ts";
import type { State } from "../params/state.ts";
import type { Plant } from "../plant/plant.ts";
import type { Place } from "../scene/annotation.ts";
import type { Stage } from "../scene/stage.ts";

/** The page around the study. */
export interface Desk {
  /** Null where the browser draws no pictures. */
  readonly stage: Stage | null;
  readonly store: { readonly state: State };
  /** The link of the pinned plant, empty if there is none; the address bar carries it. */
  readonly address: { pin: string };
  readonly actions: { change(change: Partial<State>): void };
  /** Starts an engine beside the page's own, which answers only the newest wish. */
  startEngine(): Promise<Engine>;
}

/** What is being looked at. */
export interface Sight {
  /** The shape before the eye, in the midst of a gesture or a replay too. */
  readonly shape: Plant;
  /** Whether nothing moves and nothing is being computed. */
  readonly rests: boolean;
}

/** From m to the picture, CSS px from its upper left corner. */
export type Project = (point: Vector) => Place;

/** One part of the study. */
export interface Section {
  /** For links to it, and for its element. */
  readonly name: string;
  readonly title: string;
  /** Whether a person has it open: only then it is made. */
  open: boolean;
  /** There is something new to look at. */
  see(sight: Sight): void;
  render(): TemplateResult;
  /** What it draws over the picture, which is so large in CSS px; asked for whether it is open or not. */
  draw(project: Project, width: number, height: number): SVGTemplateResult | null;
}
