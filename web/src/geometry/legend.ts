/** The key to a picture whose colours mean something. */
import type { Text } from "../language/english.ts";
import { say } from "../language/say.ts";
import { digits, type Scale, scaleFor } from "./quantity.ts";
import { type Color, isSigned, type Measured, type Paint, type Range, rangeOf } from "./shade.ts";
import type { Axes } from "./tube.ts";

/** A colour scale with its numbers, for a picture of it. */
export interface Legend {
  readonly title: string;
  /** Of the ticks, with a prefix: "mN m". */
  readonly unit: string;
  /** In the plain SI unit. */
  readonly min: number;
  readonly max: number;
  /** Colours along the scale; `offset` 0 is the least value, 1 the largest. */
  readonly stops: readonly { readonly offset: number; readonly css: string }[];
  /** Round values along the scale, as multiples of `unit`. */
  readonly ticks: readonly { readonly offset: number; readonly text: string }[];
}

const titles: Readonly<Record<Measured, { title: Text; unit: string }>> = {
  moment: { title: "Bending moment", unit: "N m" },
  stress: { title: "Largest stress", unit: "Pa" },
  curvature: { title: "Curvature", unit: "1/m" },
  age: { title: "Age of the wood", unit: "steps" },
};

/** Cividis, by Nunez, Anderton & Renslow (2018), doi:10.1371/journal.pone.0199239: even in lightness, the same for colour-blind eyes. */
const rising = "#002051 #11366c #3c4d6e #62646f #7f7c75 #9a9478 #bbaf71 #e2cb5c #fdea45".split(" ");
/** Blue for clockwise, red for counter-clockwise, by Moreland (2009), doi:10.1007/978-3-642-10520-3_9. */
const parting = "#3b4cc0 #6282ea #8db0fe #b8d0f9 #dddddd #f5c4ad #f49a7b #de604d #b40426".split(" ");

/** What colours the picture of a plant; null is its own bark. Reaches over the `grown` plant as well, as `legend` does. */
export function paintOf(plant: Axes, color: Color, grown: Axes = plant): Paint | null {
  if (color === "bark") return null;
  return { color, colors: isSigned(color) ? parting : rising, range: rangeOf(color, [plant, grown]) };
}

/**
 * The key to the colours of a plant; null for its own. The scale reaches over the `grown` plant as well, as in the picture,
 * so that a colour means the same at all ages.
 */
export function legend(plant: Axes, color: Color, grown: Axes = plant): Legend | null {
  const paint = paintOf(plant, color, grown);
  if (!paint) return null;
  const { range, colors } = paint;
  const { title, unit } = titles[paint.color];
  const scale = scaleFor(range.max, unit);
  return {
    title: say(title),
    unit: scale.unit === "steps" ? say("steps") : scale.unit,
    ...range,
    stops: colors.map((css, i) => ({ offset: i / (colors.length - 1), css })),
    ticks: roundValues(range, scale).map((value) => ({
      offset: (value - range.min) / (range.max - range.min),
      text: digits(value / scale.size),
    })),
  };
}

/** Two to seven multiples of 1, 2 or 5 (times a power of ten) of the unit that lie in the range, zero among them. */
function roundValues({ min, max }: Range, { unit, size }: Scale): number[] {
  const span = (max - min) / size;
  const power = 10 ** Math.floor(Math.log10(span));
  const fitting = [0.1, 0.2, 0.5, 1, 2].find((digit) => span / (digit * power) <= 5 + 1e-9) ?? 5;
  const step = unit === "steps" ? Math.max(1, fitting * power) : fitting * power;
  const first = Math.ceil((min / size / step) * (1 + 1e-9) - 1e-9);
  const last = Math.floor((max / size / step) * (1 + 1e-9));
  return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step * size);
}
