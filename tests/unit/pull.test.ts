import { expect, test } from "vitest";
import { pullSentence } from "../../web/src/explorer/pull.ts";

test("the pull is said with its force in newtons and grams-force, its direction, and where it holds", () => {
  const pull = { segment: 39, at: [0.5, -0.25, 0], force: [0.3, 0.3, 0] } as const;
  expect(pullSentence({ ...pull, at: [...pull.at], force: [...pull.force] })).toBe(
    "Held at the end of segment 40 by 0.42 N · 43 gf, pulling 45° above the horizontal; it is 50 cm across, 25 cm down.",
  );
});

test("a pull straight down is said so", () => {
  expect(pullSentence({ segment: 0, at: [0, 1, 0], force: [0, -2, 0] })).toContain("pulling straight down;");
});
