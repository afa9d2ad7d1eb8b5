//! Torques, gradient and Hessian of the energy, and the Hessian's elimination from the leaves to the root.
//!
//! With each rod's absolute angle `psi` as unknown the energy is
//! `sum 1/2 kappa theta^2 - sum l (X cos psi + Y sin psi)`, `(X, Y)` the force beyond each rod. The loads touch
//! only the Hessian's diagonal, `h = l (X cos psi + Y sin psi)`, and a spring couples a rod with its parent
//! only, so eliminating children before parents makes no fill-in: O(n), and the signs of the pivots are the
//! Hessian's inertia (Sylvester).
//!
//! The pivot of rod i is `p = kappa + e` where `e = h + sum over children kappa e_c / (kappa + e_c)`: springs
//! in series. Working with `e` instead of `p` subtracts no large numbers from each other.

use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use crate::trigonometry::sines_and_cosines;

/// Torques at one state, and the elimination of the Hessian there. Buffers are kept between uses.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Angle of each rod, radians, in the frame of the base direction.
    pub angle: Vec<f64>,
    /// External torque about each base joint, N m, counter-clockwise (equation 8).
    pub torque: Vec<f64>,
    /// Torque left over at each base joint: `kappa theta - torque` (equation 14 at rest).
    pub residual: Vec<f64>,
    /// Diagonal of the load's Hessian, N m.
    geometric: Vec<f64>,
    sine: Vec<f64>,
    cosine: Vec<f64>,
    excess: Vec<f64>,
    /// One over the pivot.
    flexibility: Vec<f64>,
    /// Stiffness, and excess, over the pivot: they add up to 1.
    gain: Vec<f64>,
    slack: Vec<f64>,
    carried: Vec<f64>,
    turn: Vec<f64>,
}

impl Elimination {
    /// Torques and residuals at the linkage's present state. O(n).
    pub fn evaluate(&mut self, linkage: &Linkage, loads: &Loads) {
        let rods = linkage.len();
        linkage.angles(&mut self.angle);
        sines_and_cosines(&self.angle, &mut self.sine, &mut self.cosine);
        for array in [&mut self.torque, &mut self.residual, &mut self.geometric] {
            array.clear();
            array.resize(rods, 0.0);
        }
        // Slices of one length: their bounds are checked once.
        let (sine, cosine) = (&self.sine[..rods], &self.cosine[..rods]);
        let (x, y, length) = (&loads.x[..rods], &loads.y[..rods], &linkage.length[..rods]);
        let (torque, geometric) = (&mut self.torque[..rods], &mut self.geometric[..rods]);
        for rod in 0..rods {
            torque[rod] = length[rod] * (cosine[rod] * y[rod] - sine[rod] * x[rod]);
            geometric[rod] = length[rod] * (cosine[rod] * x[rod] + sine[rod] * y[rod]);
        }
        let mut passed = 0.0;
        for rod in (0..rods).rev() {
            let sum = torque[rod] + passed;
            torque[rod] = sum;
            passed = pass_down(linkage.parent[rod], rod, sum, torque);
        }
        let springs = linkage.stiffness.iter().zip(&linkage.deviation);
        for ((residual, torque), (stiffness, deviation)) in
            self.residual.iter_mut().zip(&self.torque).zip(springs)
        {
            *residual = stiffness * deviation - torque;
        }
    }

    /// Largest external torque, N m.
    pub fn largest_torque(&self) -> f64 {
        largest(&self.torque)
    }

    /// Largest torque left over, N m; NaN when any is.
    pub fn largest_residual(&self) -> f64 {
        largest(&self.residual)
    }

    /// Residual that round-off alone can leave: the torques that springs make of one rounding of an angle.
    pub fn round_off(&self, linkage: &Linkage) -> f64 {
        let mut largest = 0.0_f64;
        for rod in 0..linkage.len() {
            let below = match linkage.parent[rod] {
                GROUND => 0.0,
                parent => self.angle[parent as usize].abs(),
            };
            let angles = self.angle[rod].abs() + below + linkage.rest[rod].abs();
            largest = largest.max(linkage.stiffness[rod] * angles);
        }
        8.0 * f64::EPSILON * largest
    }

