/** Frames that follow a curve without turning about it (parallel transport), so that nothing drawn on a limb twists. */

/** The present frame: `normal` and `binormal` span the cross-section, `normal` x `binormal` = `tangent`. */
export class Transport {
  readonly position = new Float64Array(3);
  readonly tangent = new Float64Array(3);
  readonly normal = new Float64Array(3);
  readonly binormal = new Float64Array(3);
  #reflected = new Float64Array(3);

  /** Starts a curve; the tangent must be a unit vector. The same tangent always gets the same frame. */
  start(position: Float64Array, tangent: Float64Array): void {
    this.position.set(position);
    this.tangent.set(tangent);
    // For an axis in the plane of the picture that is z: the frame then stays in this plane all along.
    const k = [2, 0, 1].reduce((best, next) =>
      size(tangent, next) < size(tangent, best) - 1e-9 ? next : best,
    );
    const along = tangent[k] ?? 0;
    const length = Math.sqrt(1 - along * along);
    for (let j = 0; j < 3; j++) {
      this.normal[j] = ((j === k ? 1 : 0) - along * (tangent[j] ?? 0)) / length;
    }
    this.#cross();
  }

  /**
   * Goes on to the next position and unit tangent, by two reflections: the first carries the frame to the new position,
   * the second turns its tangent into the new one. Fourth order accurate. Returns how far it went.
   *
   * Wang, Juettler, Zheng & Liu (2008), Computation of rotation minimizing frames, doi:10.1145/1330511.1330513
   */
  advance(position: Float64Array, tangent: Float64Array): number {
    const { normal, tangent: old } = this;
    const between = this.#reflected;
    subtract(position, this.position, between);
    const first = dot(between, between);
    if (first > 0) {
      reflect(normal, between, first);
      reflect(old, between, first);
    }
    subtract(tangent, old, between);
    const second = dot(between, between);
    if (second > 1e-24) reflect(normal, between, second);
    copy(position, this.position);
    copy(tangent, old);
    this.#clean();
    this.#cross();
    return Math.sqrt(first);
  }

  /** Takes away the round-off that builds up along thousands of rings. */
  #clean(): void {
    const { normal, tangent } = this;
    const along = dot(normal, tangent);
    for (let k = 0; k < 3; k++) normal[k] = (normal[k] ?? 0) - along * (tangent[k] ?? 0);
    const length = Math.sqrt(dot(normal, normal));
    for (let k = 0; k < 3; k++) normal[k] = (normal[k] ?? 0) / length;
  }

  #cross(): void {
    const { normal, tangent, binormal } = this;
    const [nx, ny, nz] = [normal[0] ?? 0, normal[1] ?? 0, normal[2] ?? 0];
    const [tx, ty, tz] = [tangent[0] ?? 0, tangent[1] ?? 0, tangent[2] ?? 0];
    binormal[0] = ty * nz - tz * ny;
    binormal[1] = tz * nx - tx * nz;
    binormal[2] = tx * ny - ty * nx;
  }
}

function size(vector: Float64Array, k: number): number {
  return Math.abs(vector[k] ?? 0);
}

function dot(a: Float64Array, b: Float64Array): number {
  return (a[0] ?? 0) * (b[0] ?? 0) + (a[1] ?? 0) * (b[1] ?? 0) + (a[2] ?? 0) * (b[2] ?? 0);
}

/** Not `set`: for three numbers the call takes longer than the copying. */
function copy(from: Float64Array, into: Float64Array): void {
  for (let k = 0; k < 3; k++) into[k] = from[k] ?? 0;
}

function subtract(a: Float64Array, b: Float64Array, into: Float64Array): void {
  for (let k = 0; k < 3; k++) into[k] = (a[k] ?? 0) - (b[k] ?? 0);
}

/** Mirrors `vector` at the plane across `across`, whose squared length is given. */
function reflect(vector: Float64Array, across: Float64Array, squared: number): void {
  const share = (2 * dot(across, vector)) / squared;
  for (let k = 0; k < 3; k++) vector[k] = (vector[k] ?? 0) - share * (across[k] ?? 0);
}
