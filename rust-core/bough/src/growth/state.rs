//! A plant in growth, one step at a time.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::axis::Axis;
use super::extrapolation::foresee;
use super::flexible_stem::stem_axis;
use super::pipes::Pipes;
use super::plan::Plan;
use super::plant::Pose;
use super::space::plane_of;
use super::trend::Trend;
use super::wood::Wood;
use crate::mechanics::{
    Elimination, GROUND, Linkage, Loads, Outcome, Relaxation, Report, Settings, Status, Workspace, settle,
};
use crate::params::{BoughError, Method, Params, Stepping, Thickening, check, is_foreseeable, is_spatial};
use crate::plant::Plant;
use crate::space::{self, Shape};

/// Every so many steps growth goes on from its state alone; states are kept for that ([`super::History`]).
pub(super) const STRIDE: u32 = 16;

/// All that changes as the plant grows; two equal states grow on equally.
#[derive(Clone, Debug, Default)]
pub(super) struct State {
    pub(super) step: u32,
    pub(super) linkage: Linkage,
    /// In space: rest rotations and deviations, in place of the linkage's angles.
    pub(super) shape: Shape,
    pub(super) wood: Vec<Wood>,
    pub(super) pipes: Pipes,
    pub(super) axes: Vec<Axis>,
    /// The loads with which the linkage is in equilibrium.
    pub(super) loads: Loads,
    /// In space: the force beyond each rod, in place of the loads.
    pub(super) force: Vec<DVec3>,
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
    /// Whether the rods are in space: where they all lie in one vertical plane, planar ones are quicker.
    pub(super) is_spatial: bool,
    /// In space, the normal of the plane in which they lie all the same.
    pub(super) plane: Option<DVec3>,
    pub(super) state: State,
    /// Rest angle of every pipe that was laid, step after step: in step s one number for each rod of then; in space three,
    /// the modified Rodrigues parameters of its rotation.
    pub(super) laid: Vec<f64>,
    /// Where new wood turns: direction of every rod when the step began, in the frame of the base direction.
    pub(super) angle: Vec<f64>,
    /// The same in space.
    pub(super) orientation: Vec<DQuat>,
    /// Largest fibre stress of every rod, where growth was foreseen instead of stepped through.
    pub(super) foreseen_stress: Vec<f64>,
    pub(super) underway: Option<Underway>,
    /// The loads with which the plant was in equilibrium when the step began.
    pub(super) before: Loads,
    pub(super) force_before: Vec<DVec3>,
    /// How the deviations are expected to change; a buffer, like the next.
    pub(super) guess: Vec<f64>,
    pub(super) workspace: Workspace,
    pub(super) workspace_in_space: space::Workspace,
}

