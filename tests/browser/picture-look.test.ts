/** What the picture itself can do: colours that mean something, the model, forks, picking, and forces. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { legend } from "../../web/src/geometry/legend.ts";
import { grow, init, presets } from "../../web/src/package/node.ts";
import type { ParamsInput } from "../../web/src/params/params.ts";
import type { Plant } from "../../web/src/plant/plant.ts";
import { launchChromium } from "./chromium.ts";
import { serveBench, visitBench } from "./picture-bench/bench.ts";
import { Pixels } from "./pixels.ts";

let browser: Browser;
let bench: Awaited<ReturnType<typeof serveBench>>;
beforeAll(async () => {
  await init();
  bench = await serveBench();
  browser = await launchChromium();
});
afterAll(async () => {
  await browser.close();
  await bench.close();
});

type Triple = [number, number, number];
type Color = "moment" | "stress" | "curvature" | "age";
const paramsOf = (preset: string): ParamsInput => presets[preset]?.params ?? {};
const visit = (...shown: Parameters<Window["bench"]["show"]>) => visitBench(browser, bench.address, ...shown);

/** The middle of a segment, m. */
function middle({ polylines: { points }, segments }: Plant, segment: number): Triple {
  const at = 3 * (segments.point[segment] ?? 0);
  return [0, 1, 2].map((k) => ((points[at + k] ?? 0) + (points[at - 3 + k] ?? 0)) / 2) as Triple;
}

function project(page: Page, points: Triple[]): Promise<{ x: number; y: number }[]> {
  return page.evaluate((points) => points.map((point) => window.bench.stage.project(point)), points);
}

/** Red, green and blue of the legend's colour for a share of its range. */
function inLegend(plant: Plant, color: Color, value: number): Triple {
  const { min, max, stops } = legend(plant, color) ?? { min: 0, max: 1, stops: [] };
  const place = ((value - min) / (max - min)) * (stops.length - 1);
  const channels = (css = "#000000") => [1, 3, 5].map((at) => Number.parseInt(css.slice(at, at + 2), 16));
  const below = channels(stops[Math.floor(place)]?.css);
  const above = channels(stops[Math.ceil(place)]?.css);
  return below.map((value, k) => value + (place % 1) * ((above[k] ?? 0) - value)) as Triple;
}

describe("colour by a value", () => {
  it.each(["moment", "stress", "curvature", "age"] as const)("%s is what the legend says", async (color) => {
    const params = paramsOf("figure-13c");
    const plant = grow(params);
    const page = await visit(params, { color });
    const chosen = [2, 8, 14, 20, 26, 32, 37];
    const places = await project(
      page,
      chosen.map((segment) => middle(plant, segment)),
    );
    const pixels = await Pixels.of(page);
    for (const [i, segment] of chosen.entries()) {
      const { x, y } = places[i] ?? { x: 0, y: 0 };
      const { birth, [color as "moment"]: values } = plant.segments;
      const at = (segment: number) =>
        color === "age" ? plant.report.steps - (birth[segment] ?? 0) : (values[segment] ?? 0);
      const expected = inLegend(plant, color, (at(segment) + at(segment + 1)) / 2);
      // Light and shadow still model the limb a little.
      for (const k of [0, 1, 2] as const) {
        expect(Math.abs(pixels.at(x, y)[k] - expected[k])).toBeLessThan(40);
      }
    }
    await page.context().close();
  });

  it("goes back to bark", async () => {
    const page = await visit({}, { color: "stress" });
    const painted = await Pixels.of(page);
    await page.evaluate(() => window.bench.show({}));
    const bark = await Pixels.of(page);
    await page.evaluate(() => window.bench.show({}, { color: "stress" }));
    expect(painted.difference(bark, 900)).toBeGreaterThan(60);
    expect((await Pixels.of(page)).difference(painted, 900)).toBeLessThan(3);
    await page.context().close();
  });
});

