//! The paper's own way to one equilibrium, recorded so that it can be played.

use alloc::vec;
use alloc::vec::Vec;

use super::state::Growth;
use crate::angle::Degrees;
use crate::mechanics::{Outcome, Relaxation, Settings, TRUSTED_TURN};
use crate::params::{BoughError, Issue, Method, Params};

/// Most segments whose relaxation is recorded: beyond, it would take minutes and hundreds of megabytes.
const MOST_SEGMENTS: usize = 2000;
/// More iterations of Newton's method than this are not trusted, as in growth.
const TRUSTED_ITERATIONS: u64 = 12;
/// Most moments kept; the record is thinned to every second moment whenever there would be more.
const MOST_MOMENTS: usize = 512;

/// Angles and angular velocities over time, while a plant comes to rest in one growth step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// How many segments there are, n.
    pub segments: usize,
    /// Time of each moment, s; shape `T`. The damping is chosen, so only the end state is physical.
    pub time: Vec<f64>,
    /// Direction of every segment counter-clockwise from +x, radians; shape `T n`, moment after moment.
    pub angle: Vec<f64>,
    /// Angular velocity of every segment's base joint, 1/s; shape `T n`.
    pub velocity: Vec<f64>,
    /// Largest torque left over at a joint at each moment, relative to the largest external torque; shape `T`.
    pub residuals: Vec<f64>,
    /// Whether the last shape was not reached by the iterations before it, but by raising the load in parts.
    pub is_led: bool,
    /// How the iteration ended, its residual, and how many Euler steps it took.
    pub outcome: Outcome,
}

/// The paper's relaxation (equations 15 to 20) of one growth step: from the moment at which the new segments are
/// attached and all weights begin to act, until the plant is at rest. The steps before are solved by Newton's
/// method. A step outside `1 ..= steps` is taken as the nearest inside.
///
/// # Errors
/// Every problem of the params at once, and plants of more than 2000 segments at that step.
///
/// # Cost
/// O(n) an Euler step, and about `n^1.5` of these: fine to 100 segments, seconds at 400.
pub fn relaxation(params: &Params, step: u32) -> Result<Trajectory, BoughError> {
    let growth = grown_before(params, step)?;
    let mut relaxation = growth.relaxation_of_next_step();
    let settings = Settings { tolerance: params.solver.tolerance };
    let mut record = Record::new(&relaxation, params);
    record.keep(&relaxation);
    let mut stride = 1;
    loop {
        let outcome = relaxation.relax(settings, stride);
        if record.kept.time.last() != Some(&relaxation.time) {
            record.keep(&relaxation);
        }
        if let Some(outcome) = outcome {
            record.kept.outcome = outcome;
            return Ok(record.kept);
        }
        if record.kept.time.len() == MOST_MOMENTS {
            record.kept.thin();
            stride *= 2;
        }
    }
}

/// Newton's iterations for the same step from the same start, to be played beside the relaxation: `time` counts them, and
/// there is no velocity. Where they are not trusted (the load is raised in parts then, see [`crate::mechanics::settle`]) the
/// shapes until there are kept, and the equilibrium; `outcome.iterations` counts all.
///
/// # Errors
/// As [`relaxation`].
pub fn iterations(params: &Params, step: u32) -> Result<Trajectory, BoughError> {
    let growth = grown_before(params, step)?;
    let mut settled = growth.clone();
    let mut search = growth.relaxation_of_next_step();
    let mut record = Record::new(&search, params);
    let mut turned = 0.0;
    record.keep(&search);
    while !search.at_rest(params.solver.tolerance) {
        turned += search.newton();
        // Written so that NaN is not trusted.
        if !(turned <= TRUSTED_TURN && search.taken <= TRUSTED_ITERATIONS) {
            // At once, that is anew: nothing was iterated before.
            let before = if settled.is_exact() { settled.report().iterations } else { 0 };
            settled.step();
            search.taken = settled.report().iterations.saturating_sub(before);
            search.bend(&settled.state.linkage);
            record.keep(&search);
            record.kept.outcome.status = settled.report().status;
            record.kept.is_led = true;
            break;
        }
        record.keep(&search);
    }
    let residual = search.residual();
    record.kept.outcome = Outcome { iterations: search.taken, residual, ..record.kept.outcome };
    Ok(record.kept)
}

/// The plant as it is when this step (the nearest there is) begins.
fn grown_before(params: &Params, step: u32) -> Result<Growth, BoughError> {
    let solver = crate::params::Solver { method: Method::Newton, ..params.solver.clone() };
    let mut growth = Growth::new(&Params { solver, ..params.clone() })?;
    let step = step.clamp(1, growth.steps());
    // The main axis alone tells of most plants that they are too large, before they are grown.
    let main_axis = params.axis.segments.min(step) as usize;
    if main_axis <= MOST_SEGMENTS {
        while growth.steps_taken() + 1 < step && growth.step() {}
    }
    let segments = growth.rods().max(main_axis);
    if segments > MOST_SEGMENTS {
        return Err(BoughError { issues: vec![Issue::too_long_to_relax(segments, MOST_SEGMENTS)] });
    }
    Ok(growth)
}

/// What is kept of a way to rest.
struct Record {
    kept: Trajectory,
    /// The rods that are segments.
    rods: Vec<usize>,
    base: f64,
    angles: Vec<f64>,
}

impl Record {
    fn new(start: &Relaxation, params: &Params) -> Self {
        let rods: Vec<usize> =
            (0..start.linkage.len()).filter(|&rod| start.linkage.length[rod] > 0.0).collect();
        let kept = Trajectory { segments: rods.len(), ..Trajectory::default() };
        Record { kept, rods, base: wrapped_radians(params.axis.elevation), angles: Vec::new() }
    }

    fn keep(&mut self, moment: &Relaxation) {
        let Record { kept, rods, base, angles } = self;
        moment.linkage.angles(angles);
        kept.time.push(moment.time);
        kept.angle.extend(rods.iter().map(|&rod| *base + angles[rod]));
        kept.velocity.extend(rods.iter().map(|&rod| moment.velocity[rod]));
        kept.residuals.push(moment.residual());
    }
}

fn wrapped_radians(angle: Degrees) -> f64 {
    crate::angle::wrap(angle.radians())
}

impl Trajectory {
    /// Drops every second moment.
    fn thin(&mut self) {
        let segments = self.segments;
        let thinned = |array: &[f64], width: usize| -> Vec<f64> {
            array.chunks(width).step_by(2).flatten().copied().collect()
        };
        self.time = thinned(&self.time, 1);
        self.angle = thinned(&self.angle, segments);
        self.velocity = thinned(&self.velocity, segments);
        self.residuals = thinned(&self.residuals, 1);
    }
}
