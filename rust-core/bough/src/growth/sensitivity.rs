//! How every point of a grown plant moves with the parameters: exact derivatives, not differences.
//!
//! Wood remembers, so the finished shape depends on a parameter through every step since the first. The derivative goes the
//! same way: what a step does (thicken, attach, turn, weigh) is differentiated, and how its equilibrium moves follows from
//! the Hessian, which is eliminated once a step for all parameters. O(n) a step and parameter. Going backwards instead
//! (the adjoint) would be quicker for one number of the result, but a fit needs all points, and it would have to keep all steps.

use alloc::vec;
use alloc::vec::Vec;

use super::plant::segments_of;
use super::slope::{AxisSlope, ForkSlope};
use super::state::Growth;
use super::tropism::{FULL_STRENGTH, elasticity, is_exactly_away, turned};
use crate::angle::{Degrees, wrap};
use crate::mechanics::{Elimination, GROUND, Loads, Status, Tangent};
use crate::params::{BoughError, Discretization, Method, PARAMETERS, Params, Solver, Stepping, flat_length};
use crate::plant::Plant;
use crate::trigonometry::sin_cos;

/// The parameters that a shape depends on smoothly. Of all others no derivative is given.
const SMOOTH: &[&str] = &[
    "axis.segmentLength",
    "axis.lengthProfile",
    "axis.radius",
    "axis.taper",
    "axis.elevation",
    "material.youngsModulus",
    "material.density",
    "tropism.elevation",
    "tropism.strength",
    "branching.exponent",
    "branching.girthRatio",
    "loads.gravity",
    "loads.tipMass",
    "loads.foliage",
    "loads.tipForce",
];

/// Most segments, summed over all steps and parameters: about two seconds.
const MOST_STEPPED: usize = 50_000_000;

/// The plant at the end of a step, and how its points move with some parameters.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// The plant. Of an arrangement one copy, rooted where it would stand alone.
    pub plant: Plant,
    /// For each wanted parameter the derivative of `polylines.points`, m a unit of the parameter (angles: a degree); shape
    /// `wanted 3 P`. NaN throughout where the shape does not depend smoothly on it.
    pub slopes: Vec<f64>,
}

/// The plant at a growth step, and the exact derivatives of its points by the parameters at these places of the flat form.
/// `None` where there are none: anything acts on the grown plant alone (forces, weather, picking), growth is extrapolated, no equilibrium was found, or the
/// plant is too large.
///
/// # Errors
/// Every problem of the params at once.
///
/// # Cost
/// That of growing the plant, and O(n) a step and parameter.
pub fn sensitivity(params: &Params, step: u32, wanted: &[u32]) -> Result<Option<Sensitivity>, BoughError> {
    let solver = Solver { method: Method::Newton, ..params.solver.clone() };
    let mut growth = Growth::new(&Params { solver, ..params.clone() })?;
    let is_static = params.solver.stepping == Stepping::Static;
    // Derived are straight wood and planar growth, in the plane of the picture.
    let is_turned = params.axis.azimuth.0 != 0.0 || params.axis.rest_curvature != 0.0;
    if growth.is_spatial || is_turned || growth.has_aftermath() || !(is_static || growth.is_exact()) {
        return Ok(None);
    }
    let step = step.clamp(1, growth.steps());
    let mut derivatives: Vec<Derivative> =
        wanted.iter().map(|&place| Derivative::new(&growth, place)).collect();
    let mut elimination = Elimination::default();
    let (mut young, mut stepped) = (Young::default(), 0);
    while growth.steps_taken() < step {
        young.see(&growth);
        growth.work(step, &mut u64::MAX.clone());
        stepped += growth.rods() * (1 + wanted.len());
        if growth.report().status != Status::Converged || stepped > MOST_STEPPED {
            return Ok(None);
        }
        young.note_births(&growth);
        elimination.evaluate(&growth.state.linkage, &growth.state.loads);
        elimination.eliminate(&growth.state.linkage, 0.0);
        for derivative in &mut derivatives {
            derivative.follow(&growth, &young, &mut elimination);
        }
    }
    let plant = growth.plant();
    let mut slopes = Vec::new();
    for derivative in &derivatives {
        derivative.points(&growth, &plant, &mut slopes);
    }
    Ok(Some(Sensitivity { plant, slopes }))
}

