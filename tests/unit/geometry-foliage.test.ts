import { describe, expect, test } from "vitest";
import { foliageOf, habitFor } from "../../web/src/geometry/foliage.ts";
import { handMade } from "./plants.ts";

/** A helix of 60 segments, as a limb in space. */
const helix = handMade({
  points: Array.from({ length: 61 }, (_, k) => [Math.cos(0.1 * k), 0.05 * k, Math.sin(0.1 * k)]),
  radii: Array.from({ length: 61 }, () => 0.02),
});
helix.segments.length.fill(Math.hypot(2 * Math.sin(0.05), 0.05));
helix.segments.radius.fill(0.02);
const habit = { youth: 20, spacing: 0.1, size: 0.2, divergence: 137.5, angle: 55, light: 0, bare: 0 };

type Triple = [number, number, number];
const column = (matrices: Float32Array, leaf: number, k: number) =>
  [...matrices.subarray(16 * leaf + 4 * k, 16 * leaf + 4 * k + 3)] as Triple;
const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);

describe("leaves", () => {
  const { count, matrices, ages, sways } = foliageOf(helix, habit);

  test("stand on young wood only, one for each spacing", () => {
    const length = helix.segments.length[0] ?? 0;
    // Whole spacings on the youngest 20 of 60 segments.
    expect(count).toBe(Math.floor((60 * length) / 0.1) - Math.floor((40 * length) / 0.1));
    expect(matrices.length).toBe(16 * count);
    for (const age of ages) {
      expect(age).toBeGreaterThanOrEqual(0);
      expect(age).toBeLessThan(1);
    }
    expect([...ages]).toEqual([...ages].sort((a, b) => b - a));
  });

  test("have matrices that only turn, scale and move", () => {
    for (let leaf = 0; leaf < count; leaf++) {
      const [x, y, z] = [column(matrices, leaf, 0), column(matrices, leaf, 1), column(matrices, leaf, 2)];
      const size = Math.hypot(...y);
      expect(size).toBeGreaterThan(0);
      expect(size).toBeLessThanOrEqual(0.2 + 1e-6);
      for (const axis of [x, z]) expect(Math.hypot(...axis)).toBeCloseTo(size, 6);
      for (const [a, b] of [
        [x, y],
        [y, z],
        [z, x],
      ] as const) {
        expect(dot(a, b)).toBeCloseTo(0, 6);
      }
      const [x0 = 0, x1 = 0, x2 = 0] = x;
      const [y0 = 0, y1 = 0, y2 = 0] = y;
      const cross = [x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0];
      expect(dot(cross, z)).toBeCloseTo(size ** 3, 6);
    }
  });

  test("are attached at the surface of the wood, at their angle to it", () => {
    for (let leaf = 0; leaf < count; leaf++) {
      const at = column(matrices, leaf, 3);
      const blade = column(matrices, leaf, 1);
      // The helix goes around by 0.1 and up by 0.05 a segment.
      const turn = (at[1] / 0.05) * 0.1;
      const fromAxis = Math.hypot(Math.hypot(at[0], at[2]) - 1, 0);
      expect(fromAxis).toBeLessThan(0.021);
      const tangent = [-Math.sin(turn) * 0.1, 0.05, Math.cos(turn) * 0.1];
      const cosine = dot(blade, tangent) / (Math.hypot(...blade) * Math.hypot(...tangent));
      // A leaf sits up to a radius aside, so the place on the helix is not exactly known.
      expect(cosine).toBeCloseTo(Math.cos((55 * Math.PI) / 180), 1);
    }
  });

  test("are as light to move as the wood that bears them", () => {
    expect([...sways]).toEqual([...sways].sort((a, b) => a - b));
    expect(Math.max(...sways)).toBeLessThanOrEqual(1);
    expect(Math.min(...sways)).toBeGreaterThan(0.5);
  });
});

test("leaves stay in their places while the wood goes on growing", () => {
  const older = { ...helix, report: { steps: 63 } };
  const before = foliageOf(helix, habit);
  const after = foliageOf(older, habit);
  const places = (foliage: typeof before) =>
    new Set(Array.from({ length: foliage.count }, (_, leaf) => column(foliage.matrices, leaf, 3).join()));
  expect(after.count).toBeGreaterThan(0);
  for (const place of places(after)) expect(places(before)).toContain(place);
});

test("leaves turn their faces up where they are asked to", () => {
  const lit = foliageOf(helix, { ...habit, light: 1 });
  for (let leaf = 0; leaf < lit.count; leaf++)
    expect(column(lit.matrices, leaf, 2)[1]).toBeGreaterThanOrEqual(0);
});

test("the habit follows the size of the plant, and wishes go before", () => {
  const own = habitFor(helix);
  expect(own.youth).toBe(18);
  expect(own.size).toBeGreaterThan(own.spacing);
  expect(habitFor(helix, { size: 0.5 })).toEqual({ ...own, size: 0.5 });
});

test("nothing has no leaves", () => {
  expect(foliageOf(handMade(), habitFor(handMade())).count).toBe(0);
  const point = handMade({
    points: [
      [0, 0, 0],
      [0, 0, 0],
    ],
    radii: [0.1, 0.1],
  });
  expect(foliageOf(point, habitFor(point)).count).toBe(0);
});
