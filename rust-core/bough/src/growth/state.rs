//! A plant in growth, one step at a time.

use super::axis::Axis;
use super::plan::Plan;
use super::trend::Trend;
use super::wood::Wood;
use crate::mechanics::{
    Elimination, GROUND, Linkage, Loads, Outcome, Relaxation, Report, Settings, Status, Workspace, settle,
};
use crate::params::{BoughError, Method, Params, Stepping, Thickening, check};
use crate::plant::{Plant, Section};

/// All that changes as the plant grows; two equal states grow on equally.
#[derive(Clone, Debug, Default)]
pub(super) struct State {
    pub(super) step: u32,
    pub(super) linkage: Linkage,
    pub(super) wood: Vec<Wood>,
    pub(super) axes: Vec<Axis>,
    /// The loads with which the linkage is in equilibrium.
    pub(super) loads: Loads,
    /// How the deviations have been changing from step to step.
    pub(super) trend: Trend,
    pub(super) report: Report,
}

/// A plant in growth: a main axis, and what it forks into.
///
/// ```
/// use bough::{Growth, params::Params};
/// let mut growth = Growth::new(&Params::default())?;
/// while growth.step() {
///     assert!(growth.report().residual <= 1e-10);
/// }
/// assert_eq!(growth.steps_taken(), growth.steps());
/// # Ok::<(), bough::params::BoughError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Growth {
    pub(super) params: Params,
    pub(super) plan: Plan,
    pub(super) state: State,
    /// Rest angle of every pipe that was laid, step after step: in step s one number for each rod of then.
    pub(super) laid: Vec<f64>,
    /// Where new wood turns: direction of every rod when the step began, in the frame of the base direction.
    pub(super) angle: Vec<f64>,
    underway: Option<Underway>,
    workspace: Workspace,
}

/// What is left to do in a step whose new wood is attached.
#[derive(Clone, Debug)]
enum Underway {
    /// All of it, from equilibrium with these loads.
    Newton(Loads),
    /// The rest of this relaxation.
    Euler(Box<Relaxation>),
}

impl Growth {
    /// Prepares growth; no step is taken yet. An arrangement is left aside: see [`super::History`].
    ///
    /// # Errors
    /// Every problem of the params at once.
    pub fn new(params: &Params) -> Result<Self, BoughError> {
        let issues = check(params);
        if !issues.is_empty() {
            return Err(BoughError { issues });
        }
        let main = Axis {
            generation: 0,
            base_radius: params.axis.radius,
            attached: GROUND,
            bearer: GROUND,
            branching_turn: 0.0,
            segments: 0,
            forked: false,
        };
        Ok(Growth {
            plan: Plan::new(params),
            params: params.clone(),
            state: State { axes: vec![main], ..State::default() },
            laid: Vec::new(),
            angle: Vec::new(),
            underway: None,
            workspace: Workspace::default(),
        })
    }

    /// How many growth steps the finished plant takes.
    pub fn steps(&self) -> u32 {
        self.plan.steps()
    }

    /// How many growth steps have been taken.
    pub fn steps_taken(&self) -> u32 {
        self.state.report.steps
    }

    /// Goes back (or on) to a state that this growth has been in.
    pub(super) fn return_to(&mut self, state: &State, pipes_laid: usize) {
        self.state.clone_from(state);
        self.laid.truncate(pipes_laid);
        self.angle.clear();
        self.underway = None;
    }

    /// Whether a step has begun and is not finished.
    pub(super) fn is_underway(&self) -> bool {
        self.underway.is_some()
    }

    /// How many segments the finished plant has.
    pub(super) fn full_grown_segments(&self) -> usize {
        let axes = self.plan.generations.iter().enumerate();
        axes.map(|(generation, axis)| axis.length.len() << generation).sum()
    }

    /// How many segments and nodes there are now.
    pub(super) fn rods(&self) -> usize {
        self.state.linkage.len()
    }

    /// What the solver says so far. Its `stable` is decided by [`Growth::plant`] only.
    pub fn report(&self) -> &Report {
        &self.state.report
    }

    /// Takes one growth step; false when the plant is finished, or cannot go on because a number overflowed.
    ///
    /// The order is that of section 4: older segments get their pipe, at rest in the present shape; new segments
    /// are attached; all weights act; equilibrium.
    pub fn step(&mut self) -> bool {
        let mut unlimited = u64::MAX;
        self.work(self.state.step + 1, &mut unlimited)
    }

    /// Goes on towards the end of step `target` until a step is taken or the budget of stepped rods is spent; false
    /// when no step is left to take. With static stepping the one step goes all the way to `target`.
    pub(super) fn work(&mut self, target: u32, budget: &mut u64) -> bool {
        if self.underway.is_none() {
            let overflowed = self.state.report.status == Status::NonFinite;
            if self.state.step == self.steps() || (overflowed && self.is_exact()) {
                return false;
            }
            self.begin(target);
        }
        self.settle(budget);
        true
    }