/// The plant as it was when the step began, and what was born in it: the same for all parameters.
#[derive(Default)]
struct Young {
    /// Direction of each rod, in the frame of the base direction; of new ones at birth.
    angle: Vec<f64>,
    stiffness: Vec<f64>,
    /// How many segments each axis had.
    grown: Vec<u32>,
    /// For each rod its number in its axis.
    index: Vec<usize>,
}

impl Young {
    fn see(&mut self, growth: &Growth) {
        growth.state.linkage.angles(&mut self.angle);
        self.stiffness.clone_from(&growth.state.linkage.stiffness);
    }

    fn note_births(&mut self, growth: &Growth) {
        let linkage = &growth.state.linkage;
        self.grown.resize(growth.state.axes.len(), 0);
        for rod in self.index.len()..growth.rods() {
            let grown = &mut self.grown[growth.state.wood[rod].axis as usize];
            self.index.push(*grown as usize);
            *grown += u32::from(linkage.length[rod] > 0.0);
            self.angle.push(of(&self.angle, linkage.parent[rod]) + linkage.rest[rod]);
        }
    }
}

/// A number of a rod, or 0 of the ground.
fn of(numbers: &[f64], rod: u32) -> f64 {
    if rod == GROUND { 0.0 } else { numbers[rod as usize] }
}

/// All that changes with one parameter. Girths, stiffnesses and masses of first pipes are relative.
struct Derivative {
    direction: Params,
    is_smooth: bool,
    plan: Vec<AxisSlope>,
    fork: ForkSlope,
    /// Radius at each axis's base.
    base: Vec<f64>,
    /// Birth radius, spring constant and mass of each rod.
    girth: Vec<f64>,
    stiffness: Vec<f64>,
    mass: Vec<f64>,
    tangent: Tangent,
}

impl Derivative {
    fn new(growth: &Growth, place: u32) -> Self {
        let mut unit = vec![0.0; flat_length()];
        if let Some(number) = unit.get_mut(place as usize) {
            *number = 1.0;
        }
        let direction = Params::from_flat(&unit);
        let mut offset = 0;
        let is_smooth = PARAMETERS.iter().any(|parameter| {
            let first = offset;
            offset += parameter.kind.width();
            (first..offset).contains(&(place as usize)) && SMOOTH.contains(&parameter.path)
        });
        let plans = growth.plan.generations.iter();
        Derivative {
            plan: plans.map(|plan| AxisSlope::new(&growth.params, plan, &direction)).collect(),
            fork: ForkSlope::new(&growth.params, &direction),
            base: vec![direction.axis.radius / growth.params.axis.radius],
            direction,
            is_smooth,
            girth: Vec::new(),
            stiffness: Vec::new(),
            mass: Vec::new(),
            tangent: Tangent::default(),
        }
    }

    /// Takes part in the growth step that was just taken.
    fn follow(&mut self, growth: &Growth, young: &Young, elimination: &mut Elimination) {
        let linkage = &growth.state.linkage;
        let mut turns = self.tangent.turns(linkage, true);
        let Tangent { rest, deviation, .. } = &mut self.tangent;
        for rod in 0..rest.len() {
            // New pipes are laid at rest: the same shape, with a smaller deviation.
            let shrunk = deviation[rod] * (young.stiffness[rod] / linkage.stiffness[rod]);
            rest[rod] += deviation[rod] - shrunk;
            deviation[rod] = shrunk;
        }
        for axis in self.base.len()..growth.state.axes.len() {
            let bearer = growth.state.wood[growth.state.axes[axis].attached as usize].axis as usize;
            let generation = growth.state.axes[bearer].generation as usize;
            // Children come in pairs, the thicker one first.
            let width = self.fork.width[(axis + 1) % 2];
            self.base.push(self.base[bearer] + self.plan[generation].tip + width);
        }
        for rod in self.girth.len()..growth.rods() {
            self.attach(growth, young, rod, &mut turns);
        }
        self.weigh(growth);
        let relative = linkage.stiffness.iter().zip(&self.stiffness);
        self.tangent.stiffness = relative.map(|(stiffness, relative)| stiffness * relative).collect();
        elimination.respond(linkage, &growth.state.loads, &mut self.tangent);
    }

