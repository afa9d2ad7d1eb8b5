/** What the page shows, and what a person can do on it. */
import type { Issue } from "../params/issue.ts";
import type { Params } from "../params/params.ts";
import type { State } from "../params/state.ts";
import type { Plant } from "../plant/plant.ts";
import type { Speed } from "../scene/playback.ts";
import type { Pull } from "./touch.ts";

/** A sentence to a person, which stays until it is dismissed. */
export interface Notice {
  readonly text: string;
  readonly tone: "info" | "problem";
  /** Whether the next plant makes it pointless. */
  readonly passes: boolean;
}

/** Everything that the page's parts are made from. */
export interface Model {
  readonly state: State;
  /** What resets bring back: the preset, or the defaults. */
  readonly baseline: Params;
  /** The last good plant, and the same full grown; null before the first. */
  readonly plant: Plant | null;
  readonly grown: Plant | null;
  /** What is wrong with the last entries, by path. */
  readonly issues: ReadonlyMap<string, Issue>;
  readonly notices: readonly Notice[];
  /** Share of a long computation that is done. */
  readonly progress: number | null;
  /** The settled plant in words, for screen readers. */
  readonly announcement: string;
  readonly plays: boolean;
  readonly speed: Speed;
  /** Whether a hand is on the plant, and how it is held once it has answered. */
  readonly holds: boolean;
  readonly pull: Pull | null;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
}

/** What a person can do. */
export interface Actions {
  change(change: Partial<State>, how?: "dragging" | "settled"): void;
  /** The next of the options of one aspect, and after the last the first. */
  next(aspect: "color" | "style" | "view" | "theme"): void;
  choosePreset(id: string | null): void;
  resetAll(): void;
  togglePlay(): void;
  setSpeed(speed: Speed): void;
  /** Shows the plant some growth steps older; younger, if negative. */
  age(steps: number): void;
  toggleLoads(): void;
  /** Takes hold of the tip, or lets go of what is held. */
  toggleHold(): void;
  undo(): void;
  redo(): void;
  copyLink(): void;
  zoom(factor: number): void;
  fit(): void;
  cancel(): void;
  dismiss(notice: Notice): void;
  showControls(): void;
  showGallery(): void;
  showKeys(): void;
  /** Opens what makes files of the plant. */
  showTakeAway(): void;
  /** Opens what makes the snippet for another page. */
  showEmbed(): void;
}
