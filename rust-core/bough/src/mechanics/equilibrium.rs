//! Equilibrium by Newton's method, on the branch that growth, or a load raised from zero, leads to.
//!
//! Heavy and steep rods have several equilibria, and stability does not tell the physical one from the others.
//! So a step that turns any rod far, or that meets an indefinite Hessian, is not trusted: the load is then
//! raised in parts, each short enough to stay on the branch. Only where the branch itself ends (the plant
//! would snap over) does the search go downhill in energy to the next minimum.

use alloc::boxed::Box;
use alloc::vec::Vec;

use super::coarse::{Coarse, FEWEST};
use super::hessian::Elimination;
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;
use super::report::{Outcome, Status};

/// How far any rod may turn, in radians, in one trusted search: a fraction of the distance between branches.
pub(crate) const TRUSTED_TURN: f64 = 0.5;
/// How far the load is raised at once: a little less than what is trusted.
const FITTING_TURN: f64 = 0.4;
/// Newton converges quadratically from a trusted start, so more iterations than this mean that it was not one.
const TRUSTED_ITERATIONS: u64 = 12;
/// Smallest part of a load that is tried before the branch counts as ended.
const SMALLEST_SHARE: f64 = 1e-16;
/// Most parts of a load that are tried, for the same reason.
const MOST_PARTS: u32 = 100;
/// Balance that is enough on the way, before the whole load is on.
const ON_THE_WAY: f64 = 1e-2;
/// Balance of a coarser cut that is enough to start a finer one from: the cut itself leaves about as much over.
const ENOUGH_FOR_A_START: f64 = 1e-3;

/// By how much a plant that is in unstable balance is pushed at its base, radians, to the side to which its loads turn it; where
/// they turn it to neither, down, and if it is upright or hangs to the side of its azimuth (+x in the plane): the imperfection
/// that decides where a stem past its critical height leans. Where it comes to rest there does not depend on it.
pub const LEAN: f64 = 1e-3;

/// After a turn so small (radians), what is left over may be proven small instead of being evaluated,
const PROVABLE_TURN: f64 = 1e-3;
/// where the tolerance is far above the rounding of the linear solution,
const PROVABLE_TOLERANCE: f64 = 1e-12;
/// and the proven bound far below the tolerance.
const PROVABLE_SHARE: f64 = 0.5;

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
    pub(super) increment: Vec<f64>,
    /// The deviations at the last start.
    pub(crate) start: Vec<f64>,
    pub(super) saved: Vec<f64>,
    turn: Vec<f64>,
    partial: Loads,
    /// Iterations times rods that a search may still take before it is given up; no limit if there is none.
    pub(crate) allowance: Option<u64>,
    /// Whether no equilibrium was found before, so that less is tried again.
    pub(crate) is_weary: bool,
    /// For a coarser cut of the same chain.
    coarser: Option<Box<(Coarse, Workspace)>>,
}

/// How an attempt ended, and the sum of the largest turns until then, radians.
enum Attempt {
    Converged(f64),
    Distrusted(f64),
}

/// Bound of the torque that is left over after a step of Newton's method that turned no rod by more than `turn`: what a
/// load's torque `t` on a rod has beyond its linear part is `t (cos u - 1) - h (sin u - u)`, with `t` and `h` at
/// most length times force (Taylor). And bound of the torque that such a turn takes away.
fn remainder(linkage: &Linkage, loads: &Loads, turn: f64) -> (f64, f64) {
    let rods = linkage.len();
    let (length, x, y) = (&linkage.length[..rods], &loads.x[..rods], &loads.y[..rods]);
    let mut sums = [0.0_f64; 4];
    let whole = rods - rods % 4;
    for first in (0..whole).step_by(4) {
        for lane in 0..4 {
            sums[lane] += length[first + lane] * (x[first + lane].abs() + y[first + lane].abs());
        }
    }
    let rest: f64 = (whole..rods).map(|rod| length[rod] * (x[rod].abs() + y[rod].abs())).sum();
    let load = sums.iter().sum::<f64>() + rest;
    (load * turn * turn * (0.5 + turn / 6.0), load * turn)
}

/// Whether the torques just evaluated are balanced, and the relative residual.
///
/// Round-off leaves a residual that no iteration removes; it is accepted only once iterating has stopped
/// to help, so that the tolerance is met wherever the arithmetic allows.
pub(super) fn balanced(state: &Elimination, linkage: &Linkage, tolerance: f64, previous: f64) -> (bool, f64) {
    let torque = state.largest_torque();
    let left = state.largest_residual();
    let relative = state.relative_residual();
    let stalled = left >= 0.5 * previous && left <= state.round_off(linkage);
    (left <= tolerance * torque || stalled, relative)
}

impl Workspace {
    /// Takes no advantage of the state that was evaluated last: from here on the same bits follow, whatever was before.
    pub(crate) fn forget(&mut self) {
        self.state.forget();
    }

    /// Whether the allowance has one more iteration, which is taken off it.
    pub(super) fn may_iterate(&mut self, linkage: &Linkage) -> bool {
        let rods = linkage.len() as u64;
        match &mut self.allowance {
            None => true,
            Some(left) if *left >= rods => {
                *left -= rods;
                true
            }
            Some(left) => {
                *left = 0;
                false
            }
        }
    }