    /// A rod that is new: `turns` holds by how much each rod's direction at the step's beginning changes.
    fn attach(&mut self, growth: &Growth, young: &Young, rod: usize, turns: &mut Vec<f64>) {
        let linkage = &growth.state.linkage;
        let (wood, bearer, length) = (&growth.state.wood[rod], linkage.parent[rod], linkage.length[rod]);
        let axis = &growth.state.axes[wood.axis as usize];
        let second_order = growth.params.solver.discretization == Discretization::SecondOrder;
        let index = young.index[rod];
        let slope = &self.plan[axis.generation as usize];
        let modulus = self.direction.material.youngs_modulus / growth.params.material.youngs_modulus;
        let density = self.direction.material.density / growth.params.material.density;
        let is_node = length == 0.0;
        // The node of a fork is half of the parent's last segment.
        let segment = if is_node { index - 1 } else { index };
        let (longer, girth) = (slope.length[segment], self.base[wood.axis as usize] + slope.radius[segment]);
        let softer = longer - modulus - 4.0 * girth;
        let (mut stiffness, mut joint) = (-softer, longer * wood.joint_length);
        if second_order && !is_node && index > 0 {
            let below = bearer as usize;
            let longer_below = slope.length[index - 1];
            let softer_below = longer_below - modulus - 4.0 * self.girth[below];
            let compliance = |length: f64, radius: f64| length / (radius * radius * radius * radius);
            let own = compliance(length, wood.birth_radius);
            let other = compliance(linkage.length[below], growth.state.wood[below].birth_radius);
            stiffness = -(own * softer + other * softer_below) / (own + other);
            joint = 0.5 * (length * longer + linkage.length[below] * longer_below);
        }
        self.girth.push(girth);
        self.stiffness.push(stiffness);
        self.mass.push(density + 2.0 * girth + longer);
        // The branching angle turns the first segment of a child.
        let branching = if wood.axis > 0 && index == 0 && !is_node {
            let side = if growth.params.branching.roll.0 == 0.0 { 1.0 } else { -1.0 };
            let [thicker, thinner] = self.fork.turn;
            side * if wood.axis % 2 == 1 { thicker } else { -thinner }
        } else {
            0.0
        };
        let mut rest = branching;
        if second_order || bearer != GROUND {
            let turn = of(turns, bearer) + branching;
            rest += self.tropic_turn(
                growth,
                of(&young.angle, bearer) + wood.branching_turn,
                turn,
                wood.joint_length,
                joint,
            );
        }
        turns.push(of(turns, bearer) + rest);
        self.tangent.length.push(length * longer);
        self.tangent.rest.push(rest);
        self.tangent.deviation.push(0.0);
    }

    /// Derivative of the turn to the preferred direction (equation 73) of wood that starts at `angle`.
    fn tropic_turn(
        &self,
        growth: &Growth,
        angle: f64,
        angle_along: f64,
        length: f64,
        length_along: f64,
    ) -> f64 {
        let (tropism, along) = (&growth.params.tropism, &self.direction.tropism);
        let sought = |tropism: Degrees, axis: Degrees| Degrees(tropism.0 - axis.0).radians();
        let away = wrap(angle - sought(tropism.elevation, growth.params.axis.elevation));
        let away_along = angle_along - sought(along.elevation, self.direction.axis.elevation);
        let strength = tropism.strength;
        if is_exactly_away(away) && (strength > 0.0 || along.strength > 0.0) {
            // A fixed point without a side to turn to: by the least change it turns a long way.
            return if away_along == 0.0 && length_along == 0.0 && along.strength == 0.0 {
                0.0
            } else {
                f64::NAN
            };
        }
        let lambda = elasticity(strength, length);
        let lambda_along =
            if strength >= FULL_STRENGTH { 0.0 } else { along.strength * length + strength * length_along };
        let less = libm::exp(-lambda);
        let (sin, cos) = sin_cos(0.5 * away);
        let by_angle = less / (cos * cos + sin * sin * less * less);
        let (sin, _) = sin_cos(turned(away, lambda));
        (by_angle - 1.0) * away_along - sin * lambda_along
    }

