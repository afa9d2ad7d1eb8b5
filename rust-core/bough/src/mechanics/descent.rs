//! Down in energy to a minimum, where the branch that led to the present shape has ended.

use alloc::vec::Vec;

use super::equilibrium::{TRUSTED_TURN, Workspace, add, balanced};
use super::linkage::Linkage;
use super::loads::Loads;
use super::report::{Outcome, Status};
use crate::trigonometry::sin_cos;

/// Iteration limit downhill, where convergence is not quadratic until the end.
const DESCENT_ITERATIONS: u64 = 500;
/// Shifts of the Hessian's diagonal that are tried where it is not definite, from this one up, doubled.
pub(super) const SMALLEST_SHIFT: f64 = 1.0 / 1024.0;
/// With this shift the Hessian is positive definite for certain: every negative term of the load is made positive.
pub(super) const DEFINITE: f64 = 1.0;
/// Downhill, so many iterations without a smaller residual mean that rounding is all that is left.
const PATIENCE: u64 = 40;

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
        let mut previous = f64::INFINITY;
        let (mut least, mut since) = (f64::INFINITY, 0);
        for _ in 0..DESCENT_ITERATIONS {
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
            previous = self.state.largest_residual();
            since = if previous < least { 0 } else { since + 1 };
            least = least.min(previous);
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
            let start = energy(linkage, loads);
            // The energy is a sum of terms of this size, each rounded.
            let rounding = 4.0 * f64::EPSILON * start.abs().max(slope.abs());
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
        }
        let finite = outcome.residual.is_finite();
        outcome.status = if finite { Status::MaxIterations } else { Status::NonFinite };
        outcome.unstable_directions = None;
    }
}

/// Energy of springs and loads, J; 0 for the straight chain at rest.
pub fn energy(linkage: &Linkage, loads: &Loads) -> f64 {
    let mut angle = Vec::with_capacity(linkage.len());
    linkage.angles(&mut angle);
    let mut energy = 0.0;
    for (rod, &angle) in angle.iter().enumerate() {
        let (sin, cos) = sin_cos(angle);
        let spring = 0.5 * linkage.stiffness[rod] * linkage.deviation[rod] * linkage.deviation[rod];
        let lifted = linkage.length[rod] * (loads.x[rod] * (1.0 - cos) - loads.y[rod] * sin);
        energy += spring + lifted;
    }
    energy
}
