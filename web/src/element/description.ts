/** The plant in words: what the picture shows, for readers and for those who do not see it. */
import { quantityText } from "../form/quantity.ts";
import { measure, pathTo } from "../geometry/measure.ts";
import { isBroken, type Plant, type Report } from "../plant/plant.ts";

/** What the gravity number means for an axis. */
export function gravitySentence(q: number): string {
  if (q === 0) return "Nothing weighs on the axis.";
  if (q < 0.5) return "Stiffness rules: the axis hardly feels its weight.";
  if (q < 3) return "Its weight bends the axis a little.";
  if (q < 12) return "Weight and stiffness are a match: the axis arches.";
  if (q < 50) return "Weight rules: the tip hangs.";
  return "The axis hangs almost like a rope.";
}

/** How trustworthy the shape is. */
export function solverSentence({ status, stable, unstableSince, residual }: Report): string {
  const left = `${residual.toExponential(0).replace("-", "−")} of the largest torque is left over`;
  switch (status) {
    case "converged":
      if (stable === false)
        return `An equilibrium, but an unstable one: the least push would tip it (${left}).`;
      return `In stable equilibrium (${left}).`;
    case "maxIterations":
      return `Not in equilibrium: the solver ran out of iterations (${left}).${unstableSince === null ? "" : advice(unstableSince)}`;
    case "nonFinite":
      return "Not in equilibrium: the numbers grew beyond all bounds. Try milder values.";
    case "budget":
      return `Not in equilibrium: the solver ran out of time (${left}).`;
  }
}

/** What to change where growth has lost its equilibrium. */
function advice(lostAt: number): string {
  return ` It last stood at step ${lostAt - 1}; a larger radius or Young's modulus, or less gravity, lets it stand longer.`;
}

/** How far the plant is from breaking, and where it would; empty while nothing is stressed. */
export function strengthSentence(plant: Plant): string {
  const { safetyFactor, breaksFirst } = plant.report;
  if (safetyFactor === null || breaksFirst === null) return "";
  const path = pathTo(plant, breaksFirst);
  const where = path === 0 ? "at the base" : `${size(path)} from the base`;
  return safetyFactor < 1
    ? `It breaks under this load, first ${where}; it is shown as if it held.`
    : `It would break first ${where}, at ${quantityText(safetyFactor, "")} times this stress.`;
}

/** The whole plant in a few sentences. */
export function describe(plant: Plant): string {
  const { params, segments, polylines, report } = plant;
  const { tip, length, tipElevation } = measure(plant);
  const [x, y] = tip;
  const [count, axes] = [segments.parent.length, polylines.offsets.length - 1];
  const parts = `${count} ${count === 1 ? "segment" : "segments"}`;
  const whole = axes === 1 ? `An axis of ${parts}` : `${axes} axes of ${parts} in all; the main one`;
  const sideways = `${size(x)} to the ${x < 0 ? "left" : "right"}`;
  const upwards = `${size(y)} ${y < 0 ? "below" : "above"} it`;
  return [
    `${whole}, ${size(length)} long, leaves its base at ${angle(params.axis.elevation)}.`,
    `Its tip is ${sideways} of the base and ${upwards}, and points ${angle(tipElevation)}.`,
    `${gravitySentence(report.gravityNumber)} ${solverSentence(report)}`,
    ...(isBroken(report) ? [strengthSentence(plant)] : []),
  ].join(" ");
}

/** A direction as people say it: "20° below the horizontal". */
export function angle(elevation: number): string {
  const degrees = Math.round(Math.abs(elevation));
  if (degrees === 0) return "along the horizontal";
  if (degrees === 90) return elevation > 0 ? "straight up" : "straight down";
  return `${degrees}° ${elevation < 0 ? "below" : "above"} the horizontal`;
}

function size(value: number): string {
  return quantityText(Math.abs(value), "m");
}