    /// How the loads change: by masses, gravity and tip force, and as the frame turns with the elevation.
    fn weigh(&mut self, growth: &Growth) {
        let (linkage, loads) = (&growth.state.linkage, &growth.state.loads);
        let (given, along) = (&growth.params.loads, &self.direction.loads);
        let rods = growth.rods();
        let share = if growth.params.solver.discretization == Discretization::Paper { 1.0 } else { 0.5 };
        let (sin, cos) = growth.params.axis.elevation.sin_cos();
        let turn = self.direction.axis.elevation.radians();
        let (mut mass, mut mass_along) = (vec![0.0; rods], vec![0.0; rods]);
        for axis in growth.state.axes.iter().filter(|axis| !axis.forked && axis.segments > 0) {
            mass[axis.bearer as usize] += given.tip_mass;
            mass_along[axis.bearer as usize] += along.tip_mass;
        }
        self.tangent.load = Loads::none(rods);
        for rod in (0..rods).rev() {
            let wood = growth.mass(rod);
            let own = wood + growth.leaf_mass(rod);
            let own_along = wood * self.mass[rod] + self.leaves(growth, rod);
            let borne = mass[rod] + share * own;
            let borne_along = mass_along[rod] + share * own_along;
            let up = -along.gravity * borne - given.gravity * borne_along;
            self.tangent.load.x[rod] = up * sin + loads.y[rod] * turn;
            self.tangent.load.y[rod] = up * cos - loads.x[rod] * turn;
            if linkage.parent[rod] != GROUND {
                mass[linkage.parent[rod] as usize] += mass[rod] + own;
                mass_along[linkage.parent[rod] as usize] += mass_along[rod] + own_along;
            }
        }
        let mut rod = growth.state.axes[0].bearer;
        let [x, y, _] = along.tip_force;
        while rod != GROUND {
            self.tangent.load.x[rod as usize] += x * cos + y * sin;
            self.tangent.load.y[rod as usize] += y * cos - x * sin;
            rod = linkage.parent[rod as usize];
        }
    }

    /// Derivative of the mass of a rod's leaves, kg.
    fn leaves(&self, growth: &Growth, rod: usize) -> f64 {
        if !growth.bears_leaves(rod) {
            return 0.0;
        }
        let (given, along) = (&growth.params.loads, &self.direction.loads);
        along.foliage * growth.state.linkage.length[rod] + given.foliage * self.tangent.length[rod]
    }

    /// Appends the derivative of every point of the plant.
    fn points(&self, growth: &Growth, plant: &Plant, slopes: &mut Vec<f64>) {
        let linkage = &growth.state.linkage;
        let removed = growth.params.loads.removed;
        let turns = self.tangent.turns(linkage, !removed);
        let (base, base_turn) =
            (growth.params.axis.elevation.radians(), self.direction.axis.elevation.radians());
        let mut angle: Vec<f64> = Vec::with_capacity(linkage.len());
        let mut end: Vec<[f64; 2]> = Vec::with_capacity(linkage.len());
        let below = |end: &[[f64; 2]], rod: usize| match linkage.parent[rod] {
            GROUND => [0.0; 2],
            parent => end[parent as usize],
        };
        for rod in 0..linkage.len() {
            let deviation = if removed { 0.0 } else { linkage.deviation[rod] };
            angle.push(of(&angle, linkage.parent[rod]) + linkage.rest[rod] + deviation);
            let (sin, cos) = sin_cos(base + angle[rod]);
            let (longer, turn) = (self.tangent.length[rod], linkage.length[rod] * (turns[rod] + base_turn));
            let [x, y] = below(&end, rod);
            end.push([x + longer * cos - turn * sin, y + longer * sin + turn * cos]);
        }
        let first = slopes.len();
        slopes.resize(first + plant.polylines.points.len(), if self.is_smooth { 0.0 } else { f64::NAN });
        let slopes = &mut slopes[first..];
        if end.iter().flatten().any(|slope| !slope.is_finite()) {
            slopes.fill(f64::NAN);
        }
        if !self.is_smooth || slopes.first().is_some_and(|slope| slope.is_nan()) {
            return;
        }
        for (segment, (rod, _)) in segments_of(growth).enumerate() {
            let point = 3 * plant.segments.point[segment] as usize;
            slopes[point - 3..point - 1].copy_from_slice(&below(&end, rod));
            slopes[point..point + 2].copy_from_slice(&end[rod]);
        }
    }
}
