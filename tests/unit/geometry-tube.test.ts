import { describe, expect, it } from "vitest";
import { type Axes, Tubes } from "../../web/src/geometry/tube.ts";
import { handMade } from "./plants.ts";

const detail = { rings: 4, sides: 12, leastSides: 4, cap: 5, stride: 1 };

/** A quarter of a circle of radius 1 m, with a taper. */
const arc = handMade({
  points: Array.from({ length: 11 }, (_, k) => [Math.sin(0.15 * k), 1 - Math.cos(0.15 * k), 0]),
  radii: Array.from({ length: 11 }, (_, k) => 0.05 - 0.003 * k),
});

const helix = handMade({
  points: Array.from({ length: 60 }, (_, k) => [Math.cos(0.3 * k), 0.1 * k, Math.sin(0.3 * k)]),
  radii: Array.from({ length: 60 }, () => 0.02),
});

const fork = handMade(
  {
    points: [
      [0, 0, 0],
      [0, 1, 0],
    ],
    radii: [0.1, 0.1],
  },
  {
    points: [
      [0, 1, 0],
      [0.5, 1.5, 0.2],
    ],
    radii: [0.08, 0.08],
    on: 0,
  },
  {
    points: [
      [0, 1, 0],
      [-0.5, 1.5, -0.2],
      [-0.6, 2, -0.2],
    ],
    radii: [0.05, 0.05, 0.04],
    on: 0,
  },
);

const degenerate: Record<string, Axes> = {
  "one segment": handMade({
    points: [
      [0, 0, 0],
      [0.3, 0.4, 0],
    ],
    radii: [0.1, 0.1],
  }),
  "no length": handMade({
    points: [
      [0, 0, 0],
      [0, 0, 0],
      [0, 0, 0],
    ],
    radii: [0.1, 0.1, 0.1],
  }),
  "duplicate points": handMade({
    points: [
      [0, 0, 0],
      [0, 0, 0],
      [1, 0, 0],
      [1, 0, 0],
      [2, 1, 0],
    ],
    radii: [0.1, 0.1, 0.1, 0.1, 0.1],
  }),
  "folded back": handMade({
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 0, 0],
      [1, 0, 0],
    ],
    radii: [0.1, 0.1, 0.1, 0.1],
  }),
  "turned by a right angle in every joint": handMade({
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [1, 1, 1],
      [0, 1, 1],
    ],
    radii: [0.1, 0.1, 0.1, 0.1, 0.1],
  }),
  "towards the viewer": handMade({
    points: [
      [0, 0, 0],
      [0, 0, 1],
    ],
    radii: [0.1, 0.1],
  }),
  "a cone": handMade({
    points: [
      [0, 0, 0],
      [0, 1, 0],
    ],
    radii: [0.1, 0],
  }),
  "without radius": handMade({
    points: [
      [0, 0, 0],
      [0, 1, 0],
    ],
    radii: [0, 0],
  }),
  "tiny and huge segments": handMade({
    points: [
      [0, 0, 0],
      [1e-30, 0, 0],
      [1e6, 1e6, 0],
    ],
    radii: [1e-7, 1e-7, 1e-7],
  }),
};

const all: Record<string, Axes> = { arc, helix, fork, ...degenerate };

function tubesOf(axes: Axes): Tubes {
  const tubes = new Tubes();
  tubes.update(axes, detail);
  return tubes;
}

function vectors(array: Float32Array, count: number): [number, number, number][] {
  return Array.from({ length: count }, (_, i) => [
    array[3 * i] ?? 0,
    array[3 * i + 1] ?? 0,
    array[3 * i + 2] ?? 0,
  ]);
}

describe.each(Object.entries(all))("the tubes of %s", (_, axes) => {
  const tubes = tubesOf(axes);
  const { vertexCount, indexCount } = tubes;

  it("have finite positions and unit normals", () => {
    expect(vertexCount).toBeGreaterThan(0);
    for (const array of [tubes.positions, tubes.grain]) {
      expect(array.subarray(0, 3 * vertexCount).every(Number.isFinite)).toBe(true);
    }
    for (const normal of vectors(tubes.normals, vertexCount)) expect(Math.hypot(...normal)).toBeCloseTo(1, 5);
  });

  it("are closed: every edge is passed once in each direction", () => {
    const edges = new Set<string>();
    for (let i = 0; i < indexCount; i += 3) {
      const corners = [0, 1, 2].map((k) => tubes.index[i + k] ?? -1);
      for (const k of [0, 1, 2]) {
        const edge = `${corners[k]} ${corners[(k + 1) % 3]}`;
        expect(edges.has(edge)).toBe(false);
        edges.add(edge);
      }
    }
    for (const edge of edges) expect(edges.has(edge.split(" ").reverse().join(" "))).toBe(true);
    expect(edges.size).toBe(indexCount);
  });

  it("use every vertex", () => {
    expect(new Set(tubes.index.subarray(0, indexCount)).size).toBe(vertexCount);
  });
});

