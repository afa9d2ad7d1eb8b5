//! Equilibrium by Newton's method, on the branch that growth, or a load raised from zero, leads to.
//!
//! Heavy and steep rods have several equilibria, and stability does not tell the physical one from the others.
//! So a step that turns any rod far, or that meets an indefinite Hessian, is not trusted: the load is then
//! raised in parts, each short enough to stay on the branch. Only where the branch itself ends (the plant
//! would snap over) does the search go downhill in energy to the next minimum.

use super::hessian::Elimination;
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::report::{Outcome, Status};
use crate::trigonometry::sin_cos;

/// How far any rod may turn, in radians, in one trusted search: a fraction of the distance between branches.
const TRUSTED_TURN: f64 = 0.5;
/// Newton converges quadratically from a trusted start, so more iterations than this mean that it was not one.
const TRUSTED_ITERATIONS: u64 = 12;
/// Smallest part of a load that is tried before the branch counts as ended.
const SMALLEST_SHARE: f64 = 1e-16;
/// Balance that is enough on the way, before the whole load is on.
const ON_THE_WAY: f64 = 1e-3;
/// Iteration limit downhill, where convergence is not quadratic until the end.
const DESCENT_ITERATIONS: u64 = 500;
/// Shifts of the Hessian's diagonal that are tried where it is not definite, from this one up, doubled.
pub(super) const SMALLEST_SHIFT: f64 = 1.0 / 1024.0;
/// With this shift the Hessian is positive definite for certain: every negative term of the load is made positive.
pub(super) const DEFINITE: f64 = 1.0;
/// Downhill, so many iterations without a smaller residual mean that rounding is all that is left.
const PATIENCE: u64 = 40;

/// What counts as equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Largest torque that may be left over at a joint, relative to the largest external torque.
    pub tolerance: f64,
}

/// The search's buffers, kept between growth steps so that none is allocated in the loop.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    pub(super) state: Elimination,
    increment: Vec<f64>,
    saved: Vec<f64>,
    partial: Loads,
}

enum Attempt {
    Converged,
    Distrusted,
}

/// Whether the torques just evaluated are balanced, and the relative residual.
///
/// Round-off leaves a residual that no iteration removes; it is accepted only once iterating has stopped
/// to help, so that the tolerance is met wherever the arithmetic allows.
fn balanced(state: &Elimination, linkage: &Linkage, tolerance: f64, previous: f64) -> (bool, f64) {
    let torque = state.largest_torque();
    let left = state.largest_residual();
    let relative = if left == 0.0 { 0.0 } else { left / torque };
    let stalled = left >= 0.5 * previous && left <= state.round_off(linkage);
    (left <= tolerance * torque || stalled, relative)
}

impl Workspace {
    /// Newton's method from the present state. `limit` bounds the sum of the largest turns.
    fn attempt(
        &mut self,
        linkage: &mut Linkage,
        loads: &Loads,
        tolerance: f64,
        limit: f64,
        outcome: &mut Outcome,
    ) -> Attempt {
        let mut turned = 0.0;
        let mut previous = f64::INFINITY;
        for iteration in 0..=TRUSTED_ITERATIONS {
            self.state.evaluate(linkage, loads);
            let (done, residual) = balanced(&self.state, linkage, tolerance, previous);
            outcome.residual = residual;
            if done {
                if iteration == 0 {
                    outcome.unstable_directions = Some(self.state.eliminate(linkage, 0.0));
                }
                return Attempt::Converged;
            }
            previous = self.state.largest_residual();
            let unstable = self.state.eliminate(linkage, 0.0);
            outcome.iterations += 1;
            outcome.unstable_directions = Some(unstable);
            turned += self.state.newton_step(linkage, &mut self.increment);
            let trusted = turned <= limit && (unstable == 0 || limit.is_infinite());
            if !trusted {
                return Attempt::Distrusted;
            }
            add(&mut linkage.deviation, &self.increment, 1.0);
        }
        Attempt::Distrusted
    }

