//! Down in energy to a minimum, where the branch that led to the present shape has ended or is not stable.

use glam::DVec3;

use super::equilibrium::{NEUTRAL, TRUSTED_TURN, Workspace, energy_rounding, is_balanced};
use super::shape::{Rods, Shape};
use crate::mechanics::{GROUND, LEAN, Outcome, Status};

/// Iteration limit downhill, where convergence is not quadratic until the end.
const DESCENT_ITERATIONS: u32 = 200;
/// The same for a plant that has failed to find its equilibrium before: then no shape is truthful, and the steps must pass.
const WEARY_ITERATIONS: u32 = 5;
/// Most times that a step is shortened: a quarter each time, so that the last is a rounding.
const LINE_SEARCHES: u32 = 16;
/// Shifts of the Hessian's diagonal that are tried where it is not definite, from this one up, four times as much each.
const SMALLEST_SHIFT: f64 = 1.0 / 1_048_576.0;
/// With this shift the Hessian is positive definite: loads and commutators are outweighed.
const DEFINITE: f64 = 4.0;
/// Downhill, so many iterations without a smaller residual mean that rounding is all that is left,
const PATIENCE: u32 = 40;
/// where the residual is below this share of the largest torque: on the way down from a saddle it grows first.
const NEARLY: f64 = 1e-6;

impl Workspace {
    /// Goes down in energy to a minimum: Newton where the Hessian is positive definite, with its diagonal shifted until it is
    /// elsewhere, and a line search.
    pub(super) fn descend(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        force: &[DVec3],
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        let (mut previous, mut least, mut since) = (f64::INFINITY, f64::INFINITY, 0);
        outcome.status = Status::MaxIterations;
        for _ in 0..if self.is_weary { WEARY_ITERATIONS } else { DESCENT_ITERATIONS } {
            self.balance.orient(rods, shape);
            self.balance.weigh(rods, shape, force, NEUTRAL);
            outcome.residual = self.balance.relative_residual();
            if is_balanced(&self.balance, tolerance, previous) {
                outcome.unstable_directions = Some(self.balance.unstable);
                outcome.status = Status::Converged;
                return;
            }
            previous = self.balance.largest_residual;
            since = if previous < least || outcome.residual > NEARLY { 0 } else { since + 1 };
            least = least.min(previous);
            if since > PATIENCE || !previous.is_finite() {
                break;
            }
            let (energy, size) = (self.balance.energy, self.balance.energy_size);
            let allowed = energy + energy_rounding(size, rods.len());
            let mut shift = NEUTRAL;
            while self.balance.unstable > 0 && shift < DEFINITE {
                shift = f64::max(SMALLEST_SHIFT, 4.0 * shift);
                self.balance.weigh(rods, shape, force, shift);
            }
            outcome.iterations += 1;
            self.saved.clone_from(&shape.deviation);
            let mut scale = 1.0;
            for _ in 0..LINE_SEARCHES {
                let turn = self.balance.advance(rods, shape, scale);
                if turn <= TRUSTED_TURN {
                    self.balance.weigh(rods, shape, force, NEUTRAL);
                    if self.balance.energy <= allowed {
                        #[cfg(test)]
                        self.trace.push([energy, self.balance.energy, size]);
                        break;
                    }
                }
                scale *= if turn > TRUSTED_TURN { f64::max(1e-6, 0.9 * TRUSTED_TURN / turn) } else { 0.25 };
                shape.deviation.clone_from(&self.saved);
                self.balance.orient(rods, shape);
                self.balance.weigh(rods, shape, force, shift);
            }
        }
        if !outcome.residual.is_finite() {
            outcome.status = Status::NonFinite;
        }
        outcome.unstable_directions = None;
    }

    /// Past its critical load a straight stem is in balance and not stable. What breaks the balance in a real one is some
    /// imperfection; here every rod that stands on the ground is pushed down in its vertical plane by [`LEAN`] first. Bows that
    /// could fall over sideways stay in their plane, and are said not to be stable.
    pub(super) fn lean(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        force: &[DVec3],
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        self.balance.weigh(rods, shape, force, 0.0);
        if !self.balance.is_unbent() {
            return;
        }
        let upright = shape.deviation.clone();
        let found = *outcome;
        for (parent, deviation) in rods.parent.iter().zip(&mut shape.deviation) {
            if *parent == GROUND {
                deviation[2] -= LEAN;
            }
        }
        self.descend(rods, shape, force, tolerance, outcome);
        if outcome.status != Status::Converged {
            shape.deviation.clone_from(&upright);
            *outcome = Outcome { iterations: outcome.iterations, ..found };
        }
    }
}
