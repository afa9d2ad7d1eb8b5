/** How a plant gives way to wind: where, and how much more than elsewhere. */
import type { Axes } from "./tube.ts";

/**
 * How far each segment's end moves in an even wind from the side, relative to the one that moves farthest: 0 at the ground, 1
 * there. Beam theory of the first order: the drag of a segment goes with its length and thickness, its stiffness with the
 * fourth power of its radius. Shape n.
 */
export function swayOf({ segments }: Axes): Float64Array {
  const { parent, length, radius } = segments;
  const count = parent.length;
  /** On the end of each segment by all that is beyond it: force, and moment about the axis across the wind. */
  const force = new Float64Array(count);
  const moment = new Float64Array(count);
  /** Turn of each segment's base joint. */
  const turn = new Float64Array(count);
  for (let segment = count - 1; segment >= 0; segment--) {
    const own = length[segment] ?? 0;
    const thickness = radius[segment] ?? 0;
    const beyond = force[segment] ?? 0;
    const drag = thickness * own;
    const atBase = (moment[segment] ?? 0) + own * (beyond + 0.5 * drag);
    turn[segment] = (atBase * own) / thickness ** 4;
    const bearer = parent[segment] ?? -1;
    if (bearer < 0) continue;
    force[bearer] = (force[bearer] ?? 0) + beyond + drag;
    moment[bearer] = (moment[bearer] ?? 0) + atBase;
  }
  const move = new Float64Array(count);
  let most = 0;
  for (let segment = 0; segment < count; segment++) {
    const bearer = parent[segment] ?? -1;
    const lean = (turn[segment] ?? 0) + (turn[bearer] ?? 0);
    turn[segment] = lean;
    move[segment] = (move[bearer] ?? 0) + lean * (length[segment] ?? 0);
    most = Math.max(most, move[segment] ?? 0);
  }
  return move.map((far) => (most > 0 && Number.isFinite(most) ? far / most : 0));
}
