//! Down in energy to a minimum, where the branch that led to the present shape has ended or is not stable.

use glam::DVec3;

use super::balance::Damping;
use super::equilibrium::{NEUTRAL, TRUSTED_TURN, Workspace, energy_rounding, is_balanced};
use super::shape::{Rods, Shape};
use crate::mechanics::{GROUND, LEAN, Outcome, Status};

/// Iteration limit downhill, where convergence is not quadratic until the end.
const DESCENT_ITERATIONS: u32 = 200;
/// The same for a plant that has failed to find its equilibrium before: then no shape is truthful, and the steps must pass.
const WEARY_ITERATIONS: u32 = 5;
/// Most times that a step is taken back: at the ladder's end it is a quarter each time, so that the last is a rounding.
const LINE_SEARCHES: u32 = 32;
/// What is added where the Hessian is not definite, from the least to what always suffices.
const LADDER: [Damping; 9] = [
    NEUTRAL,
    Damping { caution: 1.0 / 16.0, ..NEUTRAL },
    Damping { caution: 0.25, ..NEUTRAL },
    Damping { caution: 1.0, ..NEUTRAL },
    Damping { caution: 1.0, shift: 1.0 / 64.0 },
    Damping { caution: 1.0, shift: 1.0 / 16.0 },
    Damping { caution: 1.0, shift: 0.25 },
    Damping { caution: 1.0, shift: 1.0 },
    Damping { caution: 1.0, shift: 4.0 },
];
/// Downhill, so many iterations without a smaller residual mean that rounding is all that is left,
const PATIENCE: u32 = 40;
/// where the residual is below this share of the largest torque: on the way down from a saddle it grows first.
const NEARLY: f64 = 1e-6;

impl Workspace {
    /// Goes down in energy to a minimum: Newton's method, with so much added to the Hessian that it is positive definite, and that no
    /// step raises the energy. No rod turns far at once, and those that it bears step as fits what it turns: of a
    /// hundred thousand twigs some always would, and all others need not wait for them.
    pub(super) fn descend(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        force: &[DVec3],
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        // What a whole step of Newton's method started from: any other one stalls for other reasons than rounding.
        let mut previous = f64::INFINITY;
        let (mut least, mut since) = (f64::INFINITY, 0);
        let mut rung = 0_usize;
        outcome.status = Status::MaxIterations;
        self.balance.orient(rods, shape);
        self.balance.weigh(rods, shape, force, NEUTRAL);
        for _ in 0..if self.is_weary { WEARY_ITERATIONS } else { DESCENT_ITERATIONS } {
            outcome.residual = self.balance.relative_residual();
            if is_balanced(&self.balance, tolerance, previous) {
                outcome.unstable_directions = Some(self.balance.unstable);
                outcome.status = Status::Converged;
                return;
            }
            let left = self.balance.largest_residual;
            since = if left < least || outcome.residual > NEARLY { 0 } else { since + 1 };
            least = least.min(left);
            if since > PATIENCE || !left.is_finite() {
                break;
            }
            let (energy, size) = (self.balance.energy, self.balance.energy_size);
            let allowed = energy + energy_rounding(size, rods.len());
            // From a little less than what the last step needed.
            rung = if self.balance.unstable > 0 { rung.saturating_sub(2) } else { 0 };
            while self.balance.unstable > 0 && rung + 1 < LADDER.len() {
                rung += 1;
                self.balance.weigh(rods, shape, force, LADDER[rung]);
            }
            outcome.iterations += 1;
            self.saved.clone_from(&shape.deviation);
            let mut scale = 1.0;
            let falls = (0..LINE_SEARCHES).any(|_| {
                self.balance.advance(rods, shape, scale, TRUSTED_TURN);
                self.balance.weigh(rods, shape, force, NEUTRAL);
                if self.balance.energy <= allowed {
                    return true;
                }
                if rung + 1 < LADDER.len() {
                    rung += 1;
                } else {
                    scale *= 0.25;
                }
                shape.deviation.clone_from(&self.saved);
                self.balance.orient(rods, shape);
                self.balance.weigh(rods, shape, force, LADDER[rung]);
                false
            });
            if !falls {
                break;
            }
            previous = if rung == 0 && scale == 1.0 { left } else { f64::INFINITY };
            #[cfg(test)]
            self.trace.push([energy, self.balance.energy, size]);
        }
        if !outcome.residual.is_finite() {
            outcome.status = Status::NonFinite;
        }
        outcome.unstable_directions = None;
    }

    /// Past its critical load a straight stem is in balance and not stable. What breaks the balance in a real one is some
    /// imperfection; here every rod that stands on the ground is pushed in its vertical plane by [`LEAN`] first, to the side to
    /// which its loads turn it; where that is but a rounding of theirs, down, and if it is upright or hangs to the side of its
    /// azimuth. Bows that could fall over sideways stay in their plane, and are said not to be stable.
    pub(super) fn lean(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        force: &[DVec3],
        tolerance: f64,
        outcome: &mut Outcome,
    ) {
        self.balance.weigh(rods, shape, force, Damping::default());
        if !self.balance.is_unbent() {
            return;
        }
        let upright = shape.deviation.clone();
        let found = *outcome;
        for (rod, deviation) in shape.deviation.iter_mut().enumerate() {
            if rods.parent[rod] == GROUND {
                let falls_left = self.balance.falls_left(rods, force, rod);
                deviation[2] += if falls_left { LEAN } else { -LEAN };
            }
        }
        self.descend(rods, shape, force, tolerance, outcome);
        if outcome.status != Status::Converged {
            shape.deviation.clone_from(&upright);
            *outcome = Outcome { iterations: outcome.iterations, ..found };
        }
    }
}
