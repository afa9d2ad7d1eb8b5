/**
 * What the edition claims, chapter by chapter. A string is a phrase with its numbers as the core computes them now: the
 * text must say just that. A pair is a phrase without numbers of its own, and whether it holds.
 */

import { numberText, quantityText } from "../../web/src/form/quantity.ts";
import { measure } from "../../web/src/geometry/measure.ts";
import { grow } from "../../web/src/package/node.ts";
import {
  apart,
  degrees,
  digits,
  direction,
  height,
  inflections,
  lowestTip,
  mass,
  moment,
  paramsOf,
  paramsOfPreset,
  plantOf,
  plantWith,
  sag,
  upOrDown,
} from "./measuring.ts";
import { balances, fork, printedAngle, turned } from "./theory.ts";

export type Claim = string | readonly [phrase: string, holds: boolean];

const gravity = "loads.gravity";
const stiffness = "material.youngsModulus";
const removed = { "loads.removed": true };
const weightless = { [gravity]: 0 };

/** The claims of each chapter. */
export const claims: Readonly<Record<string, () => readonly Claim[]>> = {
  question: () => {
    const still = plantOf("branch", weightless);
    const hanging = plantOf("branch", { "tropism.strength": 0 });
    return [
      "Set gravity to 0.",
      "strength of the tropism to 0",
      ["a flat S", inflections(plantOf("branch")) === 1],
      [
        "Without gravity the branch is straight",
        inflections(still) === 0 && Math.max(...still.segments.curvature.map(Math.abs)) < 1e-9,
      ],
      `it starts in the direction that it seeks, ${degrees(direction(still), 0)} upwards, and keeps to it`,
      ["Without the tropism it only hangs: a simple arch", inflections(hanging) === 0],
      ["its tip points down", direction(hanging) < 0],
    ];
  },

  joints: () => {
    const one = plantOf("joint");
    const { axis, material, solver } = one.params;
    const kappa = (material.youngsModulus * Math.PI * axis.radius ** 4) / 4 / axis.segmentLength;
    const theta = (-direction(one) * Math.PI) / 180;
    const torque = mass(one) * one.params.loads.gravity * measure(one).tip[0];
    const chain = plantOf("chain");
    const loaded = plantOf("chain", { "loads.tipMass": 0.03 });
    const bends = [...chain.segments.curvature].map(Math.abs);
    const swung = plantOf("chain", { "solver.method": "euler" });
    return [
      ["which the paper puts at its far end", solver.discretization === "paper" && axis.segments === 1],
      `One segment, ${quantityText(axis.segmentLength, "m")} long, on one spring`,
      ["level, to begin with", direction(plantOf("joint", weightless)) === 0],
      `For the rod above $\\kappa$ is ${digits(kappa)} N m for a radian (chapter 3`,
      `its mass is ${quantityText(mass(one), "kg")}.`,
      `It comes to rest ${degrees(-direction(one))} below the horizontal.`,
      `That is ${digits(theta)} radians, which cost ${digits(kappa * theta)} N m.`,
      `The weight, ${digits(mass(one) * one.params.loads.gravity)} N, has a lever of ${digits(measure(one).tip[0])} m there: ${digits(torque)} N m`,
      // The same, indeed: to the solver's tolerance.
      ["as well", Math.abs(kappa * theta - torque) < 1e-9],
      `Double it, to ${quantityText(2 * material.youngsModulus, "Pa")}`,
      `No: ${degrees(-direction(plantOf("joint", { [stiffness]: 2e9 })))}, which is more than half of ${degrees(-direction(one))}.`,
      `${["", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight"][chain.params.axis.segments]} segments.`,
      [
        "Most at the base, least at the tip",
        bends.every((own, at) => at === 0 || own < (bends[at - 1] ?? 0)),
      ],
      ["Then hang 30 g on the tip", loaded.params.loads.tipMass === 0.03],
      ["30 g, a quarter of what the whole chain weighs", Math.abs(0.03 / mass(chain) - 0.25) < 0.01],
      `take the largest torque from ${digits(moment(chain))} to ${digits(moment(loaded))} N m`,
      `and the tip ${((height(chain) - height(loaded)) * 100).toFixed(0)} cm further down`,
      [
        "the same shape to within a millionth of the length",
        apart(chain, swung) < 1e-6 * measure(chain).length,
      ],
    ];
  },

  gravity: () => {
    const at = (step: number) => plantOf("axis", {}, step);
    const q = (step: number) => numberText(at(step).report.gravityNumber, 2);
    const full = plantOf("axis");
    const moon = plantOf("axis", { [gravity]: 1.62 });
    const thick = plantOf("axis", { "axis.radius": 2 * full.params.axis.radius });
    const { axis } = full.params;
    const moonLike = axis.segments * Math.cbrt(1.62 / 9.81);
    const earthly = plantOf("axis", {
      "axis.segmentLength": (moonLike * axis.segmentLength) / axis.segments,
    });
    const level = plantWith({ axis: { elevation: 0 }, loads: { gravity: 0.01 } });
    const static_ = grow(paramsOf("axis", { "solver.stepping": "static" }));
    return [
      `It begins as one segment, at ${degrees(axis.elevation, 0)} above the horizontal`,
      `up to ${quantityText(measure(full).length, "m")}. Move its age`,
      `At step 10 the tip points ${degrees(direction(at(10)))} up, at step 20 still ${degrees(direction(at(20)))}.`,
      `At step 30 it has dipped to ${degrees(-direction(at(30)))} below the horizontal, at step 40 to ${degrees(-direction(at(40)))}.`,
      [
        "In all that is $2^3 = 8$.",
        Math.abs(at(40).report.gravityNumber / at(20).report.gravityNumber - 8) < 1e-9,
      ],
      `In the figure $q$ is ${q(10)} at step 10, ${q(20)} at step 20, ${q(30)} at step 30 and ${q(40)} at step 40.`,
      ["Below 1 an axis stands like a stick", direction(at(17)) > 40 && at(17).report.gravityNumber > 1],
      ["beyond 10 it hangs", at(36).report.gravityNumber > 10 && direction(at(36)) < -35],
      // Half a per mille is what forty segments leave (1/n²).
      [
        "the chain of segments gives it too",
        Math.abs((8 * sag(level)) / level.report.gravityNumber - 1) < 1e-3,
      ],
      [
        "Two axes with the same $q$ that start at the same elevation have the same shape",
        Math.abs(direction(earthly) - direction(moon)) < 1e-6,
      ],
      `Carry the axis to the Moon, where $g$ is ${moon.params.loads.gravity} m/s²`,
      [
        "(1.6 on the slider will do)",
        Math.abs(direction(moon) - direction(plantOf("axis", { [gravity]: 1.6 }))) < 0.5,
      ],
      ["mostly softer than green wood (1 to 15 GPa", full.params.material.youngsModulus < 1e9],
      `$q$ falls in proportion to $g$, to ${numberText(moon.report.gravityNumber)}.`,
      `The tip points ${degrees(direction(moon), 0)} upwards; it is the shape that the axis has on Earth at a length of ${(measure(earthly).length * 100).toFixed(0)} cm, at about step ${moonLike.toFixed(0)}`,
      [
        "make the axis twice as thick. It is four times as heavy then",
        Math.abs(mass(thick) / mass(full) - 4) < 1e-9,
      ],
      `No, it stands better: $q$ is ${numberText(thick.report.gravityNumber)}, a quarter of before.`,
      ["The springs of this chapter remember nothing", apart(full, static_) < 1e-6],
    ];
  },

  segments: () => {
    const coarse = (discretization: "paper" | "secondOrder") => {
      const light = { loads: { gravity: 1e-3 }, solver: { discretization, tolerance: 1e-12 } } as const;
      const plant = plantWith({ ...light, axis: { segments: 10, segmentLength: 0.15, elevation: 0 } });
      return ((8 * sag(plant)) / plant.report.gravityNumber - 1) * 100;
    };
    const shifts = (["paper", "secondOrder"] as const).map((name) => {
      const [even, uneven] = [1, 3].map((profile) =>
        plantOf("uneven", { "axis.lengthProfile": profile, "solver.discretization": name }),
      );
      return even && uneven ? apart(even, uneven) : Number.NaN;
    });
    const [cut, even] = ["figure-10", "figure-8d"].map((id) => grow(paramsOfPreset(id)));
    if (!cut || !even) throw new Error("Two plants were grown.");
    const { axis } = paramsOf("uneven");
    const { axis: rod, material } = paramsOf("joint");
    const kappa = (material.youngsModulus * Math.PI * rod.radius ** 4) / 4 / rod.segmentLength;
    return [
      [
        "in twelve segments, the middle ones three times as long",
        axis.segments === 12 && axis.lengthProfile === 3,
      ],
      "(figure 10)",
      "draws its figure 10",
      "1 to 15 GPa for green wood",
      `with $E$ of ${quantityText(material.youngsModulus, "Pa")}, a radius of ${quantityText(rod.radius, "m")} and a length of ${quantityText(rod.segmentLength, "m")}, that is the ${digits(kappa)} N m`,
      "the length profile from 3 to 1",
      `its tip moves by ${(100 * (shifts[0] ?? 0)).toFixed(1)} cm, the other's by ${(100 * (shifts[1] ?? 0)).toFixed(1)} cm`,
      ["for forty segments", even.params.axis.segments === 40],
      `have their tips ${(1000 * apart(cut, even)).toFixed(1)} mm apart, of ${quantityText(measure(even).length, "m")}.`,
      `A level rod in ten segments then sags ${coarse("paper").toFixed(0)} % too far`,
      `ten segments then sag ${coarse("secondOrder").toFixed(0)} % too far.`,
      ["Its error is in proportion", (shifts[0] ?? 0) > 3 * (shifts[1] ?? Number.NaN)],
    ];
  },

  tropism: () => {
    const young = paramsOf("setpoint");
    const full = plantOf("seeking");
    const soft = plantOf("seeking", { [stiffness]: 2e8 });
    const level = plantWith({
      axis: { elevation: 0, segments: 400, segmentLength: 0.00375 },
      tropism: { elevation: 0, strength: 1e6 },
      loads: { gravity: 0.01 },
    });
    return [
      `A stiff young organ of ${quantityText(young.axis.segments * young.axis.segmentLength, "m")} that starts at ${degrees(young.axis.elevation, 0)}`,
      ["Here weight plays almost no part", plantOf("setpoint").report.gravityNumber < 0.1],
      `The tip always starts out at ${degrees(full.params.tropism.elevation, 0)}, say.`,
      `starts at ${degrees(full.params.tropism.elevation, 0)} again`,
      `the axis seeks ${degrees(full.params.tropism.elevation, 0)} and is bent`,
      ["It has one inflection", inflections(full) === 1],
      `Why not at ${degrees(full.params.tropism.elevation, 0)}?`,
      `At ${degrees(direction(full))}. The last segment was attached at ${degrees(full.params.tropism.elevation, 0)}`,
      [
        "The stiffer the wood, the closer to 45° it stays",
        direction(plantOf("seeking", { [stiffness]: 5e9 })) > 44,
      ],
      `Make the wood softer, down to ${digits(soft.params.material.youngsModulus / 1e9)} GPa (${quantityText(soft.params.material.youngsModulus, "Pa")} on the slider).`,
      ["Yes to both", direction(soft) > 0 && inflections(soft) === 1],
      `the tip hangs ${(-height(soft) * 100).toFixed(0)} cm below the base by then, and still points ${degrees(direction(soft))} upwards`,
      // Full tropism converges with order 1: half a per cent is left at 400 segments.
      [
        "two thirds of what it would sag without a tropism ($wL^4/8EI$, chapter 2)",
        Math.abs((12 * sag(level)) / level.report.gravityNumber - 1) < 0.005,
      ],
    ];
  },

  pipes: () => {
    const [full, still, off] = [plantOf("rings"), plantOf("rings", weightless), plantOf("rings", removed)];
    const cm = (value: number) => digits(100 * value);
    const { segments } = full;
    const memory = plantOf("memory");
    const freed = plantOf("memory", removed);
    const piece = plantOf("memory", { "solver.stepping": "static" });
    const { axis, material, loads } = memory.params;
    const k =
      (material.density * loads.gravity * axis.segmentLength * 4) /
      (2 * material.youngsModulus * axis.radius ** 2);
    const kept = height(freed) / height(memory);
    return [
      `With ${segments.length.length} pipes a segment weighs ${((segments.mass[0] ?? 0) / (segments.mass.at(-1) ?? 1)).toFixed(0)} times as much as with one`,
      `and is ${((segments.radius[0] ?? 0) ** 4 / (segments.radius.at(-1) ?? 1) ** 4).toFixed(0)} times as stiff`,
      `it seeks ${degrees(full.params.tropism.elevation, 0)} and thickens`,
      [
        "the softer of its two axes",
        material.youngsModulus > 0 &&
          full.params.material.youngsModulus < paramsOfPreset("figure-17b").material.youngsModulus,
      ],
      `the tip of this axis is ${cm(height(full))} cm above its base`,
      `it would be straight and ${(100 * height(still)).toFixed(1)} cm up`,
      `it springs up to ${cm(height(off))} cm, not all the way: ${cm(height(still) - height(off))} of the ${cm(height(still) - height(full))} cm of sag stay for good`,
      `than the ${degrees(full.params.tropism.elevation, 0)} that it was seeking`,
      `Each new segment was set at ${degrees(full.params.tropism.elevation, 0)} while`,
      `the tip points ${degrees(direction(off))} up`,
      // Slight bending, forty segments: half a per cent.
      ["together by …", Math.abs(-height(memory) / ((k * measure(memory).length ** 3) / 3) - 1) < 0.005],
      // What is made in one piece thickens in steps, of which the last are coarse: six per cent.
      [
        "and a sag of $c\\,L^3/9$",
        Math.abs(-height(piece) / ((k * measure(piece).length ** 3) / 9) - 1) < 0.07,
      ],
      [
        "Growing under load makes the sag three times as large",
        Math.abs(height(memory) / height(piece) - 3) < 0.2,
      ],
      `About two thirds stay, as the two formulas have it: ${(-100 * height(freed)).toFixed(1)} of ${(-100 * height(memory)).toFixed(1)} cm.`,
      ["About two thirds stay", Math.abs(kept - 2 / 3) < 0.03],
      ["to less than half a millimetre", Math.abs(height(memory) - height(freed) - height(piece)) < 0.0005],
    ];
  },

  forks: () => {
    const equal = fork(2.49, 1);
    const unequal = fork(2.49, 0.8);
    const rising = paramsOf("fork");
    const hanging = paramsOfPreset("figure-18a");
    const { segments, polylines } = plantOf("fork", weightless);
    const turn = (axis: number) => {
      const [first = 0, second = 0] = [polylines.offsets[axis] ?? 0, (polylines.offsets[axis] ?? 0) + 1];
      const [x, y] = [0, 1].map(
        (k) => (polylines.points[3 * second + k] ?? 0) - (polylines.points[3 * first + k] ?? 0),
      );
      return Math.abs((Math.atan2(y ?? 0, x ?? 0) * 180) / Math.PI - rising.axis.elevation);
    };
    const closed = plantOf("fork", { ...weightless, "branching.exponent": 2 });
    const share = (ratio: number) => fork(2.49, ratio);
    return [
      `$\\alpha = ${rising.branching.exponent}$, which the paper takes`,
      `With two equal children each is ${(100 * equal.d1).toFixed(1)} % as thick as the parent`,
      `da Vinci would have made them ${(100 * fork(2, 1).d1).toFixed(1)} %`,
      [
        "With two equal children",
        Math.abs((segments.radius[segments.axis.indexOf(1)] ?? 0) / (segments.radius[0] ?? 1) - equal.d1) <
          1e-12,
      ],
      "derived $\\alpha = 3$",
      `Equal children go ${degrees(equal.x)} to either side.`,
      [
        "Equal children turn aside equally",
        Math.abs(turn(1) - equal.x) < 1e-6 && Math.abs(turn(2) - equal.y) < 1e-6,
      ],
      `With one 0.8 times as thick as the other (a girth ratio of 0.8) it is ${degrees(unequal.x)} for the thicker and ${degrees(unequal.y)} for the thinner one.`,
      `Figure 18 b of the paper: it starts ${degrees(rising.axis.elevation, 0)} upwards and forks four times`,
      [
        "forks four times, into equal children",
        rising.branching.generations === 4 && rising.branching.girthRatio === 1,
      ],
      `starts ${degrees(-hanging.axis.elevation, 0)} downwards, with unequal children`,
      ["and hangs", height(grow(hanging)) < 0],
      "Set the exponent to 2, da Vinci's rule.",
      ["both children go straight on", Math.abs(direction(closed) - rising.axis.elevation) < 1e-6],
      "Bough takes none below 2.",
      ["so Bough takes none below 2", throws(() => plantOf("fork", { "branching.exponent": 1.99 }))],
      ["it goes on nearly straight and nearly as thick as before", share(0.2).x < 3 && share(0.2).d1 > 0.99],
      ["The thin one stands off more and more", share(0.2).y > share(0.5).y && share(0.5).y > share(0.8).y],
      `of a fork with ratio 0.8 would turn ${degrees(printedAngle(2.49, 0.8))} aside instead of ${degrees(unequal.y)}`,
      `then stand ${degrees(unequal.x + printedAngle(2.49, 0.8))} apart`,
      `the angle between them, gives ${degrees(unequal.x + unequal.y)}`,
    ];
  },

  vector: () => {
    const { axis, tropism } = paramsOf("segment");
    const lambda = (tropism.strength * axis.segmentLength) / 2;
    const phi0 = tropism.elevation - axis.elevation;
    const strong = grow(paramsOfPreset("figure-20b"));
    const against = (elevation: number, strength: number) =>
      direction(plantOf("segment", { "axis.elevation": elevation, "tropism.strength": strength }));
    const at = (strength: number) => spread(plantOf("broom", { "tropism.strength": strength }));
    const twice = turned(turned(80, 0.3), 0.5);
    return [
      "With $\\lambda = 0$ nothing happens.",
      ["nothing happens", turned(50, 0) === 50],
      ["With a large $\\lambda$ the segment ends up along the vector", turned(50, 40) < 1e-9],
      `one segment of ${quantityText(axis.segmentLength, "m")}, weightless, that starts at ${degrees(axis.elevation, 0)}`,
      `the segment stands ${degrees(phi0, 0)} off the vector, and $k$ is ${tropism.strength} per metre`,
      `stands for half of the segment, ${(50 * axis.segmentLength).toFixed(0)} cm, as in chapter 3, so $\\lambda$ is ${lambda}.`,
      `turns ${degrees(phi0, 0)} into ${degrees(turned(phi0, lambda))}: the segment points ${degrees(direction(plantOf("segment")))} upwards`,
      `strong tropism, of ${strong.params.tropism.strength} per metre, brings it to ${degrees(direction(strong))}`,
      "straight down, at −90°, exactly against the vector",
      "And at −89°?",
      ["At −90° nothing: $\\sin 180°$ is 0", Math.abs(against(-90, 1e6) + 90) < 1e-9],
      `at −89° it turns, slowly at first, to −${degrees(-against(-89, 10))} with 10 per metre`,
      ["Only a far stronger tropism brings it all the way up", against(-89, 1e6) > 89.9],
      ["So it does not matter how finely an axis is cut", Math.abs(twice - turned(80, 0.8)) < 1e-9],
      `the first one starts, ${degrees(paramsOf("broom").axis.elevation, 0)} upwards`,
      `Move the strength from ${paramsOf("broom").tropism.strength} per metre, where the figure starts, towards ${paramsOfPreset("figure-21a").tropism.strength} per metre, which is figure 21 a`,
      ["run alongside each other again", at(18) < 0.6 * at(0.8)],
      "In equations 56, 58 and 59",
      "The result, 73, is right.",
      "by equation 30 $\\kappa$ itself goes as $1/s$",
    ];
  },

  beyond: () => {
    const column = plantOf("column");
    const { q, gravity: weight } = { q: column.report.gravityNumber, gravity: column.params.loads.gravity };
    const upright = (number: number) => plantOf("column", { [gravity]: (weight * number) / q });
    const leaning = (number: number) =>
      plantOf("column", { "axis.elevation": 89, [gravity]: (weight * number) / q });
    const all = balances(60, 30);
    const grown = plantWith({
      axis: { elevation: 60, segments: 80, segmentLength: 1 / 80, radius: 0.01 },
      material: { youngsModulus: (1000 * 9.81 * 4) / (30 * 1e-4) },
    });
    const lowest = (roll: number, ratio: number) =>
      lowestTip(plantOf("twist", { "branching.roll": roll, "material.shearModulusRatio": ratio }));
    const [flat, crossed, soft] = [lowest(0, 0.1), lowest(90, 0.1), lowest(90, 0.02)];
    const below = (height: number) => `${quantityText(-height, "m", 2)} below`;
    return [
      `with a gravity number of ${q.toFixed(0)}`,
      ["a balance that is stable again", column.report.stable === true && direction(column) < 0],
      "Bough pushes it by a thousandth of a radian",
      // Between the two, by less than forty segments are off.
      ["above $q = 7.84$", direction(upright(7.82)) === 90 && direction(upright(7.86)) < 89],
      "Greenhill found in 1881",
      "Lower the elevation to 89°.",
      `With $q = ${q.toFixed(0)}$ the leaning axis falls over: its tip points ${upOrDown(direction(leaning(q)))}.`,
      [
        "It crosses the horizontal again at about $q = 10$",
        direction(leaning(9.8)) > 0 && direction(leaning(10.8)) < 0,
      ],
      `at 7.84 it points ${degrees(direction(leaning(7.84)), 0)} up`,
      ["at 6 it is within 6° of upright", direction(leaning(6)) > 84],
      [`An axis at 60° with $q = 30$ has three`, all.length === 3],
      [
        "one hangs forward, as we expect; one is bent over backwards",
        (all[0]?.[0] ?? 0) > 0 && (all.at(-1)?.[0] ?? 0) < 0,
      ],
      ["about a tenth of that", paramsOf("twist").material.shearModulusRatio === 0.1],
      [
        "Figure 21 c of the paper, but the plane of each fork is turned",
        paramsOf("twist").branching.roll === 90,
      ],
      `with a roll of 0 the lowest tip is ${below(flat)} the base`,
      "Turn each fork by 90° against the one before",
      `now the lowest tip is ${below(crossed)} it`,
      [
        "Lower the shear modulus ratio from 0.1 to 0.02. What happens to the twigs? And with a roll of 0?",
        true,
      ],
      `The limbs twist five times as easily, and the lowest tip sinks to ${below(soft)} the base`,
      ["With a roll of 0 nothing happens at all", lowest(0, 0.02) === flat],
      "the paper's two dimensions",
      "Figure 13 d of the paper",
      ["with ten axes", paramsOf("stem").arrangement.count === 10],
      `What is special about ${degrees(paramsOf("stem").arrangement.divergence)}?`,
      ["180° makes two rows, 120° three.", rows(180) === 2 && rows(120) === 3],
      `With ${degrees(paramsOf("stem").arrangement.divergence)}, the golden angle`,
      ["no two axes ever come to stand one above the other", rows(137.5) === 10],
      [
        "Growth leads to the first",
        Math.hypot(measure(grown).tip[0] - (all[0]?.[0] ?? 0), measure(grown).tip[1] - (all[0]?.[1] ?? 0)) <
          1e-3,
      ],
    ];
  },
};

