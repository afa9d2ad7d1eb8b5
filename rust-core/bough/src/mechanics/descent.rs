//! Down in energy to a minimum, where the branch that led to the present shape has ended.

use alloc::vec::Vec;

use super::equilibrium::{LEAN, TRUSTED_TURN, Workspace, add, balanced};
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::report::{Outcome, Status};
use crate::trigonometry::sin_cos;

/// Iteration limit downhill, where convergence is not quadratic until the end.
const DESCENT_ITERATIONS: u64 = 500;
/// The same for a plant that has failed to find its equilibrium before: then no shape is truthful, and the steps must pass.
const WEARY_ITERATIONS: u64 = 50;
/// Shifts of the Hessian's diagonal that are tried where it is not definite, from this one up, doubled.
pub(super) const SMALLEST_SHIFT: f64 = 1.0 / 1_048_576.0;
/// With this shift the Hessian is positive definite for certain: every negative term of the load is made positive.
pub(super) const DEFINITE: f64 = 1.0;
/// Downhill, so many iterations without a smaller residual mean that rounding is all that is left,
const PATIENCE: u64 = 40;
/// where the residual is below this share of the largest torque: on the way down from a saddle it grows first.
const NEARLY: f64 = 1e-6;

impl Workspace {
    /// Goes down in energy to a minimum: Newton where the Hessian is positive definite, with its diagonal
    /// shifted until it is elsewhere, and a line search.
    pub(super) fn descend(
        &mut self,
        linkage: &mut Linkage,
        loads: &Loads,
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        // What a whole step of Newton's method started from: a shortened one stalls for other reasons than rounding.
        let mut previous = f64::INFINITY;
        let (mut least, mut since) = (f64::INFINITY, 0);
        for _ in 0..if self.is_weary { WEARY_ITERATIONS } else { DESCENT_ITERATIONS } {
            self.state.evaluate(linkage, loads);
            let (done, residual) = balanced(&self.state, linkage, tolerance, previous);
            outcome.residual = residual;
            if done {
                outcome.unstable_directions = Some(self.state.eliminate(linkage, 0.0));
                outcome.status = Status::Converged;
                return;
            }
            if !self.may_iterate(linkage) {
                break;
            }
            let left = self.state.largest_residual();
            since = if left < least || outcome.residual > NEARLY { 0 } else { since + 1 };
            least = least.min(left);
            if since > PATIENCE {
                break;
            }
            let mut shift = 0.0;
            while self.state.eliminate(linkage, shift) > 0 && shift < DEFINITE {
                shift = f64::max(SMALLEST_SHIFT, 2.0 * shift);
            }
            outcome.iterations += 1;
            let turn = self.state.newton_step(linkage, &mut self.increment);
            if !turn.is_finite() {
                break;
            }
            let slope = self.state.slope(&self.increment);
            let [start, size] = energy_and_size(linkage, loads);
            // The energy is a sum of terms of this size, each rounded; near a critical load they nearly cancel.
            let rounding = 4.0 * f64::EPSILON * size;
            self.saved.clone_from(&linkage.deviation);
            let mut scale = f64::min(1.0, TRUSTED_TURN / turn);
            for _ in 0..40 {
                add(&mut linkage.deviation, &self.increment, scale);
                if energy(linkage, loads) <= start + 1e-4 * scale * slope + rounding {
                    break;
                }
                linkage.deviation.clone_from(&self.saved);
                scale *= 0.5;
            }
            previous = if shift == 0.0 && scale == 1.0 { left } else { f64::INFINITY };
        }
        let finite = outcome.residual.is_finite();
        outcome.status = if finite { Status::MaxIterations } else { Status::NonFinite };
        outcome.unstable_directions = None;
    }
}

impl Workspace {
    /// Past its critical load a straight stem is in balance and not stable. What breaks the balance in a real one is some
    /// imperfection; here every rod that stands on the ground is pushed by [`LEAN`] first, to the side to which its loads turn
    /// it, or else to that of [`Linkage::falls_left`]: so that what is mirrored is pushed to the other side.
    pub(super) fn lean(
        &mut self,
        linkage: &mut Linkage,
        loads: &Loads,
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        self.state.evaluate(linkage, loads);
        let rods = linkage.length.iter().zip(loads.x.iter().zip(&loads.y));
        let reach: f64 = rods.map(|(length, (x, y))| length * (x.abs() + y.abs())).sum();
        // What the loads bend has no side to choose.
        if self.state.largest_torque() > 1e-6 * reach {
            return;
        }
        let upright = linkage.deviation.clone();
        let found = *outcome;
        let torques = self.state.torque.iter();
        for ((parent, torque), deviation) in linkage.parent.iter().zip(torques).zip(&mut linkage.deviation) {
            if *parent == GROUND {
                let turns_left = if *torque == 0.0 { linkage.falls_left } else { *torque > 0.0 };
                *deviation += if turns_left { LEAN } else { -LEAN };
            }
        }
        self.descend(linkage, loads, tolerance, outcome);
        if outcome.status != Status::Converged {
            linkage.deviation.clone_from(&upright);
            *outcome = Outcome { iterations: outcome.iterations, ..found };
        }
    }
}

/// Energy of springs and loads, J; 0 for the straight chain at rest.
pub fn energy(linkage: &Linkage, loads: &Loads) -> f64 {
    energy_and_size(linkage, loads)[0]
}

/// The energy, and the sum of the sizes of its terms.
fn energy_and_size(linkage: &Linkage, loads: &Loads) -> [f64; 2] {
    let mut angle = Vec::with_capacity(linkage.len());
    linkage.angles(&mut angle);
    let (mut energy, mut size) = (0.0, 0.0);
    for (rod, &angle) in angle.iter().enumerate() {
        let (sin, cos) = sin_cos(angle);
        let spring = 0.5 * linkage.stiffness[rod] * linkage.deviation[rod] * linkage.deviation[rod];
        let lifted = linkage.length[rod] * (loads.x[rod] * (1.0 - cos) - loads.y[rod] * sin);
        energy += spring + lifted;
        size += spring + lifted.abs();
    }
    [energy, size]
}
