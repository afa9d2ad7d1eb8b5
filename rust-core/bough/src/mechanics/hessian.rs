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

use alloc::vec::Vec;

use super::chain::{Chain, Parts, SHORTEST};
use super::levels::{Rows, Tree};
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::sweep::{self, largest};
use crate::trigonometry::{SMALL_TURN, sin_cos, sines_and_cosines, turn_sines_and_cosines};

/// How often sines and cosines are turned before they are computed anew: each turn adds a rounding.
const MOST_TURNS: u32 = 32;

/// Torques at one state, and the elimination of the Hessian there. Buffers are kept between uses.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Angle of each rod, radians, in the frame of the base direction.
    pub angle: Vec<f64>,
    /// External torque about each base joint, N m, counter-clockwise (equation 8).
    pub torque: Vec<f64>,
    /// Torque left over at each base joint: `kappa theta - torque` (equation 14 at rest).
    pub residual: Vec<f64>,
    largest_torque: f64,
    largest_residual: f64,
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
    /// By how much the last increment turned each rod.
    turn: Vec<f64>,
    next_angle: Vec<f64>,
    /// How often sines and cosines have been turned since they were computed.
    turns_taken: u32,
    increment: Vec<f64>,
    parts: Parts,
    rows: Rows,
}

impl Elimination {
    /// Torques and residuals at the linkage's present state. O(n).
    pub fn evaluate(&mut self, linkage: &Linkage, loads: &Loads) {
        linkage.angles(&mut self.angle);
        sines_and_cosines(&self.angle, &mut self.sine, &mut self.cosine);
        self.balance(linkage, loads);
    }

    /// As [`Elimination::evaluate`], right after [`Elimination::newton`] turned rods that were evaluated before, by at most
    /// `largest_turn`: small turns take fewer digits.
    pub(super) fn evaluate_turned(&mut self, linkage: &Linkage, loads: &Loads, largest_turn: f64) {
        // Written so that NaN takes the long way.
        if largest_turn <= SMALL_TURN {
            turn_sines_and_cosines(&self.turn, &mut self.sine, &mut self.cosine);
            for (angle, turn) in self.angle.iter_mut().zip(&self.turn) {
                *angle += turn;
            }
            self.balance(linkage, loads);
        } else {
            self.evaluate(linkage, loads);
        }
    }

    /// As [`Elimination::evaluate`], from the last state that was evaluated: rods that have turned little since then take
    /// fewer digits. New rods may have come. After [`MOST_TURNS`] such turns all is computed anew.
    pub(super) fn follow(&mut self, linkage: &Linkage, loads: &Loads) {
        let known = self.angle.len();
        if known == 0 || known > linkage.len() || self.turns_taken >= MOST_TURNS {
            self.turns_taken = 0;
            return self.evaluate(linkage, loads);
        }
        linkage.angles(&mut self.next_angle);
        self.turn.resize(known, 0.0);
        sweep::differences(&self.next_angle, &self.angle, &mut self.turn);
        let largest_turn = largest(&self.turn);
        if largest_turn.is_nan() || largest_turn > SMALL_TURN {
            self.turns_taken = 0;
            return self.evaluate(linkage, loads);
        }
        turn_sines_and_cosines(&self.turn, &mut self.sine, &mut self.cosine);
        for angle in &self.next_angle[known..] {
            let (sine, cosine) = sin_cos(*angle);
            self.sine.push(sine);
            self.cosine.push(cosine);
        }
        core::mem::swap(&mut self.angle, &mut self.next_angle);
        self.turns_taken += 1;
        self.balance(linkage, loads);
    }

    /// Lets [`Elimination::follow`] start anew.
    pub(super) fn forget(&mut self) {
        self.angle.clear();
        self.turns_taken = 0;
    }

