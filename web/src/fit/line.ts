/** How far traced points are from the centre line of an axis, and how that changes with parameters. */

/** A traced point, m, in the plane of the axis. */
export interface Traced {
  readonly x: number;
  readonly y: number;
}

/** A centre line and its derivatives. */
export interface Line {
  /** x, y, z of its points, m. */
  readonly points: Float64Array;
  /** For each parameter the derivative of every one of these numbers. */
  readonly slopes: readonly Float64Array[];
}

/** Residuals, m, and for each the derivative by every parameter. */
export interface Residuals {
  readonly values: readonly number[];
  readonly rows: readonly (readonly number[])[];
}

/**
 * The distance of each traced point from the nearest place of the line, signed by the side it lies on. That the nearest place
 * wanders with the parameters changes the distance only to second order, so its derivative is that of the place. If the last
 * point is the tip, both its coordinates count: it says how long the axis is.
 */
export function residualsOf(line: Line, traced: readonly Traced[], lastIsTip: boolean): Residuals {
  const values: number[] = [];
  const rows: number[][] = [];
  const last = line.points.length / 3 - 1;
  traced.forEach((point, index) => {
    if (lastIsTip && index === traced.length - 1) {
      const tip = placeOf(line.points, last - 1, 1);
      for (const along of ["x", "y"] as const) {
        values.push(point[along] - tip[along]);
        rows.push(line.slopes.map((slope) => -placeOf(slope, last - 1, 1)[along]));
      }
      return;
    }
    const { segment, share, normal } = nearest(line.points, point);
    const place = placeOf(line.points, segment, share);
    values.push((point.x - place.x) * normal.x + (point.y - place.y) * normal.y);
    rows.push(
      line.slopes.map((slope) => {
        const moved = placeOf(slope, segment, share);
        return -(moved.x * normal.x + moved.y * normal.y);
      }),
    );
  });
  return { values, rows };
}

/** The place at a share of a segment; of a slope, how it moves. */
function placeOf(numbers: Float64Array, segment: number, share: number): Traced {
  const at = 3 * segment;
  const mix = (k: number) => (1 - share) * (numbers[at + k] ?? 0) + share * (numbers[at + 3 + k] ?? 0);
  return { x: mix(0), y: mix(1) };
}

/** The nearest place of the line, and the direction from there to the point, turned to the line's left. */
function nearest(points: Float64Array, { x, y }: Traced): { segment: number; share: number; normal: Traced } {
  let best = { segment: 0, share: 0, squared: Number.POSITIVE_INFINITY };
  for (let segment = 0; 3 * segment + 5 < points.length; segment++) {
    const from = placeOf(points, segment, 0);
    const to = placeOf(points, segment, 1);
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const along = ((x - from.x) * dx + (y - from.y) * dy) / (dx * dx + dy * dy || 1);
    const share = Math.min(1, Math.max(0, along));
    const squared = (from.x + share * dx - x) ** 2 + (from.y + share * dy - y) ** 2;
    if (squared < best.squared) best = { segment, share, squared };
  }
  const { segment, share } = best;
  const [from, to] = [placeOf(points, segment, 0), placeOf(points, segment, 1)];
  const size = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const left = { x: -(to.y - from.y) / size, y: (to.x - from.x) / size };
  // Beside a corner, or beyond an end, the way to the point is not at right angles to the segment.
  const place = placeOf(points, segment, share);
  const away = Math.sqrt(best.squared);
  if (away < 1e-12 * size) return { segment, share, normal: left };
  const side = (x - place.x) * left.x + (y - place.y) * left.y < 0 ? -1 : 1;
  return { segment, share, normal: { x: (side * (x - place.x)) / away, y: (side * (y - place.y)) / away } };
}
