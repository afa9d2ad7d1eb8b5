//! The paper's own way to one equilibrium, recorded so that it can be played.

use alloc::vec;
use alloc::vec::Vec;

use super::state::Growth;
use crate::angle::Degrees;
use crate::mechanics::{Outcome, Relaxation, Settings};
use crate::params::{BoughError, Issue, Method, Params};

/// Most segments whose relaxation is recorded: beyond, it would take minutes and hundreds of megabytes.
const MOST_SEGMENTS: usize = 2000;
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
    let mut growth = Growth::new(&Params {
        solver: crate::params::Solver { method: Method::Newton, ..params.solver.clone() },
        ..params.clone()
    })?;
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
    let mut relaxation = growth.relaxation_of_next_step();
    let settings = Settings { tolerance: params.solver.tolerance };
    let segments: Vec<usize> =
        (0..relaxation.linkage.len()).filter(|&rod| relaxation.linkage.length[rod] > 0.0).collect();
    let base = wrapped_radians(params.axis.elevation);
    let mut record = Trajectory { segments: segments.len(), ..Trajectory::default() };
    let mut angles = Vec::new();
    let mut keep = |relaxation: &Relaxation, record: &mut Trajectory| {
        relaxation.linkage.angles(&mut angles);
        record.time.push(relaxation.time);
        record.angle.extend(segments.iter().map(|&rod| base + angles[rod]));
        record.velocity.extend(segments.iter().map(|&rod| relaxation.velocity[rod]));
    };
    keep(&relaxation, &mut record);
    let mut stride = 1;
    loop {
        let outcome = relaxation.relax(settings, stride);
        if record.time.last() != Some(&relaxation.time) {
            keep(&relaxation, &mut record);
        }
        if let Some(outcome) = outcome {
            record.outcome = outcome;
            return Ok(record);
        }
        if record.time.len() == MOST_MOMENTS {
            record.thin();
            stride *= 2;
        }
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
    }
}