/** In how many directions the axes around the stem leave it, to a degree. */
function rows(divergence: number): number {
  const { polylines } = plantOf("stem", { "arrangement.divergence": divergence });
  const headings = [...polylines.offsets].slice(1, -1).map((start) => {
    const along = (k: number) =>
      (polylines.points[3 * start + 3 + k] ?? 0) - (polylines.points[3 * start + k] ?? 0);
    return (Math.round((Math.atan2(along(2), along(0)) * 180) / Math.PI) + 360) % 360;
  });
  return new Set(headings).size;
}

/** Share of the plant's width that its last generation takes: how far the tips stand apart, m. */
function spread({ polylines, segments }: ReturnType<typeof grow>): number {
  const last = Math.max(...segments.order);
  const tips = [...segments.point].filter((_, at) => segments.order[at] === last);
  const xs = tips.map((point) => polylines.points[3 * point] ?? 0);
  const ys = tips.map((point) => polylines.points[3 * point + 1] ?? 0);
  // Across the direction that is sought, 45 degrees.
  const across = xs.map((x, at) => ((ys[at] ?? 0) - x) / Math.SQRT2);
  return Math.max(...across) - Math.min(...across);
}

function throws(work: () => unknown): boolean {
  try {
    work();
    return false;
  } catch {
    return true;
  }
}
