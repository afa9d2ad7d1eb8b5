//! The paper's way to equilibrium: damped rotation of every joint, integrated by explicit Euler steps
//! (equations 12 to 20). Kept as the paper has it, to compare with and to play; [`super::settle`] is the
//! method to use.
//!
//! The paper states neither the damping nor the time step. Here every joint gets the damping that is critical
//! for its own rotation, `b = 2 sqrt(k I)`: `I` is the moment of inertia about the joint (equation 16), `k` its
//! spring constant plus the loads' moment arm, an upper bound of the stiffness that loads can add. The fastest
//! joint, the tip's, then bounds the time step: `dt = 1/2 min sqrt(I / k)`, half the step at which explicit
//! Euler is deadbeat for it. The slowest joint, the base's, takes `sqrt(I / k)` of its own a digit: the number
//! of steps grows like the root of the ratio of the two inertias, `n^1.5`, and the work like `n^2.5`.

use alloc::vec;
use alloc::vec::Vec;

use super::equilibrium::Settings;
use super::hessian::Elimination;
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::report::{Outcome, Status};
use crate::trigonometry::sin_cos;

/// Most Euler steps taken for one growth step.
pub const MAX_EULER_STEPS: u64 = 2_000_000;

/// One relaxation in progress: the rods' deviations and the joints' angular velocities.
#[derive(Clone, Debug)]
pub struct Relaxation {
    /// The rods as they stand.
    pub linkage: Linkage,
    /// Angular velocity `omega` of every base joint, 1/s.
    pub velocity: Vec<f64>,
    /// Time since the start, s. The masses are real, the damping is chosen: only the end state is physical.
    pub time: f64,
    /// Euler steps taken.
    pub taken: u64,
    loads: Loads,
    /// Mass lumped at each rod's distal end, kg.
    mass: Vec<f64>,
    /// Moment arm of the loads about each joint, N m.
    arm: Vec<f64>,
    state: Elimination,
    inertia: Vec<f64>,
    beyond: Vec<Beyond>,
    /// Largest damping torque of the last step, N m.
    drag: f64,
}

/// Mass beyond a rod's distal end, seen from there.
#[derive(Clone, Copy, Debug, Default)]
struct Beyond {
    mass: f64,
    first_x: f64,
    first_y: f64,
    second: f64,
}

impl Relaxation {
    /// Starts at rest. `mass` is lumped at each rod's distal end, kg.
    pub fn new(linkage: Linkage, loads: Loads, mass: Vec<f64>) -> Self {
        let rods = linkage.len();
        let mut arm = vec![0.0; rods];
        for rod in (0..rods).rev() {
            arm[rod] += linkage.length[rod] * libm::hypot(loads.x[rod], loads.y[rod]);
            if linkage.parent[rod] != GROUND {
                arm[linkage.parent[rod] as usize] += arm[rod];
            }
        }
        let mut state = Elimination::default();
        state.evaluate(&linkage, &loads);
        Relaxation {
            velocity: vec![0.0; rods],
            time: 0.0,
            taken: 0,
            linkage,
            loads,
            mass,
            arm,
            state,
            inertia: Vec::new(),
            beyond: Vec::new(),
            drag: 0.0,
        }
    }

    /// Largest torque left over, without damping, relative to the largest external torque.
    pub fn residual(&self) -> f64 {
        let left = self.state.largest_residual();
        if left == 0.0 { 0.0 } else { left / self.state.largest_torque() }
    }

    /// Whether the torques balance within the tolerance, and the damping of what still moves lies within it
    /// too: a joint can pass through balance at speed.
    pub fn at_rest(&self, tolerance: f64) -> bool {
        let torque = tolerance * self.state.largest_torque();
        let allowed = f64::max(torque, self.state.round_off(&self.linkage));
        self.state.largest_residual() <= allowed && self.drag <= allowed
    }

    /// Moment of inertia about every base joint, kg m2, written to `inertia` (equation 16). O(n).
    fn measure_inertia(&mut self, inertia: &mut Vec<f64>) {
        let rods = self.linkage.len();
        self.beyond.clear();
        self.beyond.extend(self.mass.iter().map(|&mass| Beyond { mass, ..Beyond::default() }));
        inertia.clear();
        inertia.resize(rods, 0.0);
        for rod in (0..rods).rev() {
            let end = self.beyond[rod];
            let length = self.linkage.length[rod];
            let (sin, cos) = sin_cos(self.state.angle[rod]);
            let (dx, dy) = (length * cos, length * sin);
            let second =
                end.second + 2.0 * (dx * end.first_x + dy * end.first_y) + end.mass * length * length;
            inertia[rod] = second;
            if self.linkage.parent[rod] != GROUND {
                let below = &mut self.beyond[self.linkage.parent[rod] as usize];
                below.mass += end.mass;
                below.first_x += end.first_x + end.mass * dx;
                below.first_y += end.first_y + end.mass * dy;
                below.second += second;
            }
        }
    }

    /// Takes up to `steps` Euler steps; an outcome when the torques balance and nothing moves, when a number
    /// overflows, or at [`MAX_EULER_STEPS`] since the start.
    pub fn relax(&mut self, settings: Settings, steps: u64) -> Option<Outcome> {
        let last = self.taken.saturating_add(steps);
        loop {
            let status = if self.at_rest(settings.tolerance) {
                Status::Converged
            } else if !self.residual().is_finite() {
                Status::NonFinite
            } else if self.taken == MAX_EULER_STEPS {
                Status::MaxIterations
            } else if self.taken == last {
                return None;
            } else {
                self.step();
                continue;
            };
            let residual = self.residual();
            return Some(Outcome { status, residual, iterations: self.taken, unstable_directions: None });
        }
    }

    /// One iteration of Newton's method instead of an Euler step; `time` counts it as 1. Returns the largest turn of any rod,
    /// infinite where the Hessian is not positive definite.
    #[inline]
    pub fn newton(&mut self) -> f64 {
        let (unstable, turn) = self.state.newton(&mut self.linkage);
        self.time += 1.0;
        self.taken += 1;
        self.state.evaluate(&self.linkage, &self.loads);
        if unstable == 0 { turn } else { f64::INFINITY }
    }

    /// Takes the shape of another linkage of the same rods, as one more iteration.
    #[inline]
    pub fn bend(&mut self, shape: &Linkage) {
        self.linkage.clone_from(shape);
        self.time += 1.0;
        self.state.evaluate(&self.linkage, &self.loads);
    }

    /// One Euler step, equations 15 to 20: all joints at once, from the old angles and velocities. O(n).
    pub fn step(&mut self) {
        let mut inertia = core::mem::take(&mut self.inertia);
        self.measure_inertia(&mut inertia);
        let stiffness = |joint: usize| self.linkage.stiffness[joint] + self.arm[joint];
        let joints = 0..self.linkage.len();
        let fastest =
            joints.clone().map(|joint| inertia[joint] / stiffness(joint)).fold(f64::INFINITY, f64::min);
        let dt = 0.5 * libm::sqrt(fastest);
        self.drag = 0.0;
        for joint in joints {
            let damping =
                2.0 * libm::sqrt((self.linkage.stiffness[joint] + self.arm[joint]) * inertia[joint]);
            let omega = self.velocity[joint];
            let alpha = (-self.state.residual[joint] - damping * omega) / inertia[joint];
            self.linkage.deviation[joint] += omega * dt;
            self.velocity[joint] += alpha * dt;
            self.drag = self.drag.max((damping * omega).abs());
        }
        self.inertia = inertia;
        self.time += dt;
        self.taken += 1;
        self.state.evaluate(&self.linkage, &self.loads);
    }
}
