import { describe, expect, test } from "vitest";
import { clothingOf, fruitsOf, leavesOf } from "../../web/src/geometry/burden.ts";
import { complete } from "../../web/src/params/params.ts";
import type { Plant } from "../../web/src/plant/plant.ts";
import { handMade } from "./plants.ts";

/** A straight rod of 40 segments of 5 cm, and a twig of 10 on its 20th. */
function plant(params: object): Plant {
  const rod = Array.from({ length: 41 }, (_, k): [number, number, number] => [0.05 * k, 0, 0]);
  const twig = Array.from({ length: 11 }, (_, k): [number, number, number] => [1, 0.05 * k, 0]);
  const radii = (points: unknown[]) => points.map(() => 0.004);
  const axes = handMade({ points: rod, radii: radii(rod) }, { points: twig, radii: radii(twig), on: 19 });
  axes.segments.length.fill(0.05);
  return { ...axes, params: complete(params), version: "" } as unknown as Plant;
}

/** Area of all leaves, m2, if each were of full size: what unfolds at the tip and withers before it falls is smaller. */
function largestArea(grown: Plant): number {
  const clothing = clothingOf(grown);
  if (!clothing) return 0;
  const { count } = leavesOf(grown, clothing, 1);
  return count * 0.31 * clothing.slenderness * clothing.habit.size ** 2;
}

describe("what a plant bears", () => {
  test("is nothing on a plant that bears nothing", () => {
    expect(clothingOf(plant({}))).toBeNull();
    expect(fruitsOf(plant({}), 0)).toBeNull();
  });

  test("has the area that the wind meets, in few leaves or many", () => {
    // Segments 31 to 50 are young: the last ten of the rod and all of the twig.
    for (const foliage of [0.01, 0.1, 1, 10, 400]) {
      const grown = plant({ loads: { foliage, foliageAge: 20, foliageArea: 4 } });
      const met = foliage * 4 * 1;
      // A leaf more or less at each end of young wood; where leaves are few, that is much.
      const spacing = clothingOf(grown)?.habit.spacing ?? 0;
      expect(Math.abs(largestArea(grown) / met - 1)).toBeLessThan(2.1 * spacing + 1e-9);
    }
  });

  test("is drawn in a bounded number of leaves, however long the young wood", () => {
    const grown = plant({ loads: { foliage: 1e3, foliageAge: 1000 } });
    const clothing = clothingOf(grown);
    expect(clothing && leavesOf(grown, clothing, 1).count).toBeLessThanOrEqual(2602);
  });

  test("is needles where the area per mass is small", () => {
    const slenderness = (foliageArea: number) =>
      clothingOf(plant({ loads: { foliage: 0.1, foliageArea } }))?.slenderness;
    expect(slenderness(4)).toBe(1);
    expect(slenderness(1.5)).toBeLessThan(0.5);
    expect(slenderness(0)).toBeUndefined();
  });

  test("does not grow on the stem of an arrangement", () => {
    const loads = { foliage: 0.1, foliageAge: 1000 };
    const alone = clothingOf(plant({ loads }));
    const around = clothingOf(plant({ loads, arrangement: { pattern: "stem" } }));
    expect([alone?.habit.bare, around?.habit.bare]).toEqual([0, 1]);
  });

  test("hangs fruit of the right size at free tips", () => {
    const grown = plant({ loads: { tipMass: 0.2 } });
    const fruits = fruitsOf(grown, 0.2);
    // 0.2 kg at 850 kg/m3 are 235 cm3: a radius of 38 mm.
    expect(fruits?.radius).toBeCloseTo(0.0383, 4);
    expect(fruits?.areFlowers).toBe(false);
    const radius = fruits?.radius ?? 0;
    expect(fruits && [...fruits.centers]).toEqual([2, -radius, 0, 1, 0.5 - radius, 0].map(Math.fround));
    // An axis that ends in a fork has no tip.
    const forked = plant({});
    forked.segments.parent[40] = 39;
    expect(fruitsOf(forked, 0.2)?.centers.length).toBe(3);
    expect(fruitsOf(grown, 0.001)?.areFlowers).toBe(true);
  });
});
