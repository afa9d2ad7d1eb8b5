/** The core's fingerprint of a plant (`Plant::fingerprint` in rust-core/bough/src/plant/result.rs), in any JavaScript. */
import type { Plant } from "../web/src/plant/plant.ts";

/** FNV-1a, 64 bits, of every array to the last bit, in the core's order; 16 hexadecimal digits. */
export function fingerprint({ polylines, segments }: Plant): string {
  const { parent, point, axis, order, birth } = segments;
  const { length, radius, mass, rotation, moment, twistMoment, curvature, restCurvature, stress } = segments;
  const reals = [polylines.points, polylines.radii, length, radius, mass, rotation, moment];
  const moreReals = [twistMoment, curvature, restCurvature, stress];
  const counts = [polylines.offsets, point, axis, order, birth];
  // Two halves of 32 bits: a BigInt would be a hundred times slower.
  let high = 0xcbf29ce4;
  let low = 0x84222325;
  for (const array of [...reals, ...moreReals, ...counts, parent]) {
    for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength)) {
      low = (low ^ byte) >>> 0;
      // Times the prime 2^40 + 435.
      const product = low * 435;
      high = (Math.imul(high, 435) + Math.floor(product / 2 ** 32) + (low << 8)) >>> 0;
      low = product >>> 0;
    }
  }
  return high.toString(16).padStart(8, "0") + low.toString(16).padStart(8, "0");
}
