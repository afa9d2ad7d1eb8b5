/** The centre lines as a drawing: SVG, seen from the front (x to the right, y up), in millimetres at full size. */
import type { Plant } from "../plant/plant.ts";

/** Of the larger side of the drawing: what the pen is wide, and what is left free around. */
const [pen, margin] = [0.004, 0.03];

/** One path an axis, with its number and order. */
export function drawing({ polylines, segments, version }: Plant, title: string): string {
  const { points, offsets } = polylines;
  const [x, y] = [span(points, 0), span(points, 1)];
  const size = Math.max(x.max - x.min, y.max - y.min) || 1;
  const free = margin * size;
  // A hundred-thousandth of the drawing is finer than any pen.
  const places = Math.max(0, Math.ceil(5 - Math.log10(1000 * size)));
  const mm = (meters: number) => String(Number((1000 * meters).toFixed(Math.min(places, 20))));
  const order = orders(segments);
  const paths = Array.from({ length: offsets.length - 1 }, (_, axis) => {
    const line: string[] = [];
    for (let point = offsets[axis] ?? 0; point < (offsets[axis + 1] ?? 0); point++) {
      line.push(
        `${mm((points[3 * point] ?? 0) - x.min + free)} ${mm(y.max + free - (points[3 * point + 1] ?? 0))}`,
      );
    }
    return `  <path id="axis-${axis}" data-order="${order.get(axis) ?? 0}" d="M${line.join("L")}"/>`;
  });
  const [width, height] = [mm(x.max - x.min + 2 * free), mm(y.max - y.min + 2 * free)];
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" viewBox="0 0 ${width} ${height}">`,
    `  <title>${escaped(title)}</title>`,
    `  <desc>Centre lines by Bough ${version}, seen from the front; 1 unit is 1 mm.</desc>`,
    `  <g fill="none" stroke="#2a2a25" stroke-width="${mm(pen * size)}" stroke-linecap="round" stroke-linejoin="round">`,
    ...paths.map((path) => `  ${path}`),
    "  </g>",
    "</svg>",
    "",
  ].join("\n");
}

function span(points: Float64Array, coordinate: number): { min: number; max: number } {
  let [min, max] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let at = coordinate; at < points.length; at += 3) {
    min = Math.min(min, points[at] ?? min);
    max = Math.max(max, points[at] ?? max);
  }
  return min <= max ? { min, max } : { min: 0, max: 0 };
}

/** The order of each axis. */
function orders({ axis, order }: Plant["segments"]): Map<number, number> {
  const found = new Map<number, number>();
  axis.forEach((one, segment) => {
    found.set(one, order[segment] ?? 0);
  });
  return found;
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}