describe("the model", () => {
  it("shows rods, springs around the joints and masses in them", async () => {
    const params: ParamsInput = { axis: { segments: 6, segmentLength: 0.2 }, loads: { gravity: 0 } };
    const plant = grow(params);
    const page = await visit(params, { style: "model" });
    const end = 3 * (plant.segments.point[2] ?? 0);
    const joint = [...plant.polylines.points.subarray(end, end + 3)] as Triple;
    const [rod, mass, metre, origin] = await project(page, [middle(plant, 2), joint, [1, 0, 0], [0, 0, 0]]);
    const pixels = await Pixels.of(page);
    const { x = 0, y = 0 } = mass ?? {};
    const [red, green, blue] = pixels.at(x, y);
    expect(green).toBeGreaterThan(red);
    expect(red).toBeLessThan(110);
    expect(blue).toBeLessThan(110);
    expect(Math.max(...pixels.at(rod?.x ?? 0, rod?.y ?? 0))).toBeLessThan(190);
    // The ring of the spring is found by going out from the joint across the rod: paper, then orange, then paper.
    const scale = (metre?.x ?? 0) - (origin?.x ?? 0);
    const across = Array.from({ length: Math.ceil(0.06 * scale) }, (_, i) => {
      const angle = ((50 + 90) * Math.PI) / 180;
      return pixels.at(x + i * Math.cos(angle), y - i * Math.sin(angle));
    });
    expect(across.some(([r, g, b]) => r > g + 40 && g > b + 15)).toBe(true);
    await page.context().close();
  });

  it("gives way to limbs, and says so, where there are too many segments", async () => {
    const page = await visit({ axis: { segments: 5000, segmentLength: 0.0003 } });
    const said = await page.evaluate(() => {
      const { plant, stage } = window.bench;
      return (
        plant &&
        stage.show(plant, {
          grown: plant,
          view: "plane",
          style: "model",
          tone: "light",
          settled: true,
          passage: 0,
        })
      );
    });
    expect(said).toContain("4000 segments");
    await page.context().close();
  });

  it("says nothing where there are few", async () => {
    const page = await visit({});
    const said = await page.evaluate(() => {
      const { plant, stage } = window.bench;
      return (
        plant &&
        stage.show(plant, {
          grown: plant,
          view: "plane",
          style: "model",
          tone: "light",
          settled: true,
          passage: 0,
        })
      );
    });
    expect(said).toBeNull();
    await page.context().close();
  });
});

describe("a fork", () => {
  it("has no edge where a thin limb leaves a thick one", async () => {
    const params = paramsOf("figure-21a");
    const { segments, polylines } = grow(params);
    // Colours that mean something are without the grain of bark.
    const page = await visit(params, { color: "age" });
    await page.evaluate(async () => {
      window.bench.stage.zoom(2.2);
      await window.bench.rest();
    });
    const children = [...segments.parent.keys()].filter(
      (own) => segments.axis[segments.parent[own] ?? -1] === 0 && segments.axis[own] !== 0,
    );
    const thin = children.toSorted((a, b) => (segments.radius[a] ?? 0) - (segments.radius[b] ?? 0))[0] ?? 0;
    const end = segments.point[thin] ?? 0;
    const at = (point: number) => [...polylines.points.subarray(3 * point, 3 * point + 3)] as Triple;
    const [from, to] = await project(page, [at(end - 1), at(end)]);
    const pixels = await Pixels.of(page);
    const brightness = Array.from({ length: 61 }, (_, i) => {
      const along = (a = 0, b = 0) => a + (i / 60) * (b - a);
      return pixels.at(along(from?.x, to?.x), along(from?.y, to?.y)).reduce((sum, value) => sum + value, 0);
    });
    // Without the swelling the thick limb's round end shows as an edge across the thin one: a step of 16.
    const steps = brightness.slice(1).map((value, i) => Math.abs(value - (brightness[i] ?? 0)));
    expect(Math.max(...steps)).toBeLessThan(10);
    await page.context().close();
  });
});

