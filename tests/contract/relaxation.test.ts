/** The record of a plant that comes to rest the paper's way: its shapes, its beginning, and where it ends. */
import { beforeAll, describe, expect, test } from "vitest";
import { history, init, type ParamsInput, type Plant, relaxation } from "../../web/src/package/node.ts";

beforeAll(() => init());

const forked = { branching: { pattern: "bifurcation", generations: 1 }, axis: { segments: 4 } } as const;
const cases: [string, ParamsInput][] = [
  ["an axis", { axis: { segments: 8 } }],
  ["an axis in the paper's discretization", { axis: { segments: 8 }, solver: { discretization: "paper" } }],
  [
    "pipes and tropism",
    { axis: { segments: 8 }, growth: { thickening: "pipes" }, tropism: { strength: 2, elevation: 90 } },
  ],
  ["a fork", forked],
];

/** Direction of every segment, radians counter-clockwise from +x. */
function directions({ polylines: { points }, segments }: Plant): number[] {
  const at = (index: number) => points[index] ?? Number.NaN;
  return [...segments.point].map((point) =>
    Math.atan2(at(3 * point + 1) - at(3 * point - 2), at(3 * point) - at(3 * point - 3)),
  );
}

/** The least turn between two directions. */
function turn(a: number, b: number): number {
  return Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));
}

describe.each(cases)("%s", (_, params) => {
  const steps = () => history(params).steps;

  test.each([1, 3, undefined])("in step %s ends in the equilibrium that grow finds", (step) => {
    const trajectory = relaxation(params, step);
    const plant = history(params).at(step ?? steps());
    const { segments, time, angle, velocity, status, residual } = trajectory;
    expect(status).toBe("converged");
    expect(residual).toBeLessThanOrEqual(1e-10);
    expect(segments).toBe(plant.segments.parent.length);
    const last = angle.subarray(-segments);
    const wrong = directions(plant).map((direction, index) => turn(direction, last[index] ?? Number.NaN));
    expect(Math.max(...wrong)).toBeLessThan(1e-8);
    for (const array of [time, angle, velocity]) expect(array).toBeInstanceOf(Float64Array);
    expect(angle).toHaveLength(time.length * segments);
    expect(velocity).toHaveLength(time.length * segments);
  });
});

test("begins at rest, with the new segment straight on", () => {
  const params = { axis: { segments: 6 } } as const;
  const { angle, velocity, time, segments } = relaxation(params);
  expect(time[0]).toBe(0);
  expect([...velocity.subarray(0, segments)]).toEqual([0, 0, 0, 0, 0, 0]);
  const before = directions(history(params).at(5));
  const tip = before.at(-1) ?? Number.NaN;
  for (const [index, direction] of [...before, tip].entries()) expect(angle[index]).toBeCloseTo(direction, 9);
});

test("tells of at most 512 moments, in order", () => {
  const { time, steps } = relaxation({ axis: { segments: 30 } });
  expect(steps).toBeGreaterThan(512);
  expect(time.length).toBeGreaterThan(100);
  expect(time.length).toBeLessThanOrEqual(512);
  expect([...time]).toEqual([...new Set(time)].toSorted((a, b) => a - b));
});

test("of axes around a stem is that of one of them, alone", () => {
  const axis = { segments: 4 };
  expect(relaxation({ axis, arrangement: { pattern: "stem" } })).toEqual(relaxation({ axis }));
});

test("takes a step outside as the nearest inside, a fraction as the step below", () => {
  const params = { axis: { segments: 5 } } as const;
  expect(relaxation(params, -3)).toEqual(relaxation(params, 1));
  expect(relaxation(params, 2.9)).toEqual(relaxation(params, 2));
  expect(relaxation(params, 2 ** 32 + 1)).toEqual(relaxation(params));
});

test("of bad params, or of no step at all, lists what is wrong", () => {
  expect(() => relaxation({ axis: { segments: 0 } })).toThrow("axis.segments must be a whole number");
  expect(() => relaxation({}, Number.NaN)).toThrow("step must be a number from 1 to 40; it is NaN.");
});