    /// New wood, at rest in the present shape, and the loads that will act.
    fn begin(&mut self, target: u32) {
        let pipes = self.params.growth.thickening == Thickening::Pipes;
        if self.is_exact() {
            self.state.step += 1;
            if pipes {
                self.thicken();
            }
            self.see();
            self.extend();
            if pipes {
                self.record_pipes();
            }
        } else {
            // Everything grows unloaded, and without load nothing is remembered.
            self.state.linkage.deviation.fill(0.0);
            self.state.loads = Loads::none(0);
            self.state.report = Report::default();
            self.state.trend = Trend::default();
            self.see();
            while self.state.step < target {
                self.state.step += 1;
                self.extend();
            }
            self.thicken();
        }
        let masses = self.lumped_masses();
        let loads = self.weigh(&masses);
        let before = core::mem::replace(&mut self.state.loads, loads);
        self.underway = Some(match self.params.solver.method {
            Method::Newton => Underway::Newton(before),
            Method::Euler => {
                let (linkage, loads) = (self.state.linkage.clone(), self.state.loads.clone());
                Underway::Euler(Box::new(Relaxation::new(linkage, loads, masses)))
            }
        });
    }

    /// Brings the plant to rest, or as far as the budget goes.
    fn settle(&mut self, budget: &mut u64) {
        let settings = Settings { tolerance: self.params.solver.tolerance };
        let outcome = match self.underway.take() {
            None => return,
            Some(Underway::Newton(before)) => {
                let State { linkage, loads, trend, .. } = &mut self.state;
                let start = linkage.deviation.clone();
                let guess = trend.next();
                let outcome = settle(linkage, &before, loads, &guess, settings, &mut self.workspace);
                trend.note(&start, &linkage.deviation);
                *budget = budget.saturating_sub(self.rods() as u64);
                outcome
            }
            Some(Underway::Euler(mut relaxation)) => {
                let steps = (*budget / self.rods() as u64).max(1);
                let Some(outcome) = relaxation.relax(settings, steps) else {
                    *budget = 0;
                    self.underway = Some(Underway::Euler(relaxation));
                    return;
                };
                *budget = budget.saturating_sub(self.rods() as u64);
                if outcome.status != Status::NonFinite {
                    self.state.linkage = relaxation.linkage;
                }
                outcome
            }
        };
        note(&mut self.state.report, outcome, self.state.step);
        self.state.report.steps = self.state.step;
    }

    /// Whether every step ends in equilibrium, so that the plant remembers.
    fn is_exact(&self) -> bool {
        self.params.solver.stepping == Stepping::Exact
    }

    /// Whether new wood turns, so that directions matter.
    pub(super) fn turns(&self) -> bool {
        self.params.tropism.strength > 0.0
    }

    /// Takes down where every rod points now.
    fn see(&mut self) {
        if self.turns() {
            let mut angle = core::mem::take(&mut self.angle);
            self.state.linkage.angles(&mut angle);
            self.angle = angle;
        }
    }

    /// How many pipes a rod has.
    pub(super) fn pipes(&self, rod: usize) -> u32 {
        match self.params.growth.thickening {
            Thickening::None => 1,
            Thickening::Pipes => self.state.step - self.state.wood[rod].first_pipe + 1,
        }
    }

    /// The cross-section of a segment.
    pub(super) fn section(&self, rod: usize) -> Section {
        Section { birth_radius: self.state.wood[rod].birth_radius, pipes: self.pipes(rod) }
    }

    /// Gives every rod the stiffness of its present pipes, the new ones unstressed in the present shape (equations 36
    /// to 40): the torque stays what it was, so the deviation shrinks as the stiffness grows, and the rest angle takes
    /// up the difference.
    fn thicken(&mut self) {
        for rod in 0..self.rods() {
            let pipes = f64::from(self.pipes(rod));
            let stiffness = pipes * pipes * self.state.wood[rod].pipe_stiffness;
            let linkage = &mut self.state.linkage;
            let deviation = linkage.deviation[rod] * (linkage.stiffness[rod] / stiffness);
            linkage.rest[rod] += linkage.deviation[rod] - deviation;
            linkage.deviation[rod] = deviation;
            linkage.stiffness[rod] = stiffness;
        }
    }

    /// Keeps the rest angle of the pipes that were laid in this step.
    fn record_pipes(&mut self) {
        let linkage = &self.state.linkage;
        self.laid.extend((0..linkage.len()).map(|rod| linkage.joint_angle(rod)));
    }

    /// The next step up to the moment at which all weights begin to act, and the paper's relaxation from there.
    pub(super) fn relaxation_of_next_step(mut self) -> Relaxation {
        self.begin(self.state.step + 1);
        let masses = self.lumped_masses();
        Relaxation::new(self.state.linkage, self.state.loads, masses)
    }

    /// The plant as it stands. O(n), and with pipes O(n steps) for the stress.
    pub fn plant(&self) -> Plant {
        let mut linkage = self.state.linkage.clone();
        let mut report = self.state.report;
        let mut loads = self.state.loads.clone();
        if self.params.loads.removed {
            // Without load every joint goes to its rest angle: that is the equilibrium, exactly.
            linkage.deviation.fill(0.0);
            loads = Loads::none(linkage.len());
            report.residual = 0.0;
        }
        if !self.params.loads.removed {
            self.pull(&mut linkage, &mut loads, &mut report);
        }
        report.stable = (report.status == Status::Converged).then(|| {
            let mut elimination = Elimination::default();
            elimination.evaluate(&linkage, &loads);
            elimination.eliminate(&linkage, 0.0) == 0
        });
        report.gravity_number = self.gravity_number();
        super::plant::assemble(self, &linkage, report)
    }
}

