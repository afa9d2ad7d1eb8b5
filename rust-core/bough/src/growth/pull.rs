//! Pulling at a grown plant: forces that are given, and the force that holds a point where a pointer wants it.

use alloc::vec;

use super::plant::{assemble, segments_of};
use super::state::Growth;
use crate::angle::Degrees;
use crate::mechanics::{
    Elimination, GROUND, Held, Linkage, Loads, Report, Settings, Status, Workspace, hold, settle,
};
use crate::params::PointForce;
use crate::plant::Plant;

/// A point that is being held, to go on from when the place moves.
#[derive(Clone, Debug)]
pub(super) struct Grip {
    pub(super) segment: u32,
    linkage: Linkage,
    held: Held,
}

impl Growth {
    /// Lets the given forces act on the grown plant. Segments that are not there yet are not pulled at.
    pub(super) fn pull(&self, linkage: &mut Linkage, loads: &mut Loads, report: &mut Report) {
        if self.params.loads.forces.is_empty() {
            return;
        }
        let before = loads.clone();
        for PointForce { segment, force: [x, y, _] } in &self.params.loads.forces {
            if let Some(rod) = self.rod_of(*segment) {
                let [x, y] = turned(self.params.axis.elevation, [*x, *y], -1.0);
                act(linkage, loads, rod, [x, y]);
            }
        }
        let settings = Settings { tolerance: self.params.solver.tolerance };
        let outcome = settle(linkage, &before, loads, &[], settings, &mut Workspace::default());
        report.status = report.status.max(outcome.status);
        report.residual = outcome.residual;
        report.iterations += outcome.iterations;
    }

    /// The plant with the distal end of a segment held at a place (x, y in m, in the plane of the axis), and the grip to
    /// go on from. Its params name the force that holds it, which acts even where all loads are taken off. Out of reach, the point comes as near as it can; `None` when
    /// there is no such segment, or no equilibrium was found.
    pub(super) fn hold(&self, segment: u32, place: [f64; 2], grip: Option<Grip>) -> Option<(Plant, Grip)> {
        let rod = self.rod_of(segment)?;
        let elevation = self.params.axis.elevation;
        let settings = Settings { tolerance: self.params.solver.tolerance };
        let grip = grip.filter(|grip| grip.segment == segment && grip.linkage.len() == self.rods());
        let mut loads = self.state.loads.clone();
        if self.params.loads.removed {
            loads = Loads::none(self.rods());
        }
        let (mut linkage, start) = match grip {
            Some(grip) => (grip.linkage, grip.held.force),
            None => (self.shown(), [0.0; 2]),
        };
        let local = turned(elevation, place, -1.0);
        let held = hold(&mut linkage, &loads, rod, local, start, settings);
        if held.outcome.status != Status::Converged {
            return None;
        }
        let [x, y] = turned(elevation, held.force, 1.0);
        act(&linkage, &mut loads, rod, held.force);
        let mut elimination = Elimination::default();
        elimination.evaluate(&linkage, &loads);
        let grown = self.state.report.status == Status::Converged;
        let stable = grown.then(|| elimination.eliminate(&linkage, 0.0) == 0);
        let iterations = self.state.report.iterations + held.outcome.iterations;
        let report = Report {
            residual: held.outcome.residual,
            stable,
            iterations,
            gravity_number: self.gravity_number(),
            ..self.state.report
        };
        let mut plant = assemble(self, &linkage, report);
        plant.params.loads.forces = vec![PointForce { segment, force: [x, y, 0.0] }];
        Some((plant, Grip { segment, linkage, held }))
    }

    /// The rod that is this segment.
    fn rod_of(&self, segment: u32) -> Option<usize> {
        segments_of(self).nth(segment as usize).map(|(rod, _)| rod)
    }
}

/// Turns a vector in the plane of the axis by plus or minus the elevation: out of or into the frame of the base
/// direction.
fn turned(elevation: Degrees, [x, y]: [f64; 2], sign: f64) -> [f64; 2] {
    let (sin, cos) = elevation.sin_cos();
    [x * cos - sign * y * sin, y * cos + sign * x * sin]
}

/// Adds a force on the distal end of a rod to the loads of all rods that bear it.
pub(super) fn act(linkage: &Linkage, loads: &mut Loads, rod: usize, [x, y]: [f64; 2]) {
    if [x, y] == [0.0; 2] {
        return;
    }
    let mut rod = rod as u32;
    while rod != GROUND {
        loads.x[rod as usize] += x;
        loads.y[rod as usize] += y;
        rod = linkage.parent[rod as usize];
    }
}
