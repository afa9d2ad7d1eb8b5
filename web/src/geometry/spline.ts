/** The smooth centre line of one axis: a cubic Hermite curve through its points. */
import type { Polylines } from "../plant/plant.ts";

/** Below this share of the axis's longest segment a length counts as zero. */
const NEGLIGIBLE = 1e-9;

/** The curve of one axis. Made for reuse: `use` points it at another axis without allocating for most axes. */
export class Spline {
  /** How many spans (segments) the axis has. */
  spans = 0;
  /** Length of each span's chord, m. */
  lengths = new Float64Array(64);
  #points: Float64Array = new Float64Array(0);
  #first = 0;
  /** Velocity per arc length at each point: near unit length on a smooth axis, short where it folds back. */
  #slopes = new Float64Array(195);
  #velocity = new Float64Array(3);
  /** Where the axis points when the curve has no direction of its own. */
  #fallback: [number, number, number] = [0, 1, 0];

  /** Takes the axis that owns points `first .. end`. */
  use({ points }: Polylines, first: number, end: number): void {
    this.#points = points;
    this.#first = first;
    this.spans = Math.max(0, end - first - 1);
    if (this.lengths.length < this.spans) {
      this.lengths = new Float64Array(2 * this.spans);
      this.#slopes = new Float64Array(3 * (2 * this.spans + 1));
    }
    this.#measure();
    this.#findSlopes();
  }

  /** Lets the curve leave its first point in a unit direction, and forget it within about `reach` (m). */
  leave(direction: ArrayLike<number>, reach: number): void {
    const length = this.#length(0);
    if (this.spans === 0 || length === 0) return;
    const speed = Math.min(1, reach / length);
    for (let k = 0; k < 3; k++) this.#slopes[k] = speed * (direction[k] ?? 0);
  }

  /** The length of all chords, m. */
  get length(): number {
    let sum = 0;
    for (let span = 0; span < this.spans; span++) sum += this.#length(span);
    return sum;
  }

  /** Coordinate k of point i of this axis. */
  #point(i: number, k: number): number {
    return this.#points[3 * (this.#first + i) + k] ?? 0;
  }

  /**
   * Writes the position on span `span` (from point `span` to `span + 1` of the axis) at `u` between 0 and 1, and the unit
   * direction there. Where the curve has none (zero length, a cusp), `direction` keeps what it held if that was one.
   */
  follow(span: number, u: number, position: Float64Array, direction: Float64Array): void {
    const points = this.#points;
    const slopes = this.#slopes;
    const velocity = this.#velocity;
    const length = this.#length(span);
    const v = 1 - u;
    const start = v * v * (1 + 2 * u);
    const leaving = u * v * v * length;
    const end = u * u * (3 - 2 * u);
    const arriving = -u * u * v * length;
    // Of a span without length the slopes alone would speak, of which neither is its own.
    const moves = length > 0 ? 1 : 0;
    const bow = (moves * 6 * u * v) / (length || 1);
    const off = moves * v * (1 - 3 * u);
    const on = moves * u * (3 * u - 2);
    const point = 3 * (this.#first + span);
    for (let k = 0; k < 3; k++) {
      const near = points[point + k] ?? 0;
      const far = points[point + 3 + k] ?? 0;
      const slope = slopes[3 * span + k] ?? 0;
      const next = slopes[3 * span + 3 + k] ?? 0;
      position[k] = start * near + leaving * slope + end * far + arriving * next;
      velocity[k] = bow * (far - near) + off * slope + on * next;
    }
    const speed = size(velocity);
    if (speed > 1e-6) for (let k = 0; k < 3; k++) direction[k] = (velocity[k] ?? 0) / speed;
    else if (size(direction) < 0.5) direction.set(this.#fallback);
  }

  #length(span: number): number {
    return this.lengths[span] ?? 0;
  }

  #slope(i: number, k: number): number {
    return this.#slopes[3 * i + k] ?? 0;
  }

  #measure(): void {
    let longest = 0;
    for (let span = 0; span < this.spans; span++) {
      for (let k = 0; k < 3; k++) this.#velocity[k] = this.#chord(span, k);
      const length = size(this.#velocity);
      this.lengths[span] = length;
      longest = Math.max(longest, length);
    }
    this.#fallback = [0, 1, 0];
    for (let span = this.spans - 1; span >= 0; span--) {
      const length = this.#length(span);
      if (length <= NEGLIGIBLE * longest) this.lengths[span] = 0;
      else {
        this.#fallback = [
          this.#chord(span, 0) / length,
          this.#chord(span, 1) / length,
          this.#chord(span, 2) / length,
        ];
      }
    }
  }

  #chord(span: number, k: number): number {
    return this.#point(span + 1, k) - this.#point(span, k);
  }

  /** The parabola through three neighbours gives the slope in the middle; at the ends, the parabola of the last three. */
  #findSlopes(): void {
    const { spans } = this;
    for (let k = 0; k < 3; k++) {
      for (let i = 1; i < spans; i++) {
        const before = this.#length(i - 1);
        const after = this.#length(i);
        const both = before + after;
        // Beside a span without length, the other side alone knows the direction.
        const weight = before === 0 ? 0 : after === 0 ? 1 : after / both;
        this.#slopes[3 * i + k] = weight * this.#unit(i - 1, k) + (1 - weight) * this.#unit(i, k);
      }
      this.#slopes[k] = spans > 1 ? 2 * this.#unit(0, k) - this.#slope(1, k) : this.#unit(0, k);
      this.#slopes[3 * spans + k] =
        spans > 1 ? 2 * this.#unit(spans - 1, k) - this.#slope(spans - 1, k) : this.#unit(0, k);
    }
  }

  #unit(span: number, k: number): number {
    const length = this.#length(span);
    return length > 0 ? this.#chord(span, k) / length : 0;
  }
}

/** Not Math.hypot, which takes ten times as long to be right where squares overflow. */
function size(vector: Float64Array): number {
  const [x, y, z] = [vector[0] ?? 0, vector[1] ?? 0, vector[2] ?? 0];
  return Math.sqrt(x * x + y * y + z * z);
}
