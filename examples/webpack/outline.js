/** The outline of the first axis as an SVG path that fits a picture: down one side of the wood and up the other. */
export function outlineOf({ points, radii, offsets }, width, height) {
  const end = offsets[1];
  const sides = [[], []];
  for (let point = 0; point < end; point++) {
    const [before, after] = [Math.max(0, point - 1), Math.min(end - 1, point + 1)];
    const dx = points[3 * after] - points[3 * before];
    const dy = points[3 * after + 1] - points[3 * before + 1];
    const length = Math.hypot(dx, dy) || 1;
    for (const [k, side] of sides.entries()) {
      const out = (k === 0 ? 1 : -1) * (radii[point] / length);
      side.push([points[3 * point] - out * dy, points[3 * point + 1] + out * dx]);
    }
  }
  const outline = [...sides[0], ...sides[1].reverse()];
  const [xs, ys] = [0, 1].map((k) => outline.map((place) => place[k]));
  const [left, low] = [Math.min(...xs), Math.min(...ys)];
  const scale = 0.9 * Math.min(width / (Math.max(...xs) - left), height / (Math.max(...ys) - low));
  const places = outline.map(
    ([x, y]) =>
      `${(0.05 * width + scale * (x - left)).toFixed(1)} ${(0.95 * height - scale * (y - low)).toFixed(1)}`,
  );
  return `M ${places.join(" L ")} Z`;
}
