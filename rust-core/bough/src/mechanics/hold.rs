//! The force that holds a point of a linkage at a place: what the pointer does when it drags a branch.

use alloc::vec;
use alloc::vec::Vec;

use super::descent::{DEFINITE, SMALLEST_SHIFT, energy};
use super::equilibrium::{Settings, add, largest_turn, polish};
use super::hessian::Elimination;
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::report::{Outcome, Status};
use crate::trigonometry::sin_cos;

/// How near a point is held to where it is wanted, over the length of the path to it.
const PLACE_TOLERANCE: f64 = 1e-10;
/// Reach that is used: a rod pulled quite straight would need a force without bound.
const USED_REACH: f64 = 0.998;
/// Stiffness of the spring between point and place, over that of the linkage there.
const SPRING: f64 = 100.0;
/// How much stiffer the spring gets each time it comes to rest stretched.
const STIFFER: f64 = 4.0;
/// Turn of any rod in one iteration, radians.
const LARGEST_TURN: f64 = 0.5;
const ITERATIONS: u64 = 300;

/// A force and the equilibrium in which it holds its point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// The force at the distal end of the rod, N, in the frame of the base direction.
    pub force: [f64; 2],
    /// Where the distal end is held, m, from the base, in the frame of the base direction.
    pub place: [f64; 2],
    /// How the search ended. When it did not converge, the linkage is as it was.
    pub outcome: Outcome,
}

/// Finds the force on the distal end of `rod` that holds it at `place` beside the `loads`, and brings the linkage to
/// equilibrium with both. A place out of reach is drawn in to 0.998 of the reach, that of a rod on the ground to where its
/// end can be. `force` is where the search starts: the one that held the point a moment ago, or none.
///
/// A stiff spring draws the point to its place; its end is then moved on by what is left (method of multipliers)
/// until the point is where it is wanted. With the Hessian H and the derivative B of the point by the rods' angles, the
/// spring adds the rank-two term `k B^T B`; Newton's increment and the inertia of the sum follow from `H^-1 B^T` and
/// the 2 x 2 compliance `B H^-1 B^T`. Energy falls in every iteration. O(n) each.
pub fn hold(
    linkage: &mut Linkage,
    loads: &Loads,
    rod: usize,
    place: [f64; 2],
    force: [f64; 2],
    settings: Settings,
) -> Held {
    let start = linkage.deviation.clone();
    let mut search = Search::new(linkage, loads, rod, place);
    let mut held = Held { force, ..Held::default() };
    held.outcome.status = Status::MaxIterations;
    let mut kept_force = force;
    while held.outcome.iterations < ITERATIONS {
        held.outcome.iterations += 1;
        held.force = search.evaluate(linkage, loads, kept_force);
        held.place = search.place;
        let torque = search.state.largest_torque();
        let left = search.state.largest_residual();
        if !left.is_finite() {
            break;
        }
        held.outcome.residual = search.state.relative_residual();
        // One rounding of the place is a force of this torque in the spring.
        let jitter = 16.0 * f64::EPSILON * search.spring * search.reach * search.reach;
        let round_off = f64::max(search.state.round_off(linkage), jitter);
        if left <= f64::max(settings.tolerance * torque, round_off) {
            let off = search.off();
            if libm::hypot(off[0], off[1]) <= PLACE_TOLERANCE * search.reach {
                let polished = polish(linkage, &search.pulled, settings);
                held.outcome =
                    Outcome { iterations: held.outcome.iterations + polished.iterations, ..polished };
                held.place = end_of(linkage, &search.path);
                break;
            }
            // At rest, but with the spring still stretched: its force becomes the force that is kept, and a rod that
            // is nearly straight, which gives way much less than it did, needs a stiffer spring.
            kept_force = held.force;
            search.spring *= STIFFER;
            continue;
        }
        search.improve(linkage, loads, kept_force);
    }
    if held.outcome.status != Status::Converged {
        linkage.deviation = start;
    }
    held
}

struct Search {
    /// The rods from the ground to the point.
    path: Vec<usize>,
    reach: f64,
    wanted: [f64; 2],
    /// Stiffness of the spring, N/m; 0 until the linkage's own is known.
    spring: f64,
    place: [f64; 2],
    state: Elimination,
    /// The given loads and the force.
    pulled: Loads,
    increment: Vec<f64>,
    turn: Vec<f64>,
    by_force: [Vec<f64>; 2],
}

impl Search {
    fn new(linkage: &Linkage, loads: &Loads, rod: usize, place: [f64; 2]) -> Self {
        let mut path = vec![rod];
        let mut parent = linkage.parent[rod];
        while parent != GROUND {
            path.push(parent as usize);
            parent = linkage.parent[parent as usize];
        }
        path.reverse();
        let reach: f64 = path.iter().map(|&rod| linkage.length[rod]).sum();
        // No bend shortens a rod alone: its end is on a circle.
        let is_alone = path.len() == 1;
        let most = if is_alone { reach } else { USED_REACH * reach };
        let away = libm::hypot(place[0], place[1]);
        let shrink = if is_alone || away > most { most / away } else { 1.0 };
        let wanted = place.map(|part| part * shrink);
        let mut search = Search {
            path,
            reach,
            wanted,
            spring: 0.0,
            place: [0.0; 2],
            state: Elimination::default(),
            pulled: loads.clone(),
            increment: Vec::new(),
            turn: Vec::new(),
            by_force: [Vec::new(), Vec::new()],
        };
        search.evaluate(linkage, loads, [0.0; 2]);
        // Of the order of the linkage's own stiffness, and positive in any state.
        search.state.eliminate(linkage, DEFINITE);
        let compliance = search.compliance(linkage);
        search.spring = SPRING * 2.0 / (compliance[0][0] + compliance[1][1]);
        search
    }

