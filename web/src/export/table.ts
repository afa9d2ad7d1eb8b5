/** The plant as a table: CSV, one row a segment. */
import type { Plant } from "../plant/plant.ts";

type Column = readonly [title: string, value: (plant: Plant, segment: number) => number];

/** From the base of a segment to its distal end, m. */
function step({ polylines: { points }, segments }: Plant, segment: number): readonly number[] {
  const end = 3 * (segments.point[segment] ?? 0);
  return [0, 1, 2].map((k) => (points[end + k] ?? 0) - (points[end - 3 + k] ?? 0));
}

const place = (coordinate: number, shift: number): Column[1] => {
  return ({ polylines, segments }, segment) =>
    polylines.points[3 * ((segments.point[segment] ?? 0) - shift) + coordinate] ?? 0;
};

const own = (
  name: "length" | "radius" | "mass" | "moment" | "twistMoment" | "curvature" | "stress",
): Column[1] => {
  return ({ segments }, segment) => segments[name][segment] ?? 0;
};

/** Units stand in the header: those of `Plant.segments`. */
const columns: readonly Column[] = [
  ["segment", (_, segment) => segment],
  ["parent", ({ segments }, segment) => segments.parent[segment] ?? -1],
  ["axis", ({ segments }, segment) => segments.axis[segment] ?? 0],
  ["order", ({ segments }, segment) => segments.order[segment] ?? 0],
  ["birth (growth step)", ({ segments }, segment) => segments.birth[segment] ?? 0],
  ["length (m)", own("length")],
  ["radius (m)", own("radius")],
  ["mass (kg)", own("mass")],
  ["base x (m)", place(0, 1)],
  ["base y (m)", place(1, 1)],
  ["base z (m)", place(2, 1)],
  ["end x (m)", place(0, 0)],
  ["end y (m)", place(1, 0)],
  ["end z (m)", place(2, 0)],
  [
    "elevation (deg)",
    (plant, segment) => {
      const [x = 0, y = 0, z = 0] = step(plant, segment);
      return (Math.atan2(y, Math.hypot(x, z)) * 180) / Math.PI;
    },
  ],
  ["bending moment (N m)", own("moment")],
  ["twisting moment (N m)", own("twistMoment")],
  ["curvature (1/m)", own("curvature")],
  ["rest curvature (1/m)", ({ segments }, segment) => segments.restCurvature[segment] ?? 0],
  ["largest stress (Pa)", own("stress")],
];

/** CSV after RFC 4180. Numbers are written so that they read back to the last bit. */
export function table(plant: Plant): string {
  const rows = [columns.map(([title]) => title).join(",")];
  for (let segment = 0; segment < plant.segments.parent.length; segment++) {
    rows.push(columns.map(([, value]) => value(plant, segment)).join(","));
  }
  return `${rows.join("\r\n")}\r\n`;
}