describe("a tube", () => {
  it("has its normals outwards and its triangles counter-clockwise", () => {
    const tubes = tubesOf(arc);
    const positions = vectors(tubes.positions, tubes.vertexCount);
    const normals = vectors(tubes.normals, tubes.vertexCount);
    let volume = 0;
    for (let i = 0; i < tubes.indexCount; i += 3) {
      const [a = 0, b = 0, c = 0] = tubes.index.subarray(i, i + 3);
      const p = positions[a] ?? [0, 0, 0];
      const u = minus(positions[b] ?? p, p);
      const v = minus(positions[c] ?? p, p);
      const face = cross(u, v);
      volume += dot(p, face) / 6;
      if (Math.hypot(...face) > 1e-7) expect(dot(face, normals[a] ?? p)).toBeGreaterThan(0);
    }
    // A bent cone frustum of 1.5 m with radii from 50 to 20 mm, rounded at its start and end.
    const frustum = (Math.PI * 1.5 * (0.05 ** 2 + 0.05 * 0.02 + 0.02 ** 2)) / 3;
    expect(volume / frustum).toBeGreaterThan(0.93);
    expect(volume / frustum).toBeLessThan(1.03);
  });

  it("follows its centre line at the distance of its radius", () => {
    const tubes = tubesOf(arc);
    const shoulder = 1.5 - 1.5 * 0.02;
    for (const [x, y, z] of vectors(tubes.positions, tubes.vertexCount)) {
      const around = Math.atan2(x, 1 - y);
      if (around < 0 || around > shoulder) continue;
      const distance = Math.hypot(Math.hypot(x, 1 - y) - 1, z);
      expect(distance).toBeCloseTo(0.05 - 0.02 * around, 3);
    }
  });

  it("ends exactly in its last point", () => {
    const tubes = tubesOf(arc);
    const tip = vectors(tubes.positions, tubes.vertexCount).at(-1) ?? [0, 0, 0];
    expect(tip[0]).toBeCloseTo(Math.sin(1.5), 6);
    expect(tip[1]).toBeCloseTo(1 - Math.cos(1.5), 6);
    const reach = Math.max(
      ...vectors(tubes.positions, tubes.vertexCount).map(([x, y]) => Math.atan2(x, 1 - y)),
    );
    expect(reach).toBeLessThan(1.5 + 1e-6);
  });

  it("stays in the box of its centre line, thickened by its radius", () => {
    const { positions, vertexCount } = tubesOf(degenerate["one segment"] as Axes);
    const xs = vectors(positions, vertexCount).map(([x]) => x);
    const zs = vectors(positions, vertexCount).map(([, , z]) => z);
    expect(Math.min(...xs)).toBeGreaterThanOrEqual(-0.1 - 1e-6);
    expect(Math.max(...xs)).toBeLessThanOrEqual(0.4 + 1e-6);
    expect(Math.max(...zs)).toBeCloseTo(0.1, 3);
  });

  it("does not twist in the plane, whatever way it bends", () => {
    const { positions, grain, vertexCount } = tubesOf(arc);
    for (let vertex = 0; vertex < vertexCount; vertex++) {
      const cosine = grain[3 * vertex] ?? 0;
      if (cosine === 1) expect(Math.abs(positions[3 * vertex + 1] ?? 9)).toBeLessThan(2);
      if (cosine === 1) expect(positions[3 * vertex + 2] ?? -1).toBeGreaterThan(0);
    }
  });

  it("knows the age of its wood", () => {
    const { ages, segments, vertexCount } = tubesOf(arc);
    expect(ages[0]).toBe(9);
    expect(ages[vertexCount - 1]).toBe(0);
    expect(segments[0]).toBe(0);
    expect(segments[vertexCount - 1]).toBe(9);
  });

  it("is thicker by the girth factor, and no longer", () => {
    const tubes = new Tubes();
    tubes.update(degenerate["one segment"] as Axes, detail, 2);
    const zs = vectors(tubes.positions, tubes.vertexCount).map(([, , z]) => z);
    expect(Math.max(...zs)).toBeCloseTo(0.2, 3);
    expect(vectors(tubes.positions, tubes.vertexCount).at(-1)?.[0]).toBeCloseTo(0.3, 6);
  });
});

describe("a fork", () => {
  const tubes = tubesOf(fork);
  const points = vectors(tubes.positions, tubes.vertexCount);
  const normals = vectors(tubes.normals, tubes.vertexCount);
  /** Vertices in the plane where the limb ends, as far from its axis as its surface is. */
  const meeting = points.flatMap(([x, y, z], vertex) =>
    Math.abs(y - 1) < 1e-6 && Math.abs(Math.hypot(x, z) - 0.1) < 1e-4 ? [vertex] : [],
  );

  it("has one girth and one direction where its three limbs meet", () => {
    const radii = meeting.map((vertex) => Math.hypot(points[vertex]?.[0] ?? 0, points[vertex]?.[2] ?? 0));
    // The corners of three rings.
    expect(radii.length).toBeGreaterThanOrEqual(3 * Math.ceil(detail.sides * Math.sqrt(0.5)) - 3);
    for (const vertex of meeting) expect(Math.abs(normals[vertex]?.[1] ?? 1)).toBeLessThan(0.05);
  });

  it("hides the ends of its limbs inside: nothing bulges beyond where they meet", () => {
    const beyond = points.filter(([x, y, z]) => Math.hypot(x, z) < 0.02 && y > 1.03 && y < 1.2);
    const before = points.filter(([x, y, z]) => Math.hypot(x, z) > 0.104 && y > 0 && y < 0.999);
    expect(beyond).toEqual([]);
    expect(before).toEqual([]);
  });

  it("leaves each limb its own girth and place farther on", () => {
    const [x, y, z] = [0.6, 2, 0.2];
    expect(points.some((at) => Math.hypot(at[0] + x, at[1] - y, at[2] + z) < 1e-6)).toBe(true);
  });
});