    /// Eliminates the Hessian at the last evaluated state, with `shift` times the size of the load's own terms added
    /// to its diagonal: 0 is the Hessian itself, from 1 on the sum is positive definite. In these units a limp twig is
    /// shifted as little as it weighs. Returns how many pivots are not positive: 0 means a stable shape. O(n).
    pub fn eliminate(&mut self, linkage: &Linkage, shift: f64) -> u32 {
        let rods = linkage.len();
        self.excess.clear();
        self.excess.extend(self.geometric.iter().map(|term| term + shift * term.abs()));
        for array in [&mut self.flexibility, &mut self.gain, &mut self.slack] {
            array.resize(rods, 0.0);
        }
        let mut not_positive = 0;
        // Along an axis what a rod passes down stays in a register: the next rod is its parent.
        let mut passed = 0.0;
        for rod in (0..rods).rev() {
            let stiffness = linkage.stiffness[rod];
            let mut excess = self.excess[rod] + passed;
            let mut pivot = stiffness + excess;
            // A pivot of exactly 0 is perturbed by one rounding: it counts as not positive all the same.
            if pivot == 0.0 {
                pivot = -f64::EPSILON * stiffness;
                excess = pivot - stiffness;
            }
            if pivot.is_nan() || pivot <= 0.0 {
                not_positive += 1;
            }
            let flexibility = 1.0 / pivot;
            self.flexibility[rod] = flexibility;
            self.gain[rod] = stiffness * flexibility;
            self.slack[rod] = excess * flexibility;
            passed = pass_down(linkage.parent[rod], rod, stiffness * excess * flexibility, &mut self.excess);
        }
        not_positive
    }

    /// Newton's increment of every joint's deviation, written to `increment`, from the last elimination.
    /// Returns the largest turn of any rod. O(n).
    pub fn newton_step(&mut self, linkage: &Linkage, increment: &mut Vec<f64>) -> f64 {
        let residual = core::mem::take(&mut self.residual);
        let largest = self.solve(linkage, &residual, increment);
        self.residual = residual;
        largest
    }

    /// As [`Elimination::newton_step`], for another residual than the present state's.
    pub(super) fn solve(&mut self, linkage: &Linkage, residual: &[f64], increment: &mut Vec<f64>) -> f64 {
        let rods = linkage.len();
        self.carried.clear();
        self.carried.resize(rods, 0.0);
        increment.clear();
        increment.resize(rods, 0.0);
        self.turn.resize(rods, 0.0);
        // Slices of one length: their bounds are checked once.
        let (flexibility, gain, slack) = (&self.flexibility[..rods], &self.gain[..rods], &self.slack[..rods]);
        let (parent, residual) = (&linkage.parent[..rods], &residual[..rods]);
        let mut passed = 0.0;
        for rod in (0..rods).rev() {
            let carried = self.carried[rod] + passed;
            self.carried[rod] = carried;
            let share = slack[rod] * residual[rod] + gain[rod] * carried;
            passed = pass_down(parent[rod], rod, share, &mut self.carried);
        }
        let (carried, turn) = (&self.carried[..rods], &mut self.turn[..rods]);
        let mut last = 0.0;
        for rod in 0..rods {
            let below = match parent[rod] {
                GROUND => 0.0,
                bearer if bearer as usize + 1 == rod => last,
                bearer => turn[bearer as usize],
            };
            let step = (carried[rod] - residual[rod]) * flexibility[rod] - slack[rod] * below;
            last = below + step;
            increment[rod] = step;
            turn[rod] = last;
        }
        largest(turn)
    }

    /// Derivative of the energy along `increment`, at the last evaluated state.
    pub(super) fn slope(&self, increment: &[f64]) -> f64 {
        self.residual.iter().zip(increment).map(|(residual, step)| residual * step).sum()
    }
}

/// Largest size of the numbers; NaN when any is. Four maxima side by side: one would wait for itself.
fn largest(numbers: &[f64]) -> f64 {
    let larger = |a: f64, b: f64| if a > b || a.is_nan() { a } else { b };
    let mut chunks = numbers.chunks_exact(4);
    let mut lanes = [0.0_f64; 4];
    for chunk in &mut chunks {
        for (lane, number) in lanes.iter_mut().zip(chunk) {
            *lane = larger(*lane, number.abs());
        }
    }
    lanes.iter().chain(chunks.remainder()).fold(0.0, |most, number| larger(most, number.abs()))
}

/// Passes what a rod adds to its parent: as the result where the parent comes next, into the array elsewhere.
fn pass_down(parent: u32, rod: usize, share: f64, shares: &mut [f64]) -> f64 {
    if parent == GROUND {
        return 0.0;
    }
    if parent as usize + 1 == rod {
        return share;
    }
    shares[parent as usize] += share;
    0.0
}

/// Gradient of the energy in the rods' absolute angles, N m. O(n).
pub fn gradient(linkage: &Linkage, loads: &Loads) -> Vec<f64> {
    let mut state = Elimination::default();
    state.evaluate(linkage, loads);
    let mut gradient = state.residual.clone();
    for rod in 0..linkage.len() {
        if linkage.parent[rod] != GROUND {
            gradient[linkage.parent[rod] as usize] -= state.residual[rod];
        }
    }
    gradient
}
