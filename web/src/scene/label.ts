/** Where a label has room on the picture. Arrays to arrays: no DOM. */
import type { Place } from "./annotation.ts";

/** Something that a label must not touch: a line on the picture, reaching `thickness` to both sides, px. */
export interface Obstacle {
  readonly places: readonly Place[];
  readonly thickness: number;
}

/** A width and a height, px. */
export interface Extent {
  readonly width: number;
  readonly height: number;
}

/** A label keeps so far away from lines. px */
const gap = 5;

/** The first place at which a label touches nothing and is all in the picture, else the one with the most air around it. */
export function freest(
  candidates: readonly Place[],
  label: Extent,
  obstacles: readonly Obstacle[],
  picture: Extent,
): Place {
  // In a plane that is compressed across, a label twice as wide as high is a circle.
  const slim = Math.max(1, label.width / label.height);
  let best: Place = { x: 0, y: 0 };
  let most = Number.NEGATIVE_INFINITY;
  for (const place of candidates) {
    const air = airAround(place, slim, obstacles, picture, most);
    if (air > most) [best, most] = [place, air];
    if (air >= label.height / 2 + gap) break;
  }
  return best;
}

/** How far a place is from everything, up and down; it is not worked out to the end where that is less than `least`. */
function airAround(
  { x, y }: Place,
  slim: number,
  obstacles: readonly Obstacle[],
  picture: Extent,
  least: number,
): number {
  let air = Math.min(x / slim, (picture.width - x) / slim, y, picture.height - y);
  for (const { places, thickness } of obstacles) {
    if (air <= least) break;
    air = Math.min(air, distanceTo(places, x, y, slim) - thickness);
  }
  return air;
}

/** How far a place is from a line, where what is across counts only `1 / slim`. */
function distanceTo(places: readonly Place[], x: number, y: number, slim: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 1; i < places.length; i++) {
    const [a, b] = [places[i - 1], places[i]];
    if (!a || !b) continue;
    const [dx, dy] = [(b.x - a.x) / slim, b.y - a.y];
    const [px, py] = [(x - a.x) / slim, y - a.y];
    const share = Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy || 1)));
    least = Math.min(least, (px - share * dx) ** 2 + (py - share * dy) ** 2);
  }
  return Math.sqrt(least);
}
