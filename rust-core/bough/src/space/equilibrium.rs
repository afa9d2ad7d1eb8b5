//! Equilibrium in space by Newton's method, on the branch that growth, or a load raised from zero, leads to.
//!
//! As in the plane ([`crate::mechanics`]): a step that turns any rod far, meets an indefinite Hessian or raises the energy
//! is not trusted; the load is then raised in parts. Only where the branch ends the search goes downhill.

use alloc::vec::Vec;

use glam::DVec3;

use super::balance::{Balance, Damping};
use super::shape::{Rods, Shape};
use crate::mechanics::{Outcome, Settings, Status};

/// How far any rod may turn, in radians, in one trusted search that meets definite Hessians only: a fraction of the distance
/// between branches. Twice what the plane trusts: of the hundred thousand twigs of a tree one always turns far.
pub(super) const TRUSTED_TURN: f64 = 1.0;
/// How far the load is raised at once: a little less than what is trusted.
const FITTING_TURN: f64 = 0.8;
/// Turn in one step after which the Hessian is not eliminated again unless more steps are due, radians.
const NEAR: f64 = 0.01;
/// Newton converges quadratically from a trusted start, so more iterations than this mean that it was not one.
const TRUSTED_ITERATIONS: u32 = 12;
/// Smallest part of a load that is tried before the branch counts as ended.
const SMALLEST_SHARE: f64 = 1e-12;
/// Most parts of a load that are tried, for the same reason.
const MOST_PARTS: u32 = 40;
/// While the shape goes on changing as it does, a part adds more than this share to the load that is on.
const STEADY: f64 = 0.2;
/// Balance that is enough on the way, before the whole load is on.
const ON_THE_WAY: f64 = 0.2;

/// A direction in which the energy falls by less than this share of the loads' and springs' torques is neutral: an upright stem
/// that leans could as well lean to any other side. So much is added to the Hessian, which keeps the shape from wandering off
/// and costs Newton's method a millionth of its step at most where a mode is a thousand times softer than the loads.
pub const NEUTRAL: Damping = Damping { shift: 1e-9, caution: 0.0 };

/// The search's buffers, kept between growth steps.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    pub(super) balance: Balance,
    /// Whether no equilibrium was found before, so that not much is tried again.
    pub(crate) is_weary: bool,
    /// The deviations at the last start.
    pub(crate) start: Vec<[f64; 3]>,
    pub(super) saved: Vec<[f64; 3]>,
    change: Vec<f64>,
    partial: Vec<DVec3>,
    /// Of each accepted iteration at constant load: the energy before and after, and the sum of the sizes of its terms.
    #[cfg(test)]
    pub(super) trace: Vec<[f64; 3]>,
}

/// How an attempt ended, and the sum of the largest turns until then, radians.
enum Attempt {
    Converged(f64),
    Distrusted(f64),
}

/// By how much rounding may raise the energy, a sum of terms of this size together: each term is rounded some thirty
/// times (in turning its rod, and its bearer), and the sum as often as there are terms, of which the errors add up like a
/// random walk.
pub(super) fn energy_rounding(size: f64, terms: usize) -> f64 {
    f64::EPSILON * (32.0 + libm::sqrt(terms as f64)) * size
}

/// Whether the torques just weighed are balanced. What rounding leaves over counts only once iterating has stopped to
/// help, and where the loads bend nothing.
pub(super) fn is_balanced(balance: &Balance, tolerance: f64, previous: f64) -> bool {
    let left = balance.largest_residual;
    let stalled = left >= 0.5 * previous || balance.is_unbent();
    left <= tolerance * balance.largest_torque || (stalled && left <= balance.round_off)
}

impl Workspace {
    /// Newton's method from the present state. A shape whose state is distrusted is left where that was seen.
    fn attempt(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        force: &[DVec3],
        tolerance: f64,
        limit: f64,
        outcome: &mut Outcome,
    ) -> Attempt {
        let (mut turned, mut last, mut previous) = (0.0, f64::INFINITY, f64::INFINITY);
        let mut before = None;
        self.balance.orient(rods, shape);
        for _ in 0..=TRUSTED_ITERATIONS {
            // So near to a state whose Hessian is definite the torques are enough to see.
            let is_near = last <= NEAR;
            if is_near {
                self.balance.look(rods, shape, force);
            } else {
                self.balance.weigh(rods, shape, force, NEUTRAL);
            }
            let (energy, size) = (self.balance.energy, self.balance.energy_size);
            if before.is_some_and(|before| energy > before + energy_rounding(size, rods.len())) {
                break;
            }
            #[cfg(test)]
            self.trace.extend(before.map(|before| [before, energy, size]));
            outcome.residual = self.balance.relative_residual();
            outcome.unstable_directions = Some(self.balance.unstable);
            // The largest torque says nothing of a twig's: on the way every guess is corrected once.
            let is_guessed = tolerance >= ON_THE_WAY && before.is_none();
            if !is_guessed && is_balanced(&self.balance, tolerance, previous) {
                return Attempt::Converged(turned);
            }
            if is_near {
                self.balance.weigh(rods, shape, force, NEUTRAL);
            }
            if self.balance.unstable > 0 {
                break;
            }
            before = Some(energy);
            previous = self.balance.largest_residual;
            last = self.balance.advance(rods, shape, 1.0, f64::INFINITY);
            turned += last;
            outcome.iterations += 1;
            if turned.is_nan() || turned > limit {
                break;
            }
        }
        Attempt::Distrusted(turned)
    }