    /// How far the point still is from its place.
    fn off(&self) -> [f64; 2] {
        [self.wanted[0] - self.place[0], self.wanted[1] - self.place[1]]
    }

    /// Evaluates torques under the loads and the present force, which it returns: the one kept and the spring's.
    fn evaluate(&mut self, linkage: &Linkage, loads: &Loads, kept: [f64; 2]) -> [f64; 2] {
        self.place = end_of(linkage, &self.path);
        let off = self.off();
        let force = [kept[0] + self.spring * off[0], kept[1] + self.spring * off[1]];
        for &rod in &self.path {
            self.pulled.x[rod] = loads.x[rod] + force[0];
            self.pulled.y[rod] = loads.y[rod] + force[1];
        }
        self.state.evaluate(linkage, &self.pulled);
        force
    }

    /// One step down in energy.
    fn improve(&mut self, linkage: &mut Linkage, loads: &Loads, kept: [f64; 2]) {
        let mut shift = 0.0;
        loop {
            let negative = self.state.eliminate(linkage, shift);
            let compliance = self.compliance(linkage);
            let [[a, b], [_, d]] = compliance;
            let (a, d) = (a + 1.0 / self.spring, d + 1.0 / self.spring);
            let determinant = a * d - b * b;
            let below_zero = u32::from(determinant < 0.0) + 2 * u32::from(determinant > 0.0 && a < 0.0);
            // The inertia of H + k B^T B: as many negative directions as H has beyond those of 1/k + B H^-1 B^T.
            if negative == below_zero || shift >= DEFINITE {
                let residual = self.state.residual.clone();
                self.state.solve(linkage, &residual, &mut self.increment);
                let [x, y] = moved(linkage, &self.path, &self.state.angle, &self.increment);
                let change = [-(d * x - b * y) / determinant, -(a * y - b * x) / determinant];
                for (column, change) in self.by_force.iter().zip(change) {
                    add(&mut self.increment, column, change);
                }
                break;
            }
            shift = f64::max(SMALLEST_SHIFT, 2.0 * shift);
        }
        let turn = largest_turn(linkage, &self.increment, &mut self.turn);
        let slope = self.state.slope(&self.increment);
        let whole = |linkage: &Linkage| {
            let place = end_of(linkage, &self.path);
            let off = [self.wanted[0] - place[0], self.wanted[1] - place[1]];
            energy(linkage, loads) - kept[0] * place[0] - kept[1] * place[1]
                + 0.5 * self.spring * (off[0] * off[0] + off[1] * off[1])
        };
        let before = whole(linkage);
        let saved = linkage.deviation.clone();
        let mut scale = f64::min(1.0, LARGEST_TURN / turn);
        for _ in 0..40 {
            add(&mut linkage.deviation, &self.increment, scale);
            // Within rounding of the energy, Newton's step is trusted.
            let rounding = 1e-13 * (before.abs() + slope.abs());
            if whole(linkage) <= before + 1e-4 * scale * slope + rounding {
                break;
            }
            linkage.deviation.clone_from(&saved);
            scale *= 0.5;
        }
    }

    /// `B H^-1 B^T` with the Hessian as last eliminated: how the point gives way to a force. Keeps `H^-1 B^T`.
    fn compliance(&mut self, linkage: &Linkage) -> [[f64; 2]; 2] {
        let arms = self.arms(linkage);
        for (arm, column) in arms.iter().zip(&mut self.by_force) {
            self.state.solve(linkage, arm, column);
        }
        self.by_force.each_ref().map(|column| moved(linkage, &self.path, &self.state.angle, column))
    }

    /// What a force of 1 N along x, and along y, at the point leaves over of the balance at every joint.
    fn arms(&self, linkage: &Linkage) -> [Vec<f64>; 2] {
        let mut arms = [vec![0.0; linkage.len()], vec![0.0; linkage.len()]];
        let [mut dx, mut dy] = [0.0, 0.0];
        for &rod in self.path.iter().rev() {
            let (sin, cos) = sin_cos(self.state.angle[rod]);
            dx += linkage.length[rod] * cos;
            dy += linkage.length[rod] * sin;
            arms[0][rod] = dy;
            arms[1][rod] = -dx;
        }
        arms
    }
}

/// Where the end of the path is.
fn end_of(linkage: &Linkage, path: &[usize]) -> [f64; 2] {
    let mut angle = 0.0;
    path.iter().fold([0.0, 0.0], |[x, y], &rod| {
        angle += linkage.joint_angle(rod);
        let (sin, cos) = sin_cos(angle);
        [x + linkage.length[rod] * cos, y + linkage.length[rod] * sin]
    })
}

/// How far the end of the path moves with these increments of the joints.
fn moved(linkage: &Linkage, path: &[usize], angle: &[f64], increment: &[f64]) -> [f64; 2] {
    let mut turn = 0.0;
    path.iter().fold([0.0, 0.0], |[x, y], &rod| {
        turn += increment[rod];
        let (sin, cos) = sin_cos(angle[rod]);
        let length = linkage.length[rod];
        [x - length * sin * turn, y + length * cos * turn]
    })
}
