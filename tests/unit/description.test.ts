import { describe, expect, it } from "vitest";
import {
  angle,
  describe as described,
  gravitySentence,
  solverSentence,
  strengthSentence,
} from "../../web/src/element/description.ts";
import { complete } from "../../web/src/params/params.ts";
import type { Plant, Report } from "../../web/src/plant/plant.ts";
import { handMade } from "./plants.ts";

const sound: Report = {
  status: "converged",
  stable: true,
  unstableSince: null,
  residual: 3.2e-12,
  worstStepResidual: 3.2e-12,
  iterations: 3,
  steps: 2,
  gravityNumber: 5,
  steppingError: null,
  selfBuckling: null,
  safetyFactor: 4.08,
  breaksFirst: 1,
};

describe("the description", () => {
  it("says what the picture shows", () => {
    const axes = handMade({
      points: [
        [0, 0, 0],
        [0.5, 0.5, 0],
        [1, 0.5, 0],
      ],
      radii: [0.1, 0.1, 0.1],
    });
    axes.segments.length.set([Math.SQRT1_2, 0.5]);
    const plant = {
      ...axes,
      params: complete({ axis: { elevation: 45 } }),
      version: "",
      report: sound,
    } as Plant;
    expect(described(plant)).toBe(
      "An axis of 2 segments, 1.21 m long, leaves its base at 45° above the horizontal. " +
        "Its tip is 1 m to the right of the base and 50 cm above it, and points along the horizontal. " +
        "Weight and stiffness are a match: the axis arches. " +
        "In stable equilibrium (3e−12 of the largest torque is left over).",
    );
    expect(strengthSentence(plant)).toBe(
      "It would break first 70.7 cm from the base, at 4.08 times this stress.",
    );
    const broken = { ...plant, report: { ...sound, safetyFactor: 0.8, breaksFirst: 0 } };
    const sentence = "It breaks under this load, first at the base; it is shown as if it held.";
    expect(strengthSentence(broken)).toBe(sentence);
    expect(described(broken)).toContain(sentence);
    const unstressed = { ...plant, report: { ...sound, safetyFactor: null, breaksFirst: null } };
    expect(strengthSentence(unstressed)).toBe("");
  });

  it.each([
    [90, "straight up"],
    [-90, "straight down"],
    [-0.3, "along the horizontal"],
    [-20, "20° below the horizontal"],
  ])("calls %d degrees %s", (degrees, words) => {
    expect(angle(degrees)).toBe(words);
  });

  it("has a sentence for every gravity number", () => {
    const sentences = [0, 0.1, 1, 5, 20, 1000].map(gravitySentence);
    expect(new Set(sentences).size).toBe(6);
  });

  it("does not call solved what is not", () => {
    expect(solverSentence({ ...sound, stable: false })).toContain("unstable");
    for (const status of ["maxIterations", "nonFinite", "budget"] as const) {
      expect(solverSentence({ ...sound, status, stable: null })).toContain("Not in equilibrium");
    }
  });
});
