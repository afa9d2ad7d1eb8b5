/** One leaf: its blade and its material. */
import { BufferAttribute, BufferGeometry, DoubleSide, MeshStandardMaterial } from "three";

/** Rows of the blade from base to tip; each has both edges and the midrib. */
const rows = 7;
/** Half the width of the blade at its widest, and of the stalk and the very tip, for a length of 1. */
const breadth = 0.24;
const stalk = 0.012;

/** A blade with its base in the origin and its tip at y = 1, folded a little along the midrib and bent back at the tip. */
export function bladeGeometry(): BufferGeometry {
  const positions: number[] = [];
  const uvs: number[] = [];
  for (let row = 0; row < rows; row++) {
    const y = row / (rows - 1);
    // Widest below the middle; a point at the tip.
    const half = Math.max(stalk, breadth * Math.abs(Math.sin(Math.PI * y ** 0.75)) ** 0.8);
    for (const side of [-1, 0, 1]) {
      positions.push(side * half, y, 0.45 * half * Math.abs(side) - 0.14 * y * y);
      uvs.push(0.5 + 0.5 * side, y);
    }
  }
  const index: number[] = [];
  for (let row = 0; row + 1 < rows; row++) {
    for (const column of [0, 1]) {
      const near = 3 * row + column;
      index.push(near, near + 1, near + 3, near + 1, near + 4, near + 3);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute("uv", new BufferAttribute(Float32Array.from(uvs), 2));
  geometry.setIndex(index);
  geometry.computeVertexNormals();
  return geometry;
}

/** The material of leaves: seen from both sides. */
export function leafMaterial(): MeshStandardMaterial {
  return new MeshStandardMaterial({ color: "#6f9a45", roughness: 0.62, metalness: 0, side: DoubleSide });
}