describe("picking", () => {
  it.each([
    ["figure-8d", "plane"],
    ["figure-13c", "space"],
    ["figure-21a", "plane"],
  ] as const)("finds every segment of %s in %s", async (preset, view) => {
    const params = paramsOf(preset);
    const plant = grow(params);
    const page = await visit(params, { view });
    const middles = [...plant.segments.point].map((_, segment) => middle(plant, segment));
    const found = await page.evaluate((middles) => {
      const { stage } = window.bench;
      const { left, top } = stage.canvas.getBoundingClientRect();
      return middles.map((point) => {
        const { x, y } = stage.project(point);
        return stage.pick(left + x, top + y);
      });
    }, middles);
    for (const [segment, middle] of middles.entries()) {
      const { point } = found[segment] ?? { point: [9, 9, 9] };
      expect(Math.hypot(...middle.map((value, k) => value - (point[k] ?? 0)))).toBeLessThan(1e-3);
    }
    await page.context().close();
  });

  it("takes what is within a finger's breadth, and nothing farther away", async () => {
    const page = await visit({ loads: { gravity: 0 }, axis: { elevation: 0 } });
    const [near, far] = await page.evaluate(() => {
      const { stage } = window.bench;
      const { x, y } = stage.project([0.8, 0, 0]);
      return [stage.pick(x, y - 20), stage.pick(x, y - 60)];
    });
    expect(near?.point[0]).toBeCloseTo(0.8, 3);
    expect(far).toBeNull();
    await page.context().close();
  });

  it.each(["plane", "space"] as const)("goes back to the world in %s", async (view) => {
    const params = paramsOf("figure-13d");
    const plant = grow(params);
    const page = await visit(params, { view });
    // On the plane of an axis around the stem: a place on it, and one above.
    const segment = plant.segments.axis.indexOf(view === "plane" ? 1 : 4) + 10;
    const point = middle(plant, segment);
    const above: Triple = [point[0], point[1] + 0.2, point[2]];
    const back = await page.evaluate(
      ({ above, point, segment }) => {
        const { stage } = window.bench;
        const { x, y } = stage.project(above);
        return stage.unproject(x, y, point, segment);
      },
      { above, point, segment },
    );
    expect(back).toEqual(above.map((value) => expect.closeTo(value, 6)));
    await page.context().close();
  });
});

describe("a force", () => {
  it("is an arrow in its direction, with its size in words, and goes away", async () => {
    const page = await visit({});
    await page.evaluate(async () => {
      window.bench.stage.showForce({ at: [0.8, 0.3, 0], force: [0, 0.32, 0] });
      await window.bench.rest();
    });
    await page.getByText("0.32 N · 33 gf").waitFor();
    const [at] = await project(page, [[0.8, 0.3, 0]]);
    const pixels = await Pixels.of(page);
    const [red, green] = pixels.at(at?.x ?? 0, (at?.y ?? 0) - 20);
    expect(red).toBeGreaterThan(green + 50);
    await page.evaluate(async () => {
      window.bench.stage.showForce(null);
      await window.bench.rest();
    });
    expect(await page.getByText("33 gf").isVisible()).toBe(false);
    await page.context().close();
  });
});

describe("a hundred thousand segments", () => {
  it("are drawn, and picked", async () => {
    const params: ParamsInput = {
      axis: { segments: 12, segmentLength: 0.02, elevation: 90 },
      material: { youngsModulus: 1e11 },
      branching: { pattern: "bifurcation", generations: 12, lengthRatio: 1 },
    };
    const page = await visit(params);
    const count = await page.evaluate(() => window.bench.plant?.segments.point.length);
    expect(count).toBeGreaterThan(98_000);
    const [trunk] = await project(page, [[0, 0.15, 0]]);
    const pixels = await Pixels.of(page);
    expect(pixels.wood(trunk?.x ?? 0, trunk?.y ?? 0, 1)).toBeGreaterThan(0.7);
    const picked = await page.evaluate(() => {
      const { stage } = window.bench;
      const { x, y } = stage.project([0, 0.15, 0]);
      return stage.pick(x, y);
    });
    expect(picked?.segment).toBeLessThan(12);
    await page.context().close();
  });
});
