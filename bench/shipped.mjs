// The npm package as it is built, and the params of the bench's cases for it.

import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { packageFolder } from "../tools/paths.mjs";

/**
 * @typedef {object} Shape
 * @property {{ points: Float64Array, radii: Float64Array, offsets: Uint32Array }} polylines
 * @property {Record<string, ArrayLike<number>>} segments
 * @property {{ iterations: number, steps: number, steppingError: number | null }} report
 *
 * @typedef {object} Shipped
 * @property {() => Promise<void>} init
 * @property {(params: object) => Shape} grow
 * @property {{ properties: { solver: { properties: { stepping: { enum: string[] } } } } }} schema
 */

/** @returns {Promise<Shipped>} */
export async function loadPackage() {
  const entry = join(packageFolder, "src", "package", "node.js");
  /** @type {Shipped} */
  const shipped = await import(pathToFileURL(entry).href);
  await shipped.init();
  return shipped;
}

const density = 1000;
const gravity = 9.81;
const radius = 0.01;

/**
 * The rod of bench/native/src/case.rs with pipes: as stiff at every size, grown step by step.
 * @param {number} segments
 * @param {string} stepping
 * @param {number} tolerance
 */
export function grownRod(segments, stepping, tolerance = 1e-10) {
  return {
    axis: {
      segments,
      segmentLength: 1 / segments,
      radius: radius / Math.sqrt(segments),
      elevation: 50,
      taper: 1,
    },
    // q = 10 for a rod of half that radius.
    material: { density, youngsModulus: (4 * density * gravity) / (10 * (radius / 2) ** 2) },
    tropism: { strength: 0 },
    growth: { thickening: "pipes" },
    loads: { gravity },
    solver: { stepping, tolerance },
  };
}