/// What is left to do in a step whose new wood is attached.
#[derive(Clone, Debug)]
pub(super) enum Underway {
    /// All of it.
    Newton,
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
        if issues.is_empty() { Ok(Self::unchecked(params)) } else { Err(BoughError { issues }) }
    }

    /// As [`Growth::new`], for params that were checked before, or follow from some that were.
    pub(super) fn unchecked(params: &Params) -> Self {
        let main = Axis {
            generation: 0,
            base_radius: params.axis.radius,
            attached: GROUND,
            bearer: GROUND,
            branching_turn: 0.0,
            branching: space::orientation(params.axis.elevation, params.axis.azimuth),
            azimuth: params.axis.azimuth,
            segments: 0,
            forked: false,
        };
        let plan = Plan::new(params);
        let (up, along) = params.axis.elevation.sin_cos();
        let mut linkage = Linkage::default();
        // Down; from where it is upright or hangs, to the side of its azimuth.
        linkage.falls_left = if along == 0.0 { up < 0.0 } else { along < 0.0 };
        let first = if plan.stem.is_some() { stem_axis(params) } else { main };
        Growth {
            plan,
            is_spatial: is_spatial(params),
            plane: plane_of(params),
            params: params.clone(),
            state: State { axes: vec![first], linkage, ..State::default() },
            laid: Vec::new(),
            angle: Vec::new(),
            orientation: Vec::new(),
            foreseen_stress: Vec::new(),
            underway: None,
            before: Loads::default(),
            force_before: Vec::new(),
            guess: Vec::new(),
            workspace: Workspace::default(),
            workspace_in_space: space::Workspace::default(),
        }
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
        self.orientation.clear();
        self.underway = None;
    }

    /// Whether a step has begun and is not finished.
    pub(super) fn is_underway(&self) -> bool {
        self.underway.is_some()
    }

    /// How many segments the finished plant has.
    pub(super) fn full_grown_segments(&self) -> usize {
        let axes = self.plan.generations.iter().enumerate();
        let one: usize = axes.map(|(generation, axis)| axis.length.len() << generation).sum();
        self.plan.stem.as_ref().map_or(one, |stem| stem.length.len() * (one + 1))
    }

    /// How many segments the plant has now, those of the solver between them (the nodes of forks) included.
    pub fn segments(&self) -> usize {
        self.rods()
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
            if self.state.step % STRIDE == 0 {
                self.workspace.forget();
            }
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
            self.workspace.forget();
            // Everything grows unloaded, and without load nothing is remembered.
            self.state.linkage.deviation.fill(0.0);
            self.state.shape.deviation.fill([0.0; 3]);
            self.state.loads = Loads::none(0);
            self.state.force.clear();
            self.state.report = Report::default();
            self.state.trend = Trend::default();
            self.see();
            while self.state.step < target {
                self.state.step += 1;
                self.extend();
            }
            self.thicken();
            if self.params.solver.stepping == Stepping::Extrapolated {
                self.remember_what_is_foreseen();
            }
        }
        self.weigh();
        self.underway = Some(match self.params.solver.method {
            Method::Newton => Underway::Newton,
            Method::Euler => {
                let (linkage, loads) = (self.state.linkage.clone(), self.state.loads.clone());
                Underway::Euler(Box::new(Relaxation::new(linkage, loads, self.lumped_masses())))
            }
        });
    }

    /// Brings the plant to rest, or as far as the budget goes.
    pub(super) fn settle(&mut self, budget: &mut u64) {
        let settings = Settings { tolerance: self.params.solver.tolerance };
        let outcome = match self.underway.take() {
            None => return,
            Some(Underway::Newton) if self.is_spatial => {
                *budget = budget.saturating_sub(3 * self.rods() as u64);
                self.settle_in_space(settings)
            }
            Some(Underway::Newton) => {
                let State { linkage, loads, trend, report, .. } = &mut self.state;
                trend.expect(&mut self.guess);
                self.workspace.is_weary = report.status != Status::Converged;
                let outcome =
                    settle(linkage, &self.before, loads, &self.guess, settings, &mut self.workspace);
                if outcome.status == Status::Budget {
                    return;
                }
                trend.note(&self.workspace.start, &linkage.deviation);
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
    pub(super) fn is_exact(&self) -> bool {
        match self.params.solver.stepping {
            Stepping::Exact => true,
            Stepping::Static => false,
            Stepping::Extrapolated => !is_foreseeable(&self.params),
        }
    }

    /// Gives the unloaded axis the rest angles that exact growth would have left, and the deviations to start from.
    fn remember_what_is_foreseen(&mut self) {
        let forecast = foresee(&self.params, self.state.step);
        let State { linkage, wood, report, .. } = &mut self.state;
        report.stepping_error = Some(forecast.error);
        report.status = forecast.status;
        report.iterations = forecast.iterations;
        report.unstable_since = forecast.unstable_since;
        let joints = forecast.rest_curvature.iter().zip(&forecast.moment).zip(wood);
        for (joint, ((rest_curvature, moment), wood)) in joints.enumerate() {
            linkage.rest[joint] = rest_curvature * wood.joint_length;
            linkage.deviation[joint] = moment / linkage.stiffness[joint];
        }
        self.foreseen_stress = forecast.stress;
    }

    /// Whether new wood turns, so that directions matter.
    pub(super) fn turns(&self) -> bool {
        self.params.tropism.strength > 0.0
    }

    /// Takes down where every rod points now.
    fn see(&mut self) {
        if self.is_spatial {
            if self.turns() {
                let mut orientation = core::mem::take(&mut self.orientation);
                self.state.shape.orientations(self.rods_in_space(), &mut orientation);
                self.orientation = orientation;
            }
        } else if self.turns() {
            let mut angle = core::mem::take(&mut self.angle);
            self.state.linkage.angles(&mut angle);
            self.angle = angle;
        }
    }

    /// The next step up to the moment at which all weights begin to act, and the paper's relaxation from there.
    pub(super) fn relaxation_of_next_step(mut self) -> Relaxation {
        self.begin(self.state.step + 1);
        let masses = self.lumped_masses();
        Relaxation::new(self.state.linkage, self.state.loads, masses)
    }

    /// The linkage, without its loads where they are taken off.
    pub(super) fn shown(&self) -> Linkage {
        let mut linkage = self.state.linkage.clone();
        if self.params.loads.removed {
            // Without load every joint goes to its rest angle: that is the equilibrium, exactly.
            linkage.deviation.fill(0.0);
        }
        linkage
    }

    /// The plant as it stands. O(n), and with pipes O(n steps) for the stress.
    pub fn plant(&self) -> Plant {
        if self.is_spatial {
            return self.plant_in_space();
        }
        let mut linkage = self.shown();
        let mut report = self.state.report;
        let mut loads = self.state.loads.clone();
        if self.params.loads.removed {
            loads = Loads::none(linkage.len());
            report.residual = 0.0;
        }
        if !self.params.loads.removed {
            self.endure(&mut linkage, &mut loads, &mut report);
        }
        report.stable = (report.status == Status::Converged).then(|| {
            let mut elimination = Elimination::default();
            elimination.evaluate(&linkage, &loads);
            report.residual = elimination.relative_residual();
            elimination.eliminate(&linkage, 0.0) == 0
        });
        report.gravity_number = self.gravity_number();
        report.self_buckling = self.self_buckling();
        super::plant::assemble(self, &Pose::Plane(&linkage), report)
    }
}

/// Adds the outcome of one growth step to the report.
fn note(report: &mut Report, outcome: Outcome, step: u32) {
    report.status = report.status.max(outcome.status);
    report.residual = outcome.residual;
    report.worst_step_residual = f64::max(report.worst_step_residual, outcome.residual);
    report.iterations += outcome.iterations;
    let is_lost = !matches!(outcome.status, Status::Converged | Status::Budget);
    let is_unstable = outcome.unstable_directions.is_some_and(|count| count > 0);
    if (is_unstable || is_lost) && report.unstable_since.is_none() {
        report.unstable_since = Some(step);
    }
}
