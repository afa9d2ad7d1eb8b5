/** The plant in words: what the picture shows, for readers and for those who do not see it. */
import { quantityText } from "../form/quantity.ts";
import { measure, pathTo } from "../geometry/measure.ts";
import { language, say } from "../language/say.ts";
import { isBroken, type Plant, type Report } from "../plant/plant.ts";

/** What the gravity number means for an axis. */
export function gravitySentence(q: number): string {
  if (q === 0) return say("Nothing weighs on the axis.");
  if (q < 0.5) return say("Stiffness rules: the axis hardly feels its weight.");
  if (q < 3) return say("Its weight bends the axis a little.");
  if (q < 12) return say("Weight and stiffness are a match: the axis arches.");
  if (q < 50) return say("Weight rules: the tip hangs.");
  return say("The axis hangs almost like a rope.");
}

/** How trustworthy the shape is. */
export function solverSentence({ status, stable, unstableSince, residual }: Report): string {
  const left = residual.toExponential(0).replace("-", "−");
  switch (status) {
    case "converged":
      if (stable === false)
        return say(
          "An equilibrium, but an unstable one: the least push would tip it ({0} of the largest torque is left over).",
          left,
        );
      return say("In stable equilibrium ({0} of the largest torque is left over).", left);
    case "maxIterations":
      return [
        say(
          "Not in equilibrium: the solver ran out of iterations ({0} of the largest torque is left over).",
          left,
        ),
        ...(unstableSince === null ? [] : [advice(unstableSince)]),
      ].join(" ");
    case "nonFinite":
      return say("Not in equilibrium: the numbers grew beyond all bounds. Try milder values.");
    case "budget":
      return say(
        "Not in equilibrium: the solver ran out of time ({0} of the largest torque is left over).",
        left,
      );
  }
}

/** What to change where growth has lost its equilibrium. */
function advice(lostAt: number): string {
  return say(
    "It last stood at step {0}; a larger radius or Young's modulus, or less gravity, lets it stand longer.",
    lostAt - 1,
  );
}

/** How far the plant is from breaking, and where it would; empty while nothing is stressed. */
export function strengthSentence(plant: Plant): string {
  const { safetyFactor, breaksFirst } = plant.report;
  if (safetyFactor === null || breaksFirst === null) return "";
  const path = pathTo(plant, breaksFirst);
  const factor = quantityText(safetyFactor, "");
  if (safetyFactor < 1) {
    return path === 0
      ? say("It breaks under this load, first at the base; it is shown as if it held.")
      : say("It breaks under this load, first {0} from the base; it is shown as if it held.", size(path));
  }
  return path === 0
    ? say("It would break first at the base, at {0} times this stress.", factor)
    : say("It would break first {0} from the base, at {1} times this stress.", size(path), factor);
}

/** The whole plant in a few sentences. */
export function describe(plant: Plant): string {
  const { params, segments, polylines, report } = plant;
  const { tip, length, tipElevation } = measure(plant);
  const [x, y] = tip;
  const [count, axes] = [segments.parent.length, polylines.offsets.length - 1];
  const where = angle(params.axis.elevation);
  const whole =
    axes > 1
      ? say(
          "{0} axes of {1} segments in all; the main one, {2} long, leaves its base at {3}.",
          axes,
          count,
          size(length),
          where,
        )
      : count === 1
        ? say("An axis of 1 segment, {0} long, leaves its base at {1}.", size(length), where)
        : say("An axis of {0} segments, {1} long, leaves its base at {2}.", count, size(length), where);
  const tipPlace =
    y < 0
      ? x < 0
        ? say(
            "Its tip is {0} to the left of the base and {1} below it, and points {2}.",
            size(x),
            size(y),
            angle(tipElevation),
          )
        : say(
            "Its tip is {0} to the right of the base and {1} below it, and points {2}.",
            size(x),
            size(y),
            angle(tipElevation),
          )
      : x < 0
        ? say(
            "Its tip is {0} to the left of the base and {1} above it, and points {2}.",
            size(x),
            size(y),
            angle(tipElevation),
          )
        : say(
            "Its tip is {0} to the right of the base and {1} above it, and points {2}.",
            size(x),
            size(y),
            angle(tipElevation),
          );
  return [
    whole,
    tipPlace,
    gravitySentence(report.gravityNumber),
    solverSentence(report),
    ...(isBroken(report) ? [strengthSentence(plant)] : []),
  ].join(language() === "zh" ? "" : " ");
}

/** Where something is from the base: "1.2 m across, 40 cm up". */
export function placed(across: string, up: string, isDown: boolean): string {
  return isDown ? say("{0} across, {1} down", across, up) : say("{0} across, {1} up", across, up);
}

/** A direction as people say it: "20° below the horizontal". */
export function angle(elevation: number): string {
  const degrees = Math.round(Math.abs(elevation));
  if (degrees === 0) return say("along the horizontal");
  if (degrees === 90) return elevation > 0 ? say("straight up") : say("straight down");
  return elevation < 0
    ? say("{0}° below the horizontal", degrees)
    : say("{0}° above the horizontal", degrees);
}

function size(value: number): string {
  return quantityText(Math.abs(value), "m");
}
