/** What of a broken line lies on the picture, and a little beyond its edges. */

interface Place {
  readonly x: number;
  readonly y: number;
}

/** So far beyond the edges ends and joins of strokes are out of sight. px */
const margin = 50;

/**
 * The parts of a line that are seen. Lines that are drawn dashed need it: browsers make every dash, also where nobody sees
 * it, and a large plant near the eye is a million px long.
 */
export function clip(line: readonly Place[], width: number, height: number): Place[][] {
  const parts: Place[][] = [];
  let part: Place[] | null = null;
  for (let end = 1; end < line.length; end++) {
    const [from, to] = [line[end - 1] as Place, line[end] as Place];
    const seen = stretch(from, to, width, height);
    if (!seen) {
      part = null;
      continue;
    }
    const [first, last] = seen.map((share) => ({
      x: from.x + share * (to.x - from.x),
      y: from.y + share * (to.y - from.y),
    })) as [Place, Place];
    if (!part || seen[0] > 0) {
      part = [first];
      parts.push(part);
    }
    part.push(last);
    if (seen[1] < 1) part = null;
  }
  return parts;
}

/** Between which shares of the way from one place to another it is on the picture (Liang and Barsky, 1984); null if nowhere. */
function stretch(from: Place, to: Place, width: number, height: number): [number, number] | null {
  let [first, last] = [0, 1];
  for (const [start, way, room] of [
    [from.x, to.x - from.x, width],
    [from.y, to.y - from.y, height],
  ] as const) {
    const [enter, leave] = [(-margin - start) / way, (room + margin - start) / way];
    if (way === 0) {
      if (start < -margin || start > room + margin) return null;
      continue;
    }
    first = Math.max(first, Math.min(enter, leave));
    last = Math.min(last, Math.max(enter, leave));
  }
  // Written so that what is not finite is nowhere.
  return first < last ? [first, last] : null;
}