    /// Whether the search was given up.
    fn is_spent(&self) -> bool {
        self.allowance == Some(0)
    }

    /// Newton's method from the present state. `limit` bounds the sum of the largest turns. A linkage whose state is
    /// distrusted is left where that was seen.
    fn attempt(
        &mut self,
        linkage: &mut Linkage,
        loads: &Loads,
        tolerance: f64,
        limit: f64,
        outcome: &mut Outcome,
    ) -> Attempt {
        let (mut turned, mut turn) = (0.0, f64::INFINITY);
        let mut previous = f64::INFINITY;
        for iteration in 0..=TRUSTED_ITERATIONS {
            if iteration == 0 && tolerance >= PROVABLE_TOLERANCE {
                self.state.follow(linkage, loads);
            } else {
                self.state.evaluate_turned(linkage, loads, turn);
            }
            let (done, residual) = balanced(&self.state, linkage, tolerance, previous);
            outcome.residual = residual;
            if done {
                if iteration == 0 {
                    outcome.unstable_directions = Some(self.state.eliminate(linkage, 0.0));
                }
                return Attempt::Converged(turned);
            }
            if !self.may_iterate(linkage) {
                return Attempt::Distrusted(turned);
            }
            previous = self.state.largest_residual();
            let unstable;
            (unstable, turn) = self.state.newton(linkage);
            outcome.iterations += 1;
            outcome.unstable_directions = Some(unstable);
            turned += turn;
            let trusted = turned <= limit && (unstable == 0 || limit.is_infinite());
            if !trusted {
                return Attempt::Distrusted(turned);
            }
            if turn <= PROVABLE_TURN && tolerance >= PROVABLE_TOLERANCE {
                let (bound, lost) = remainder(linkage, loads, turn);
                // The torques are those of before the turn, which may have taken most of them away.
                let torque = (self.state.largest_torque() - lost).max(0.0);
                if bound <= PROVABLE_SHARE * tolerance * torque {
                    // Without any load both are 0.
                    outcome.residual = if bound == 0.0 { 0.0 } else { bound / torque };
                    return Attempt::Converged(turned);
                }
            }
        }
        Attempt::Distrusted(turned)
    }

    /// For a chain at rest: hangs a coarser one, on the branch that the load raised from zero leads to, and starts from
    /// there. Returns whether that led to equilibrium; the linkage is at rest again where it did not.
    fn hang_coarsely(
        &mut self,
        linkage: &mut Linkage,
        loads: &Loads,
        settings: Settings,
        outcome: &mut Outcome,
    ) -> bool {
        let at_rest = linkage.deviation.iter().all(|&deviation| deviation == 0.0);
        if linkage.len() < FEWEST || !linkage.is_chain() || !at_rest {
            return false;
        }
        let mut coarser = self.coarser.take().unwrap_or_default();
        let (coarse, workspace) = &mut *coarser;
        coarse.cut(linkage, loads);
        workspace.forget();
        let enough = Settings { tolerance: f64::max(settings.tolerance, ENOUGH_FOR_A_START) };
        let outcome_there =
            settle(&mut coarse.linkage, &Loads::none(0), &coarse.loads, &[], enough, workspace);
        let is_stable = outcome_there.unstable_directions == Some(0);
        if is_stable {
            coarse.bend(linkage);
        }
        self.coarser = Some(coarser);
        if !is_stable {
            return false;
        }
        if let Attempt::Converged(_) = self.attempt(linkage, loads, settings.tolerance, TRUSTED_TURN, outcome)
        {
            return true;
        }
        linkage.deviation.fill(0.0);
        false
    }

    /// Raises the load from `before`, with which the linkage is in equilibrium, to `after`, in parts that turn no rod too
    /// far; `expected` is about how far the whole load would. Returns whether the whole load is on.
    fn raise(
        &mut self,
        linkage: &mut Linkage,
        before: &Loads,
        after: &Loads,
        expected: f64,
        tolerance: f64,
        outcome: &mut Outcome,
    ) -> bool {
        let mut partial = core::mem::take(&mut self.partial);
        let fitting = |turned: f64, most: f64| match FITTING_TURN / turned {
            times if times <= most => f64::max(0.1, times),
            _ => most,
        };
        let (mut share, mut part) = (0.0, fitting(expected, 0.5));
        let mut last_part = f64::INFINITY;
        self.increment.clear();
        let mut parts = 0;
        while share < 1.0 && part > SMALLEST_SHARE && parts < MOST_PARTS && !self.is_spent() {
            parts += 1;
            let next = f64::min(1.0, share + part);
            let tolerance = if next < 1.0 { f64::max(tolerance, ON_THE_WAY) } else { tolerance };
            partial.blend(before, after, next);
            self.saved.clone_from(&linkage.deviation);
            // As the last part bent it, this one will.
            let scale = (next - share) / last_part;
            self.increment.iter_mut().for_each(|change| *change *= scale);
            add(&mut linkage.deviation, &self.increment, 1.0);
            let guessed = largest_turn(linkage, &self.increment, &mut self.turn);
            let limit = TRUSTED_TURN - guessed;
            match self.attempt(linkage, &partial, tolerance, limit, outcome) {
                Attempt::Converged(turned) => {
                    last_part = next - share;
                    share = next;
                    part = last_part * fitting(guessed + turned, 2.0);
                    self.increment.clear();
                    let changes = linkage.deviation.iter().zip(&self.saved);
                    self.increment.extend(changes.map(|(after, before)| after - before));
                }
                Attempt::Distrusted(turned) => {
                    linkage.deviation.clone_from(&self.saved);
                    last_part = f64::INFINITY;
                    self.increment.clear();
                    part *= fitting(guessed + turned, 0.5);
                }
            }
        }
        self.partial = partial;
        share >= 1.0
    }
}

