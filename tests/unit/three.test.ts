/** What `bough/three` makes of a plant, as far as it can be told without a graphics card. */
import { type BufferAttribute, type InstancedMesh, Mesh, Vector3 } from "three";
import { describe, expect, test } from "vitest";
import {
  LimbGeometry,
  moment,
  order,
  PlantGroup,
  PlantLod,
  sway,
  uv,
  Wind,
} from "../../web/src/three/index.ts";
import { handMade } from "./plants.ts";

/** A limb that forks, with all that attributes need. */
function fork() {
  const axes = handMade(
    {
      points: [
        [0, 0, 0],
        [0, 0.5, 0],
        [0, 1, 0],
      ],
      radii: [0.1, 0.1, 0.1],
    },
    {
      points: [
        [0, 1, 0],
        [0.5, 1.5, 0.2],
      ],
      radii: [0.08, 0.08],
      on: 1,
    },
    {
      points: [
        [0, 1, 0],
        [-0.5, 1.5, -0.2],
      ],
      radii: [0.05, 0.05],
      on: 1,
    },
  );
  axes.segments.length.set([0.5, 0.5, 0.7, 0.7]);
  axes.segments.radius.set([0.1, 0.1, 0.08, 0.05]);
  axes.segments.order.set([0, 0, 1, 1]);
  axes.segments.moment.set([4, 3, 2, -1]);
  return axes;
}

const extras = [uv, order, moment, sway];
const values = (geometry: LimbGeometry, name: string) => [...geometry.getAttribute(name).array];

describe("the geometry of limbs", () => {
  const geometry = new LimbGeometry(extras).update(fork());

  test("has arrays that are just long enough", () => {
    const { count } = geometry.getAttribute("position");
    for (const attribute of Object.values(geometry.attributes)) expect(attribute.count).toBe(count);
    expect(geometry.drawRange.count).toBe(geometry.index?.count);
    expect(Math.max(...(geometry.index?.array ?? []))).toBe(count - 1);
  });

  test("knows order, moment and sway of the wood at every vertex", () => {
    const heights = values(geometry, "position").filter((_, i) => i % 3 === 1);
    const orders = values(geometry, "order");
    const moments = values(geometry, "moment");
    const sways = values(geometry, "sway");
    expect(new Set(orders)).toEqual(new Set([0, 1]));
    for (const [vertex, height] of heights.entries()) {
      if (height > 1.1) expect(orders[vertex]).toBe(1);
      if (height < 0.9) expect(orders[vertex]).toBe(0);
    }
    expect(moments[0]).toBe(4);
    // Free tips are not bent, the forked end is as its last segment.
    expect(moments.at(-1)).toBeCloseTo(0, 12);
    expect(Math.min(...moments)).toBe(-1);
    expect(moments.filter((_, vertex) => orders[vertex] === 0).every((value) => value >= 3)).toBe(true);
    expect(sways[0]).toBe(0);
    expect(Math.max(...sways)).toBe(1);
    expect(Math.min(...sways)).toBe(0);
  });

  test("has a texture that runs once around and along the limb, without a gap", () => {
    const places = values(geometry, "uv");
    const [us, vs] = [0, 1].map((k) => places.filter((_, i) => i % 2 === k)) as [number[], number[]];
    expect(Math.min(...us)).toBe(0);
    expect(Math.max(...us)).toBe(1);
    expect(us.filter((u) => u === 0).length).toBe(us.filter((u) => u === 1).length);
    for (const [i, vertex] of (geometry.index?.array ?? []).entries()) {
      if (i % 3 !== 0) continue;
      const turns = [0, 1, 2].map((k) => us[geometry.index?.array[i + k] ?? 0] ?? 0);
      expect(Math.max(...turns) - Math.min(...turns), String(vertex)).toBeLessThanOrEqual(0.5);
    }
    const heights = values(geometry, "position").filter((_, i) => i % 3 === 1);
    // Along the straight trunk the arc length is the height.
    for (const [vertex, height] of heights.entries()) {
      if (height > 0.2 && height < 0.8) expect(vs[vertex]).toBeCloseTo(height, 5);
    }
  });

  test("of the page has no more than its bark needs", () => {
    expect(Object.keys(new LimbGeometry().update(fork()).attributes).sort()).toEqual(
      ["age", "grain", "normal", "position", "shade"].sort(),
    );
  });

  test("is written over by a plant that is no larger, and grows for a larger one", () => {
    const small = handMade({
      points: [
        [0, 0, 0],
        [0, 1, 0],
      ],
      radii: [0.1, 0.05],
    });
    const written = new LimbGeometry(extras).update(fork());
    const position = written.getAttribute("position") as BufferAttribute;
    written.update(small);
    expect(written.getAttribute("position")).toBe(position);
    expect(written.drawRange.count).toBeLessThan(written.index?.count ?? 0);
    let freed = 0;
    const grown = new LimbGeometry(extras).update(small);
    grown.addEventListener("dispose", () => freed++);
    grown.update(fork());
    expect(freed).toBe(1);
    expect(grown.getAttribute("sway").count).toBe(grown.getAttribute("position").count);
  });
});

