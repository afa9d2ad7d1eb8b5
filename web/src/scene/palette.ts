/** The colours of the picture, for paper and for the dark. */

import { type BarkColors, barkColors } from "../three/bark.ts";

/** The two looks a picture can have. */
export type Tone = "light" | "dark";

/** Colours as CSS hex; strengths as three.js light intensities. */
export interface Palette extends BarkColors {
  /** Of the model: rigid segments, springs and masses. */
  readonly rod: string;
  readonly spring: string;
  readonly mass: string;
  readonly stand: string;
  readonly soil: string;
  /** How much of the soil's colour covers the paper under the plant, 0 to 1. */
  readonly soilCover: number;
  readonly shadow: string;
  /** How dark the shadow is, 0 to 1. */
  readonly shadowDepth: number;
  readonly sky: string;
  readonly bounce: string;
  readonly ambient: number;
  readonly sun: string;
  readonly sunlight: number;
  readonly rim: number;
}

export const palettes: Readonly<Record<Tone, Palette>> = {
  light: {
    ...barkColors.light,
    rod: "#6d6f66",
    spring: "#c0702c",
    mass: "#39512a",
    stand: "#c9c4b6",
    soil: "#d8cfbd",
    soilCover: 0.55,
    shadow: "#3b3226",
    shadowDepth: 0.34,
    sky: "#fdfcf7",
    bounce: "#b9a98c",
    ambient: 1.7,
    sun: "#fff3dc",
    sunlight: 2.3,
    rim: 0.5,
  },
  dark: {
    ...barkColors.dark,
    rod: "#a9aba0",
    spring: "#e8a062",
    mass: "#b9d58c",
    stand: "#6a6f66",
    soil: "#33372d",
    soilCover: 0.7,
    shadow: "#050604",
    shadowDepth: 0.6,
    sky: "#c3cfd6",
    bounce: "#4d4a3e",
    ambient: 1.35,
    sun: "#ffe9c8",
    sunlight: 2.6,
    rim: 1.1,
  },
};
