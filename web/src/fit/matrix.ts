/** Small symmetric systems: as many unknowns as parameters are fitted. */

/** The columns that cannot be told from combinations of the others, if the matrix is as good as singular. */
export class Singular extends Error {
  readonly columns: readonly number[];

  constructor(columns: readonly number[]) {
    super("The matrix is singular.");
    this.columns = columns;
  }
}

/**
 * The inverse of a symmetric, positive definite matrix with ones on its diagonal.
 * @param least smallest share of a column that must not follow from those before it
 * @throws {Singular}
 */
export function inverse(matrix: readonly (readonly number[])[], least: number): number[][] {
  const size = matrix.length;
  const work = matrix.map((row, i) => [...row, ...Array.from({ length: size }, (_, k) => (k === i ? 1 : 0))]);
  for (let pivot = 0; pivot < size; pivot++) {
    const own = work[pivot] ?? [];
    const size_ = own[pivot] ?? 0;
    if (!(size_ > least)) {
      // What is left of the column is nothing: the reduced rows above tell of which others it is made.
      const others = work.slice(0, pivot).flatMap((row, k) => (Math.abs(row[pivot] ?? 0) > 1e-3 ? [k] : []));
      throw new Singular([...others, pivot]);
    }
    for (let k = 0; k < 2 * size; k++) own[k] = (own[k] ?? 0) / size_;
    work.forEach((row, i) => {
      const factor = row[pivot] ?? 0;
      if (i === pivot || factor === 0) return;
      for (let k = 0; k < 2 * size; k++) row[k] = (row[k] ?? 0) - factor * (own[k] ?? 0);
    });
  }
  return work.map((row) => row.slice(size));
}

/** A matrix times a vector. */
export function times(matrix: readonly (readonly number[])[], vector: readonly number[]): number[] {
  return matrix.map((row) => row.reduce((sum, entry, k) => sum + entry * (vector[k] ?? 0), 0));
}
