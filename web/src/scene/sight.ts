/** From the world to the picture and back. */
import { Matrix4, type PerspectiveCamera, Vector3 } from "three";
import type { Vector } from "../geometry/bounds.ts";

/** Below this the eye looks almost along a plane, and places on it cannot be told apart. */
const grazing = 0.15;

/** From homogeneous coordinates in m to clip coordinates. */
export function toClip(eye: PerspectiveCamera, meters: Matrix4): Matrix4 {
  const matrix = new Matrix4().multiplyMatrices(eye.projectionMatrix, eye.matrixWorldInverse);
  return matrix.multiply(meters);
}

/** From homogeneous coordinates in m to px of a picture. */
export function toPicture(clip: Matrix4, width: number, height: number): Matrix4 {
  const [w, h] = [width / 2, height / 2];
  return new Matrix4().set(w, 0, 0, w, 0, -h, 0, h, 0, 0, 1, 0, 0, 0, 0, 1).multiply(clip);
}

/**
 * The point seen at a place of the picture (px), on the vertical plane through a point that contains the `heading`, a
 * horizontal direction; null is the plane that faces the eye. Where that plane is seen edge-on, the nearest point of it.
 */
export function unproject(
  picture: Matrix4,
  { x, y }: { x: number; y: number },
  through: Vector,
  heading: Vector | null,
): Vector {
  const back = picture.clone().invert();
  const near = new Vector3(x, y, -1).applyMatrix4(back);
  const ray = new Vector3(x, y, 1).applyMatrix4(back).sub(near).normalize();
  const facing = new Vector3(ray.x, 0, ray.z).normalize();
  const own = heading ? new Vector3(-heading[2], 0, heading[0]) : facing;
  const normal = Math.abs(own.dot(ray)) > grazing ? own : facing;
  const origin = new Vector3(...through);
  const point = near.addScaledVector(ray, origin.clone().sub(near).dot(normal) / ray.dot(normal));
  point.addScaledVector(own, -point.clone().sub(origin).dot(own));
  return [point.x, point.y, point.z];
}