pub(super) fn add(deviation: &mut [f64], increment: &[f64], scale: f64) {
    for (deviation, step) in deviation.iter_mut().zip(increment) {
        *deviation += scale * step;
    }
}

/// Brings a linkage that is in equilibrium with `before` to equilibrium with `after`. Rods that `before` does
/// not know yet carried nothing until now. O(n) an iteration; one to three iterations in a usual growth step.
///
/// `guess` is by how much the first deviations are expected to change, from whatever is known; a good one saves
/// iterations, a bad one is dropped.
///
/// On [`Status::NonFinite`] and [`Status::Budget`] the linkage is left as it was.
pub fn settle(
    linkage: &mut Linkage,
    before: &Loads,
    after: &Loads,
    guess: &[f64],
    settings: Settings,
    workspace: &mut Workspace,
) -> Outcome {
    let mut outcome = Outcome::default();
    let mut start = core::mem::take(&mut workspace.start);
    start.clone_from(&linkage.deviation);
    if guess.is_empty() && workspace.hang_coarsely(linkage, after, settings, &mut outcome) {
        workspace.start = start;
        return outcome;
    }
    let guesses: &[&[f64]] = if guess.is_empty() { &[&[]] } else { &[guess, &[]] };
    let mut expected = 0.0;
    let balanced = guesses.iter().any(|guess| {
        // All changes one way are a bound, quicker to have than the turns, and small in a usual step.
        let mut turned = add_and_measure(&mut linkage.deviation, guess);
        if turned > 0.5 * TRUSTED_TURN {
            turned = largest_turn(linkage, guess, &mut workspace.turn);
        }
        let limit = TRUSTED_TURN - turned;
        let attempt = workspace.attempt(linkage, after, settings.tolerance, limit, &mut outcome);
        if let Attempt::Distrusted(turned) = attempt {
            linkage.deviation.clone_from(&start);
            expected = turned;
        }
        matches!(attempt, Attempt::Converged(_))
    });
    if !balanced && !workspace.raise(linkage, before, after, expected, settings.tolerance, &mut outcome) {
        workspace.descend(linkage, after, settings.tolerance, &mut outcome);
    }
    if !workspace.is_spent()
        && outcome.status == Status::Converged
        && outcome.unstable_directions.is_some_and(|count| count > 0)
    {
        workspace.lean(linkage, after, settings.tolerance, &mut outcome);
    }
    if workspace.is_spent() {
        outcome.status = Status::Budget;
    }
    if matches!(outcome.status, Status::NonFinite | Status::Budget) {
        linkage.deviation.clone_from(&start);
    }
    workspace.start = start;
    outcome
}

/// Adds changes to the first deviations; returns the sum of their sizes, NaN when any is. Four sums side by side: one would
/// wait for itself.
fn add_and_measure(deviation: &mut [f64], changes: &[f64]) -> f64 {
    let deviation = &mut deviation[..changes.len()];
    let mut sums = [0.0_f64; 4];
    let (mut fours, mut changes) = (deviation.chunks_exact_mut(4), changes.chunks_exact(4));
    for (deviation, changes) in (&mut fours).zip(&mut changes) {
        for lane in 0..4 {
            deviation[lane] += changes[lane];
            sums[lane] += changes[lane].abs();
        }
    }
    let mut sum: f64 = sums.iter().sum();
    for (deviation, change) in fours.into_remainder().iter_mut().zip(changes.remainder()) {
        *deviation += change;
        sum += change.abs();
    }
    sum
}

/// Largest turn of any rod that these changes of the first deviations make together, radians; `turn` is a buffer.
pub(super) fn largest_turn(linkage: &Linkage, change: &[f64], turn: &mut Vec<f64>) -> f64 {
    let mut largest = 0.0_f64;
    turn.clear();
    for (rod, step) in change.iter().enumerate() {
        let below = if linkage.parent[rod] == GROUND { 0.0 } else { turn[linkage.parent[rod] as usize] };
        let turned = below + step;
        turn.push(turned);
        largest = largest.max(turned.abs());
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
        Attempt::Converged(_) => {
            outcome.unstable_directions = Some(workspace.state.eliminate(linkage, 0.0));
        }
        Attempt::Distrusted(_) => outcome.status = Status::MaxIterations,
    }
    outcome
}