describe("what leaves a stem from its side", () => {
  const stem = handMade(
    {
      points: [
        [0, 0, 0],
        [0, 1, 0],
        [0, 2, 0],
      ],
      radii: [0.1, 0.1, 0.1],
    },
    {
      points: [
        [0, 1, 0],
        [1, 1, 0],
      ],
      radii: [0.02, 0.02],
      on: 0,
    },
  );
  const tubes = tubesOf(stem);
  const limb = vectors(tubes.positions, tubes.vertexCount).filter(
    (_, vertex) => tubes.segments[vertex] === 2,
  );
  const girthAt = (from: number, to: number) =>
    Math.max(...limb.filter(([x]) => x >= from && x < to).map(([, y, z]) => Math.hypot(y - 1, z)));

  it("has a collar, which stays inside the stem at its start, and is gone soon after", () => {
    expect(girthAt(0, 0.01)).toBeCloseTo(0.038, 4);
    expect(girthAt(0.1, 0.2)).toBeGreaterThan(0.022);
    expect(girthAt(0.4, 0.9)).toBeCloseTo(0.02, 4);
    expect(Math.min(...limb.map(([x]) => x))).toBeGreaterThan(-0.1);
  });
});

describe("shades", () => {
  const values = Float64Array.from({ length: 10 }, (_, segment) => 1 - segment / 10);

  it("run smoothly along the limb, from each base joint to the next, and to that of the free tip", () => {
    const tubes = new Tubes();
    tubes.update(arc, detail, 1, { values, free: 0 });
    const shades = [...tubes.shades.subarray(0, tubes.vertexCount)];
    expect(shades[0]).toBeCloseTo(1, 6);
    expect(shades.at(-1)).toBeCloseTo(0, 6);
    for (let i = 1; i < shades.length; i++) {
      const fall = (shades[i - 1] ?? 0) - (shades[i] ?? 0);
      expect(fall).toBeGreaterThan(-1e-6);
      expect(fall).toBeLessThan(0.06);
    }
  });

  it("stay as they are at the tip if that has no value of its own", () => {
    const tubes = new Tubes();
    tubes.update(arc, detail, 1, { values, free: null });
    expect(tubes.shades[tubes.vertexCount - 1]).toBeCloseTo(0.1, 6);
  });
});

describe("coarse detail", () => {
  it.each([2, 3, 5, 100])("of every %ith point still ends in the last one, and is closed", (stride) => {
    const tubes = new Tubes();
    tubes.update(helix, { rings: 1, sides: 3, leastSides: 3, cap: 1, stride });
    const tip = vectors(tubes.positions, tubes.vertexCount).at(-1) ?? [0, 0, 0];
    expect(tip[0]).toBeCloseTo(Math.cos(0.3 * 59), 5);
    expect(tip[1]).toBeCloseTo(5.9, 5);
    expect(tubes.vertexCount).toBe(3 * (Math.ceil(59 / stride) + 1) + 2);
    expect(tubes.indexCount / 3).toBe(2 * (tubes.vertexCount - 2));
    expect(new Set(tubes.index.subarray(0, tubes.indexCount)).size).toBe(tubes.vertexCount);
  });
});

describe("an update", () => {
  it("reuses the arrays while they are long enough", () => {
    const tubes = new Tubes();
    expect(tubes.update(helix, detail)).toBe(true);
    const { positions } = tubes;
    expect(tubes.update(arc, detail)).toBe(false);
    expect(tubes.positions).toBe(positions);
    expect(tubes.vertexCount).toBe(tubesOf(arc).vertexCount);
    expect(tubes.positions.subarray(0, 3 * tubes.vertexCount)).toEqual(
      tubesOf(arc).positions.subarray(0, 3 * tubes.vertexCount),
    );
  });

  it("leaves the triangles alone while the limbs are cut alike, and says so", () => {
    const tubes = new Tubes();
    tubes.update(arc, detail);
    expect(tubes.recut).toBe(true);
    tubes.update(arc, detail, 2);
    expect(tubes.recut).toBe(false);
    tubes.update(arc, { ...detail, sides: 8 });
    expect(tubes.recut).toBe(true);
    tubes.update(fork, detail);
    expect(tubes.recut).toBe(true);
    const { index, indexCount } = tubesOf(fork);
    expect(tubes.index.subarray(0, tubes.indexCount)).toEqual(index.subarray(0, indexCount));
  });
});

type Triple = [number, number, number];
function minus(a: Triple, b: Triple): Triple {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}
function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
