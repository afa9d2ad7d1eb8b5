/** The mesh of every preset: closed, finite, in its box, and a valid GLB. */
import { validateBytes } from "gltf-validator";
import { GLTFExporter } from "three/addons/exporters/GLTFExporter.js";
import { beforeAll, describe, expect, test, vi } from "vitest";
import { boundsOf } from "../../web/src/geometry/bounds.ts";
import { history, init, type Plant, presets } from "../../web/src/package/node.ts";
import { type LimbGeometry, PlantGroup } from "../../web/src/three/index.ts";

beforeAll(() => init());

/** What the exporter reads its own blobs with; Node has none. */
class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((bytes) => {
      this.result = bytes;
      this.onloadend?.();
    });
  }
}
vi.stubGlobal("FileReader", BlobReader);

function grown({ params, step = Number.POSITIVE_INFINITY }: (typeof presets)[string]): Plant {
  const ages = history(params);
  const plant = ages.at(step);
  ages.dispose();
  return plant;
}

function numbers(geometry: LimbGeometry, name: string): Float32Array {
  return geometry.getAttribute(name).array as Float32Array;
}

/** For each vertex the first one in the very same place: the seam of the texture joins there. */
function welded(geometry: LimbGeometry): Uint32Array {
  const positions = numbers(geometry, "position");
  const first = new Map<string, number>();
  return Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => {
    const place = positions.subarray(3 * vertex, 3 * vertex + 3).join();
    const known = first.get(place);
    if (known === undefined) first.set(place, vertex);
    return known ?? vertex;
  });
}

/** Edges that are not passed once in each direction. */
function openEdges(index: ArrayLike<number>, vertices: number): number {
  const passes = new Map<number, number>();
  for (let i = 0; i < index.length; i += 3) {
    for (const k of [0, 1, 2]) {
      const [from, to] = [index[i + k] ?? 0, index[i + ((k + 1) % 3)] ?? 0];
      const edge = Math.min(from, to) * vertices + Math.max(from, to);
      passes.set(edge, (passes.get(edge) ?? 0) + (from < to ? 1 : -1));
    }
  }
  return [...passes.values()].filter((balance) => balance !== 0).length;
}

/**
 * The largest radius of an axis that begins where another ends. It begins about a radius inside its bearer, and if it points
 * back along it its first ring is the diagonal of that, and a tenth for the bend there, away from the point.
 */
function thickestAtEnds({ polylines: { points, radii, offsets } }: Plant): number {
  const place = (point: number) => points.subarray(3 * point, 3 * point + 3).join();
  const ends = new Set(Array.from(offsets.subarray(1), (next) => place(next - 1)));
  const starts = Array.from(offsets.subarray(0, -1)).filter((first) => ends.has(place(first)));
  return Math.max(0, ...starts.map((first) => radii[first] ?? 0));
}

describe.each(Object.entries(presets))("the mesh of %s", (_, preset) => {
  let plant: Plant;
  let group: PlantGroup;
  let geometry: LimbGeometry;
  beforeAll(() => {
    plant = grown(preset);
    group = new PlantGroup(plant);
    geometry = group.limbs.geometry;
  });

  test("is watertight", () => {
    const weld = welded(geometry);
    const index = Array.from(geometry.index?.array ?? [], (vertex) => weld[vertex] ?? 0);
    expect(index.length).toBeGreaterThan(0);
    expect(openEdges(index, weld.length)).toBe(0);
  });

  test("has normals of unit length and no NaN", () => {
    for (const name of Object.keys(geometry.attributes)) {
      expect(numbers(geometry, name).every(Number.isFinite), name).toBe(true);
    }
    const normals = numbers(geometry, "normal");
    let farthest = 0;
    for (let at = 0; at < normals.length; at += 3) {
      const [x = 0, y = 0, z = 0] = normals.subarray(at, at + 3);
      farthest = Math.max(farthest, Math.abs(Math.sqrt(x * x + y * y + z * z) - 1));
    }
    // Of numbers with 24 bits.
    expect(farthest).toBeLessThan(3e-7);
  });

  test("fills the box of its polylines and radii", () => {
    const { min, max } = boundsOf(plant.polylines);
    geometry.computeBoundingBox();
    const box = geometry.boundingBox ?? expect.fail("There is no box.");
    const thickest = Math.max(...plant.polylines.radii);
    // An arc over a segment bulges by an eighth of its turn times its length; the smooth centre line is near to an arc.
    const { length, curvature } = plant.segments;
    const arc = Math.max(
      ...length.map((own, segment) => (Math.abs(curvature[segment] ?? 0) * own * own) / 8),
    );
    const root = (Math.SQRT2 - 1) * thickestAtEnds(plant) * 1.1;
    for (const k of [0, 1, 2] as const) {
      const [low, high] = [box.min.getComponent(k), box.max.getComponent(k)];
      // Positions are numbers of 24 bits.
      const bulge = arc + root + 1e-6 * (max[k] - min[k]);
      expect(low).toBeGreaterThan(min[k] - bulge);
      expect(high).toBeLessThan(max[k] + bulge);
      // The box of the polylines has half a sphere at every end, the mesh ends in the last point: up to a radius less.
      expect(low).toBeLessThan(min[k] + 1.01 * thickest);
      expect(high).toBeGreaterThan(max[k] - 1.01 * thickest);
    }
  });

  test("is a valid GLB, leaves included", async () => {
    const warn = vi.spyOn(console, "warn");
    const glb = (await new GLTFExporter().parseAsync(group, { binary: true })) as ArrayBuffer;
    const { issues } = await validateBytes(new Uint8Array(glb));
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    expect(glb.byteLength).toBeGreaterThan(1000);
    expect(warn).not.toHaveBeenCalled();
  });
});
