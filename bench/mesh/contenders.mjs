// @ts-nocheck: types need ez-tree, which only the bench installs.
// Mesh building by Bough and by ez-tree, bundled for the page of bench/rows/mesh.mjs. Each makes a mesh and says how many vertices it has.

import { Tree } from "@dgreenheck/ez-tree";
import { detailFor } from "../../web/src/geometry/detail.ts";
import { Tubes } from "../../web/src/geometry/tube.ts";

/** @typedef {import("../../web/src/geometry/tube.ts").Axes} Axes */
/** @typedef {{ polylines: Record<string, number[]>, segments: Record<string, number[]>, steps: number }} Lists */

/**
 * ez-tree's own default tree, branches only: no leaves, no textures. It has one function for it, which makes shape and mesh together.
 *
 * @returns {() => number}
 */
export function ezTree() {
  const tree = new Tree();
  tree.options.leaves.count = 0;
  tree.options.bark.textured = false;
  return () => {
    tree.generate();
    return tree.branchesMesh.geometry.getAttribute("position").count;
  };
}

/** ez-tree's default tree has 4 to 8 corners a ring, and a ring a section. */
const fewCorners = { rings: 1, sides: 8, leastSides: 4, cap: 2, stride: 1 };

/**
 * A tree at the scene's own detail, and at a detail like ez-tree's; an axis at the scene's own.
 * @param {Lists} tree
 * @param {Lists} axis
 * @returns {(() => number)[]}
 */
export function boughs(tree, axis) {
  return [bough(axesOf(tree)), bough(axesOf(tree), fewCorners), bough(axesOf(axis))];
}

/**
 * What the scene does when a parameter has changed: it chooses the detail, and writes the tubes over the last ones.
 * @param {Axes} axes
 * @param {import("../../web/src/geometry/detail.ts").Detail} [detail]
 */
function bough(axes, detail) {
  const tubes = new Tubes();
  return () => {
    tubes.update(axes, detail ?? detailFor(axes.polylines));
    return tubes.vertexCount;
  };
}

/** @param {Lists} lists @returns {Axes} */
function axesOf({ polylines, segments, steps }) {
  const numbers = (/** @type {number[] | undefined} */ list) => Float64Array.from(list ?? []);
  const counts = (/** @type {number[] | undefined} */ list) => Uint32Array.from(list ?? []);
  const lists = Object.entries(segments).map(([name, list]) => [name, numbers(list)]);
  return {
    polylines: {
      points: numbers(polylines.points),
      radii: numbers(polylines.radii),
      offsets: counts(polylines.offsets),
    },
    segments: {
      ...Object.fromEntries(lists),
      parent: Int32Array.from(segments.parent ?? []),
      point: counts(segments.point),
      axis: counts(segments.axis),
      order: counts(segments.order),
      birth: counts(segments.birth),
    },
    report: { steps },
  };
}
