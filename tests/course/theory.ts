/** The course's formulas by themselves, without the core: so that the two can be compared. */

const degree = Math.PI / 180;

/** Murray's fork (47 to 49): widths over the parent's, angles in degrees; the thinner child is `ratio` times as thick. */
export function fork(alpha: number, ratio: number): { d1: number; d2: number; x: number; y: number } {
  const d1 = (1 + ratio ** alpha) ** (-1 / alpha);
  const d2 = ratio * d1;
  // Rounding may take a cosine of 1 a little beyond.
  const angle = (cosine: number) => Math.acos(Math.min(1, cosine)) / degree;
  const x = angle((1 + d1 ** 4 - d2 ** 4) / (2 * d1 ** 2));
  const y = angle((1 - d1 ** 4 + d2 ** 4) / (2 * d2 ** 2));
  return { d1, d2, x, y };
}

/** Equation 49 as it is printed, degrees. */
export function printedAngle(alpha: number, ratio: number): number {
  const { d1, d2 } = fork(alpha, ratio);
  return Math.acos((1 - d1 ** 4 + d2 ** 4) / (2 * d1 ** 2)) / degree;
}

/** Equation 73, degrees. */
export function turned(phi0: number, lambda: number): number {
  return (2 * Math.atan(Math.tan((phi0 / 2) * degree) * Math.exp(-lambda))) / degree;
}

/**
 * All balances of a uniform rod under its weight, by shooting: tips over the length, from the one that is bent most
 * forward to the one that is bent most backward. Clamped at `elevation` degrees, with gravity number `q`.
 */
export function balances(elevation: number, q: number): [x: number, y: number][] {
  const found: [number, number][] = [];
  let before = { end: Number.NaN, tip: [0, 0] };
  // The curvature at the clamp times the length; beyond 20 either way the rod would be a spiral.
  for (let bend = -20; bend < 20; bend += 0.01) {
    const now = shoot(elevation * degree, bend, q);
    if (before.end * now.end < 0) {
      const share = before.end / (before.end - now.end);
      const between = (k: 0 | 1) => (before.tip[k] ?? 0) * (1 - share) + now.tip[k] * share;
      found.push([between(0), between(1)]);
    }
    before = now;
  }
  return found;
}

/** Integrates `psi'' = q (1 - s) cos psi` from the clamp; at a free tip `psi'` is zero. */
function shoot(psi0: number, bend: number, q: number): { end: number; tip: [number, number] } {
  const steps = 400;
  const h = 1 / steps;
  let [psi, curvature, x, y] = [psi0, bend, 0, 0];
  for (let step = 0; step < steps; step++) {
    // Heun's rule: its error, of the size of a tenth of a per mille here, is below the step in which tips are searched.
    const s = step * h;
    const slope = q * (1 - s) * Math.cos(psi);
    const ahead = psi + h * curvature;
    const next = curvature + (h / 2) * (slope + q * (1 - s - h) * Math.cos(ahead));
    const middle = psi + (h / 4) * (curvature + next);
    x += h * Math.cos(middle);
    y += h * Math.sin(middle);
    psi += (h / 2) * (curvature + next);
    curvature = next;
  }
  return { end: curvature, tip: [x, y] };
}
