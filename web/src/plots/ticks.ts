/** Round values along a scale. */

/** Two to five multiples of 1, 2 or 5 (times a power of ten) within a range. */
export function ticksWithin(min: number, max: number, most = 5): number[] {
  const span = max - min;
  if (!(span > 0) || !Number.isFinite(span)) return [min];
  const power = 10 ** Math.floor(Math.log10(span / most));
  const step = (([1, 2, 5].find((digit) => span / (digit * power) <= most) ?? 10) as number) * power;
  const first = Math.ceil(min / step - 1e-9);
  const last = Math.floor(max / step + 1e-9);
  // Plus zero: there is no negative zero.
  return Array.from({ length: last - first + 1 }, (_, k) => (first + k) * step + 0);
}
