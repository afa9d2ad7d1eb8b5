import { expect, it } from "vitest";
import { difference, isSame, limits } from "../../tools/visual/difference.mjs";

const picture = (change: (at: number) => number) => Array.from({ length: 4000 }, (_, at) => 120 + change(at));
const paper = picture(() => 0);

it("equal pictures do not differ", () => {
  expect(difference(paper, [...paper])).toEqual({ most: 0, mean: 0 });
  expect(isSame(difference(paper, paper))).toBe(true);
});

it("one pixel that is clearly another is told, however little it is on average", () => {
  const other = picture((at) => (at === 404 ? limits.most + 1 : 0));
  expect(difference(paper, other).mean).toBeLessThan(0.01);
  expect(isSame(difference(paper, other))).toBe(false);
  expect(
    isSame(
      difference(
        paper,
        picture((at) => (at === 404 ? limits.most : 0)),
      ),
    ),
  ).toBe(true);
});

it("another light on everything is told, however little it is in a pixel", () => {
  expect(
    isSame(
      difference(
        paper,
        picture(() => 1),
      ),
    ),
  ).toBe(false);
});

it("transparency does not count, another size does", () => {
  expect(
    isSame(
      difference(
        paper,
        picture((at) => (at % 4 === 3 ? 90 : 0)),
      ),
    ),
  ).toBe(true);
  expect(isSame(difference(paper, paper.slice(4)))).toBe(false);
  expect(isSame(difference([], []))).toBe(false);
});