    /// Raises the load from `before`, with which the linkage is in equilibrium, to `after`, in parts.
    /// Returns whether the whole load is on.
    fn raise(
        &mut self,
        linkage: &mut Linkage,
        before: &Loads,
        after: &Loads,
        tolerance: f64,
        outcome: &mut Outcome,
    ) -> bool {
        let mut partial = core::mem::take(&mut self.partial);
        let (mut share, mut part) = (0.0, 0.25);
        while share < 1.0 && part > SMALLEST_SHARE {
            let next = f64::min(1.0, share + part);
            let tolerance = if next < 1.0 { f64::max(tolerance, ON_THE_WAY) } else { tolerance };
            partial.blend(before, after, next);
            self.saved.clone_from(&linkage.deviation);
            match self.attempt(linkage, &partial, tolerance, TRUSTED_TURN, outcome) {
                Attempt::Converged => {
                    share = next;
                    part *= 2.0;
                }
                Attempt::Distrusted => {
                    linkage.deviation.clone_from(&self.saved);
                    part *= 0.25;
                }
            }
        }
        self.partial = partial;
        share >= 1.0
    }

    /// Goes down in energy to a minimum: Newton where the Hessian is positive definite, with its diagonal
    /// shifted until it is elsewhere, and a line search.
    fn descend(&mut self, linkage: &mut Linkage, loads: &Loads, tolerance: f64, outcome: &mut Outcome) {
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

pub(super) fn add(deviation: &mut [f64], increment: &[f64], scale: f64) {
    for (deviation, step) in deviation.iter_mut().zip(increment) {
        *deviation += scale * step;
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

/// Brings a linkage that is in equilibrium with `before` to equilibrium with `after`. Rods that `before` does
/// not know yet carried nothing until now. O(n) an iteration; one to three iterations in a usual growth step.
///
/// `guess` is by how much the first deviations are expected to change, from whatever is known; a good one saves
/// iterations, a bad one is dropped.
///
/// On [`Status::NonFinite`] the linkage is left as it was.
pub fn settle(
    linkage: &mut Linkage,
    before: &Loads,
    after: &Loads,
    guess: &[f64],
    settings: Settings,
    workspace: &mut Workspace,
) -> Outcome {
    let mut outcome = Outcome::default();
    let start = linkage.deviation.clone();
    let guesses: &[&[f64]] = if guess.is_empty() { &[&[]] } else { &[guess, &[]] };
    for guess in guesses {
        add(&mut linkage.deviation, guess, 1.0);
        let limit = TRUSTED_TURN - largest_turn(linkage, guess);
        match workspace.attempt(linkage, after, settings.tolerance, limit, &mut outcome) {
            Attempt::Converged => return outcome,
            Attempt::Distrusted => linkage.deviation.clone_from(&start),
        }
    }
    if !workspace.raise(linkage, before, after, settings.tolerance, &mut outcome) {
        workspace.descend(linkage, after, settings.tolerance, &mut outcome);
    }
    if outcome.status == Status::NonFinite {
        linkage.deviation = start;
    }
    outcome
}

/// Largest turn of any rod that these changes of the first deviations make together, radians.
pub(super) fn largest_turn(linkage: &Linkage, change: &[f64]) -> f64 {
    let mut turn: Vec<f64> = Vec::with_capacity(change.len());
    let mut largest = 0.0_f64;
    for (rod, step) in change.iter().enumerate() {
        let below = if linkage.parent[rod] == GROUND { 0.0 } else { turn[linkage.parent[rod] as usize] };
        turn.push(below + step);
        largest = largest.max((below + step).abs());
    }
    largest
}

/// The equilibrium that is reached from the unloaded shape when all loads are raised together from zero.
pub fn hang(linkage: &mut Linkage, loads: &Loads, settings: Settings) -> Outcome {
    linkage.deviation.fill(0.0);
    settle(linkage, &Loads::none(0), loads, &[], settings, &mut Workspace::default())
}

/// Newton's method from the present state and nothing else: finds whatever equilibrium is next to it, stable
/// or not. For looking at the other equilibria; growth never uses it.
pub fn polish(linkage: &mut Linkage, loads: &Loads, settings: Settings) -> Outcome {
    let mut outcome = Outcome::default();
    let mut workspace = Workspace::default();
    match workspace.attempt(linkage, loads, settings.tolerance, f64::INFINITY, &mut outcome) {
        Attempt::Converged => {
            outcome.unstable_directions = Some(workspace.state.eliminate(linkage, 0.0));
        }
        Attempt::Distrusted => outcome.status = Status::MaxIterations,
    }
    outcome
}