    /// Raises the load from `before`, with which the rods are in equilibrium, to `after`, in parts that turn no rod too far;
    /// `expected` is about how far the whole load would. Returns whether the whole load is on.
    fn raise(
        &mut self,
        rods: Rods,
        shape: &mut Shape,
        [before, after]: [&[DVec3]; 2],
        expected: f64,
        tolerance: f64,
        outcome: &mut Outcome,
    ) -> bool {
        let fitting = |turned: f64, most: f64| match FITTING_TURN / turned {
            times if times <= most => f64::max(0.02, times),
            _ => most,
        };
        let mut partial = core::mem::take(&mut self.partial);
        let (mut share, mut part) = (0.0, fitting(expected, 0.5));
        let mut last_part = f64::INFINITY;
        self.change.clear();
        let mut parts = 0;
        while share < 1.0 && part > SMALLEST_SHARE && parts < MOST_PARTS {
            parts += 1;
            if part < STEADY * share && 1.0 - share > part * f64::from(MOST_PARTS - parts) {
                // At this pace the parts do not suffice, and the pace grows no more.
                break;
            }
            let next = f64::min(1.0, share + part);
            let tolerance = if next < 1.0 { f64::max(tolerance, ON_THE_WAY) } else { tolerance };
            partial.clear();
            let earlier = before.iter().copied().chain(core::iter::repeat(DVec3::ZERO));
            partial.extend(after.iter().zip(earlier).map(|(after, before)| before.lerp(*after, next)));
            self.saved.clone_from(&shape.deviation);
            // As the last part bent it, this one will.
            let scale = (next - share) / last_part;
            self.change.iter_mut().for_each(|change| *change *= scale);
            add(shape, &self.change);
            let guessed = largest_turn(rods, &self.change);
            // Along the branch the guess is trusted: what counts is how far it was off.
            let limit = TRUSTED_TURN;
            match self.attempt(rods, shape, &partial, tolerance, limit, outcome) {
                Attempt::Converged(turned) if next == 1.0 || self.balance.unstable == 0 => {
                    last_part = next - share;
                    share = next;
                    part = last_part * fitting(guessed + turned, 3.0);
                    self.change.clear();
                    let (after, before) = (shape.deviation.as_flattened(), self.saved.as_flattened());
                    self.change.extend(after.iter().zip(before).map(|(after, before)| after - before));
                }
                Attempt::Converged(turned) | Attempt::Distrusted(turned) => {
                    shape.deviation.clone_from(&self.saved);
                    last_part = f64::INFINITY;
                    self.change.clear();
                    part *= fitting(guessed + turned, 0.25);
                }
            }
        }
        self.partial = partial;
        share >= 1.0
    }
}

/// Adds changes to the first deviations.
fn add(shape: &mut Shape, changes: &[f64]) {
    let deviations = shape.deviation.as_flattened_mut().iter_mut();
    for (deviation, change) in deviations.zip(changes) {
        *deviation += change;
    }
}

/// Bound of the turn of any rod that these changes of the first deviations make together, radians.
fn largest_turn(rods: Rods, changes: &[f64]) -> f64 {
    let mut turn: Vec<DVec3> = Vec::with_capacity(changes.len() / 3);
    let mut largest = 0.0_f64;
    for (rod, change) in changes.chunks_exact(3).enumerate() {
        let below = turn.get(rods.parent[rod] as usize).copied().unwrap_or(DVec3::ZERO);
        let own = below + DVec3::from_slice(change);
        largest = largest.max(own.length());
        turn.push(own);
    }
    largest
}

/// Brings rods that are in equilibrium with the forces `before` to equilibrium with `after`: for each rod the sum of the
/// forces at its distal end and beyond, N. Rods that `before` does not know yet carried nothing until now. O(n) an
/// iteration.
///
/// `guess` is by how much the first deviations are expected to change; a bad one is dropped. Where the equilibrium that is
/// found is not stable the plant leans: see [`crate::mechanics::LEAN`].
///
/// On [`Status::NonFinite`] the shape is left as it was.
pub fn settle(
    rods: Rods,
    shape: &mut Shape,
    before: &[DVec3],
    after: &[DVec3],
    guess: &[f64],
    settings: Settings,
    workspace: &mut Workspace,
) -> Outcome {
    let mut outcome = Outcome::default();
    let tolerance = settings.tolerance;
    let mut start = core::mem::take(&mut workspace.start);
    start.clone_from(&shape.deviation);
    let guesses: &[&[f64]] = if guess.is_empty() { &[&[]] } else { &[guess, &[]] };
    let mut expected = 0.0;
    let balanced = guesses.iter().any(|guess| {
        add(shape, guess);
        let limit = TRUSTED_TURN - largest_turn(rods, guess);
        let attempt = workspace.attempt(rods, shape, after, tolerance, limit, &mut outcome);
        if let Attempt::Distrusted(turned) = attempt {
            shape.deviation.clone_from(&start);
            expected = turned;
        }
        matches!(attempt, Attempt::Converged(_))
    });
    if !balanced
        && (workspace.is_weary
            || !workspace.raise(rods, shape, [before, after], expected, tolerance, &mut outcome))
    {
        workspace.descend(rods, shape, after, tolerance, &mut outcome);
    }
    if outcome.status == Status::Converged && outcome.unstable_directions.is_some_and(|count| count > 0) {
        workspace.lean(rods, shape, after, tolerance, &mut outcome);
    }
    if outcome.status == Status::NonFinite {
        shape.deviation.clone_from(&start);
    }
    workspace.start = start;
    outcome
}