describe("a plant group", () => {
  test("has limbs and leaves, and can be without leaves", () => {
    const group = new PlantGroup(fork());
    expect(group.children).toEqual([group.limbs, group.leaves]);
    expect(group.leaves.count).toBeGreaterThan(0);
    group.update(fork(), { leaves: false });
    expect(group.leaves.visible).toBe(false);
    group.update(fork(), { leaves: { spacing: 0.01 } });
    expect(group.leaves.visible).toBe(true);
    expect(group.leaves.count).toBeGreaterThan(20);
    expect(group.leaves.instanceMatrix.count).toBeGreaterThanOrEqual(group.leaves.count);
  });

  test("disposes of its own materials, not of those it was given", () => {
    const own = new PlantGroup(fork());
    const guest = new PlantGroup(fork(), {}, { bark: own.limbs.material, leaf: own.leaves.material });
    const freed: string[] = [];
    own.limbs.material.addEventListener("dispose", () => freed.push("bark"));
    own.leaves.material.addEventListener("dispose", () => freed.push("leaf"));
    guest.dispose();
    expect(freed).toEqual([]);
    own.dispose();
    expect(freed).toEqual(["bark", "leaf"]);
  });
});

test("a plant with levels of detail is coarser farther away, and its levels share their materials", () => {
  const lod = new PlantLod(fork());
  const groups = lod.levels.map(({ object }) => object as PlantGroup);
  const vertices = groups.map(({ limbs }) => limbs.geometry.getAttribute("position").count);
  const leaves = groups.map((group) => group.leaves.count);
  expect(vertices).toEqual([...vertices].sort((a, b) => b - a));
  expect(new Set(vertices).size).toBe(3);
  expect(leaves[0]).toBeGreaterThan(leaves[2] ?? 0);
  expect(new Set(groups.map(({ limbs }) => limbs.material)).size).toBe(1);
  expect(lod.levels.map(({ distance }) => distance)).toEqual(
    [...lod.levels.map(({ distance }) => distance)].sort((a, b) => a - b),
  );
});

test("clones share geometries and materials, leaves and levels included", () => {
  const lod = new PlantLod(fork());
  const wind = new Wind();
  wind.blow(lod);
  const clone = lod.clone();
  wind.blow(clone);
  expect(clone.levels.map(({ distance }) => distance)).toEqual(lod.levels.map(({ distance }) => distance));
  for (const [level, { object }] of clone.levels.entries()) {
    const original = lod.levels[level]?.object as PlantGroup;
    const [limbs, leaves] = object.children as [Mesh, InstancedMesh];
    expect(limbs.geometry).toBe(original.limbs.geometry);
    expect(limbs.material).toBe(original.limbs.material);
    expect(limbs.customDepthMaterial).toBe(original.limbs.customDepthMaterial);
    expect(leaves.geometry).toBe(original.leaves.geometry);
    expect(leaves.count).toBe(original.leaves.count);
    expect(leaves.geometry.getAttribute("sway").count).toBeGreaterThanOrEqual(leaves.count);
  }
});

test("wind moves limbs and leaves by their weights, shadows too, and tells their programs apart", () => {
  const group = new PlantGroup(fork());
  const wind = new Wind(new Vector3(0.2, 0, 0));
  const bare = new Mesh();
  group.add(bare);
  wind.blow(group);
  wind.blow(group);
  const shader = () => ({
    uniforms: {},
    vertexShader:
      "void main() {\n#include <begin_vertex>\n#include <project_vertex>\n#include <worldpos_vertex>\n}",
    fragmentShader: "#include <color_fragment>\n#include <opaque_fragment>",
  });
  for (const mesh of [group.limbs, group.leaves as InstancedMesh]) {
    expect(mesh.geometry.hasAttribute("sway")).toBe(true);
    for (const material of [mesh.material, mesh.customDepthMaterial].flat()) {
      const compiled = shader();
      material?.onBeforeCompile(compiled as never, undefined as never);
      expect(compiled.vertexShader.match(/attribute float sway/g)).toHaveLength(1);
      expect(Object.keys(compiled.uniforms)).toEqual(expect.arrayContaining(["windLean", "windTime"]));
    }
  }
  expect(group.limbs.material.customProgramCacheKey()).not.toBe(
    group.leaves.material.customProgramCacheKey(),
  );
  expect(bare.customDepthMaterial).toBeUndefined();
});