    /// Torques and residuals from sines and cosines.
    fn balance(&mut self, linkage: &Linkage, loads: &Loads) {
        let rods = linkage.len();
        for array in [&mut self.torque, &mut self.residual, &mut self.geometric] {
            array.resize(rods, 0.0);
        }
        let torque = &mut self.torque[..];
        let loaded = [&linkage.length[..], &loads.x, &loads.y];
        sweep::torques(loaded, [&self.sine, &self.cosine], torque, &mut self.geometric);
        let mut passed = 0.0;
        if linkage.is_chain() {
            for torque in torque.iter_mut().rev() {
                passed += *torque;
                *torque = passed;
            }
        } else if linkage.has_wide_levels() {
            linkage.levels.gather(&linkage.parent, torque);
        } else {
            for rod in (0..rods).rev() {
                let sum = torque[rod] + passed;
                torque[rod] = sum;
                passed = pass_down(linkage.parent[rod], rod, sum, torque);
            }
        }
        sweep::residuals(&linkage.stiffness, &linkage.deviation, &self.torque, &mut self.residual);
        self.largest_torque = largest(&self.torque);
        self.largest_residual = largest(&self.residual);
    }

    /// Largest external torque, N m.
    pub fn largest_torque(&self) -> f64 {
        self.largest_torque
    }

    /// Largest torque left over, N m; NaN when any is.
    pub fn largest_residual(&self) -> f64 {
        self.largest_residual
    }

    /// Largest torque left over, relative to the largest external torque; 0 without load. Where the loads' torques cancel
    /// (a hair that is pulled straight), it is relative to the smallest torque that can be told from 0.
    pub fn relative_residual(&self) -> f64 {
        if self.largest_residual <= self.largest_torque {
            // Without load both are 0.
            return if self.largest_residual == 0.0 {
                0.0
            } else {
                self.largest_residual / self.largest_torque
            };
        }
        self.largest_residual / self.largest_torque.max(self.resolution())
    }

    /// Torque that rounding of the loads' own terms, and of the angles in them, makes, N m: where these terms cancel, those of
    /// the Hessian are as large.
    fn resolution(&self) -> f64 {
        let terms = self.geometric.iter().zip(&self.angle);
        f64::EPSILON * terms.map(|(term, angle)| term.abs() * (1.0 + angle.abs())).sum::<f64>()
    }

    /// Newton's step from the last evaluated state: adds its increment to every deviation. Returns how many pivots are not
    /// positive, and the largest turn of any rod. O(n).
    pub fn newton(&mut self, linkage: &mut Linkage) -> (u32, f64) {
        let rods = linkage.len();
        if rods >= SHORTEST && linkage.is_chain() {
            self.turn.resize(rods, 0.0);
            let Elimination { parts, geometric, residual, turn, .. } = self;
            let chain = Chain { stiffness: &linkage.stiffness, geometric, residual };
            if let Some(largest) = parts.newton(chain, &mut linkage.deviation, turn) {
                return (0, largest);
            }
        }
        if linkage.has_wide_levels() {
            self.turn.resize(rods, 0.0);
            let Elimination { rows, geometric, residual, turn, .. } = self;
            let Linkage { parent, stiffness, deviation, levels, .. } = linkage;
            let tree = Tree { parent, levels, stiffness, geometric, residual };
            if let Some(largest) = rows.newton(tree, deviation, turn) {
                return (0, largest);
            }
        }
        let not_positive = self.eliminate(linkage, 0.0);
        let mut increment = core::mem::take(&mut self.increment);
        let largest = self.newton_step(linkage, &mut increment);
        for (deviation, step) in linkage.deviation.iter_mut().zip(&increment) {
            *deviation += step;
        }
        self.increment = increment;
        (not_positive, largest)
    }

    /// Residual that round-off alone can leave: the torques that springs make of one rounding of an angle, and loads of theirs.
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
        8.0 * f64::EPSILON * largest + self.resolution()
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

    /// Sine and cosine of a rod's angle, at the last evaluated state.
    pub(super) fn sine_and_cosine(&self, rod: usize) -> (f64, f64) {
        (self.sine[rod], self.cosine[rod])
    }

    /// Derivative of the energy along `increment`, at the last evaluated state.
    pub(super) fn slope(&self, increment: &[f64]) -> f64 {
        self.residual.iter().zip(increment).map(|(residual, step)| residual * step).sum()
    }
}

/// Passes what a rod adds to its parent: as the result where the parent comes next, into the array elsewhere.
pub(crate) fn pass_down(parent: u32, rod: usize, share: f64, shares: &mut [f64]) -> f64 {
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