/// Adds the outcome of one growth step to the report.
fn note(report: &mut Report, outcome: Outcome, step: u32) {
    report.status = report.status.max(outcome.status);
    report.residual = outcome.residual;
    report.worst_step_residual = f64::max(report.worst_step_residual, outcome.residual);
    report.iterations += outcome.iterations;
    if outcome.unstable_directions.is_some_and(|count| count > 0) && report.unstable_since.is_none() {
        report.unstable_since = Some(step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::angle::Degrees;

    impl Growth {
        /// Lets the weights of the present wood act, outside any step.
        fn load(&mut self) {
            let loads = self.weigh(&self.lumped_masses());
            let before = core::mem::replace(&mut self.state.loads, loads);
            self.underway = Some(Underway::Newton(before));
            self.settle(&mut u64::MAX.clone());
        }
    }

    /// A horizontal axis that bends little: slopes below 1e-4, so that the sag is linear to 1e-8.
    fn stiff_axis(segments: u32) -> Growth {
        let mut params = Params::default();
        params.axis.elevation = Degrees(0.0);
        params.axis.segments = segments;
        params.axis.segment_length = 1.0 / f64::from(segments);
        params.material.youngs_modulus = 1e13;
        Growth::new(&params).unwrap()
    }

    /// An axis of fixed length whose wood thickens from `first` to `last` pipes, each laid before its weight
    /// acts. Returns the sag over the one that the first pipes alone have.
    fn thickened_sag(first: u32, last: u32) -> f64 {
        let mut growth = stiff_axis(20);
        growth.params.solver.stepping = Stepping::Static;
        growth.work(20, &mut u64::MAX.clone());
        growth.params.solver.stepping = Stepping::Exact;
        growth.params.growth.thickening = Thickening::Pipes;
        growth.state.linkage.deviation.fill(0.0);
        growth.state.loads = Loads::none(0);
        // As many pipes everywhere, all from the beginning.
        let lay = |growth: &mut Growth, pipes: u32| {
            growth.state.step = pipes;
            growth.state.wood.iter_mut().for_each(|wood| wood.first_pipe = 1);
            growth.thicken();
        };
        lay(&mut growth, first);
        growth.load();
        let sag = |growth: &Growth| -growth.plant().tip(0)[1];
        let before = sag(&growth);
        for pipes in first + 1..=last {
            lay(&mut growth, pipes);
            growth.load();
        }
        sag(&growth) / before
    }

    #[test]
    fn thickening_at_fixed_length_sags_by_the_incremental_law() {
        // From one pipe on: the sum of 1 / k^2.
        for pipes in [1_u32, 2, 10, 200] {
            let expected: f64 = (1..=pipes).map(|pipe| 1.0 / f64::from(pipe * pipe)).sum();
            assert!((thickened_sag(1, pipes) / expected - 1.0).abs() < 1e-6, "{pipes} pipes");
        }
        // Many thin pipes: 2 - (R0 / R)^2, with the areas in the ratio 1 to 4. The sum over pipes differs from the
        // integral by half its end terms, 15 / 32 / first.
        let off = [100, 200, 400].map(|first| (thickened_sag(first, 4 * first) - (2.0 - 0.25)).abs());
        assert!(off[2] < 0.48 / 400.0 && off[0] / off[1] > 1.9 && off[1] / off[2] > 1.9, "{off:?}");
    }

    /// A joint under constant torque: each pipe is laid unstressed, so the joint does not move, and the rest angle
    /// of the bundle is `mu - T / (n^2 kappa_1)`.
    #[test]
    fn under_constant_torque_the_rest_angle_creeps_after_the_joint() {
        let mut growth = stiff_axis(1);
        growth.params.loads.gravity = 0.0;
        growth.params.loads.tip_force = [0.0, -50.0, 0.0];
        growth.params.material.youngs_modulus = 1e9;
        growth.step();
        growth.params.growth.thickening = Thickening::Pipes;
        let angle = growth.state.linkage.joint_angle(0);
        let torque = growth.state.linkage.stiffness[0] * growth.state.linkage.deviation[0];
        let first_stiffness = growth.state.wood[0].pipe_stiffness;
        for pipes in 2..=50_u32 {
            growth.state.step = pipes;
            growth.thicken();
            growth.load();
            let linkage = &growth.state.linkage;
            let stiffness = f64::from(pipes * pipes) * first_stiffness;
            assert!((linkage.stiffness[0] / stiffness - 1.0).abs() < 1e-12);
            assert!((linkage.joint_angle(0) - angle).abs() < 1e-12);
            assert!((linkage.rest[0] - (angle - torque / stiffness)).abs() < 1e-12);
        }
    }
}
