/** What is read off a live figure of the course, in words and numbers below it. */
import { angle } from "../element/description.ts";
import { numberText, quantityText } from "../form/quantity.ts";
import { measure } from "../geometry/measure.ts";
import type { Plant } from "../plant/plant.ts";

/** What can be read off, by the names that the figures use. */
const readings: Readonly<Record<string, (plant: Plant) => string>> = {
  tip: (plant) => {
    const [x, y] = measure(plant).tip;
    return `tip at x = ${quantityText(x, "m")}, y = ${quantityText(y, "m")}`;
  },
  direction: (plant) => `the tip points ${angle(measure(plant).tipElevation)}`,
  length: (plant) => `length ${quantityText(measure(plant).length, "m")}`,
  q: ({ report }) => `gravity number q = ${numberText(report.gravityNumber)}`,
  radius: ({ segments }) => `radius at the base ${quantityText(segments.radius[0] ?? 0, "m")}`,
  moment: ({ segments }) => {
    const largest = segments.moment.reduce((most, moment) => Math.max(most, Math.abs(moment)), 0);
    return `largest bending moment ${numberText(largest)} N m`;
  },
  stability: ({ report }) =>
    report.stable === false ? "the equilibrium is unstable" : "the equilibrium is stable",
};

/** The names of all readings. */
export const readingNames: readonly string[] = Object.keys(readings);

/** A plant's readings as one sentence: "Tip at x = 1.1 m, y = −72.4 cm; gravity number q = 15". */
export function readingText(plant: Plant, names: readonly string[]): string {
  const text = names.map((name) => readings[name]?.(plant) ?? "").join("; ");
  return text.charAt(0).toUpperCase() + text.slice(1).replaceAll(/(?<= )-(?=\d)/g, "−");
}
