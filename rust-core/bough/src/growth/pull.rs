//! Pulling at a grown plant: the force that holds a point where a pointer wants it.

use alloc::vec;

use glam::DVec3;

use super::plant::{Pose, assemble, segments_of};
use super::state::Growth;
use crate::angle::Degrees;
use crate::mechanics::{Elimination, GROUND, Held, Linkage, Loads, Report, Status, hold};
use crate::params::{Params, PointForce};
use crate::plant::Plant;
use crate::space::Shape;

/// A point that is being held, to go on from when the place moves.
#[derive(Clone, Debug)]
pub(super) enum Grip {
    Plane { segment: u32, linkage: Linkage, held: Held },
    Space { segment: u32, shape: Shape, force: DVec3 },
}

impl Grip {
    pub(super) fn segment(&self) -> u32 {
        let (Grip::Plane { segment, .. } | Grip::Space { segment, .. }) = self;
        *segment
    }
}

impl Growth {
    /// The plant with the distal end of a segment held at a place (m; of planar plants what lies in their plane counts), and
    /// the grip to go on from. Its params name the force that holds it. Out of reach, the point comes as near as it can; `None` when
    /// there is no such segment, or no equilibrium was found.
    pub(super) fn hold(&self, segment: u32, place: [f64; 3], grip: Option<Grip>) -> Option<(Plant, Grip)> {
        if self.is_spatial {
            return self.hold_in_space(segment, place, grip);
        }
        let rod = self.rod_of(segment)?;
        let settings = self.settings();
        let (mut linkage, mut start) = match grip {
            Some(Grip::Plane { segment: own, linkage, held })
                if own == segment && linkage.len() == self.rods() =>
            {
                (linkage, held.force)
            }
            _ => (self.shown(), [0.0; 2]),
        };
        let local = into_plane(&self.params, place);
        let mut held = Held::default();
        let (outcome, loads) =
            self.rest_in_weather(&mut linkage, self.steady_loads::<Linkage>(), &mut |linkage, _, loads| {
                held = hold(linkage, loads, rod, local, start, settings);
                start = held.force;
                let mut pull = Loads::none(linkage.len());
                act(linkage, &mut pull, rod, held.force);
                (held.outcome, pull)
            });
        if outcome.status != Status::Converged {
            return None;
        }
        let force = out_of_plane(&self.params, held.force);
        let mut elimination = Elimination::default();
        elimination.evaluate(&linkage, &loads);
        let grown = self.state.report.status == Status::Converged;
        let stable = grown.then(|| elimination.eliminate(&linkage, 0.0) == 0);
        let iterations = self.state.report.iterations + outcome.iterations;
        let report = Report {
            residual: elimination.relative_residual(),
            stable,
            iterations,
            gravity_number: self.gravity_number(),
            self_buckling: self.self_buckling(),
            ..self.state.report
        };
        let mut plant = assemble(self, &Pose::Plane(&linkage), report);
        plant.params.loads.forces = vec![PointForce { segment, force }];
        Some((plant, Grip::Plane { segment, linkage, held }))
    }

    /// The rod that is this segment.
    pub(super) fn rod_of(&self, segment: u32) -> Option<usize> {
        segments_of(self).nth(segment as usize).map(|(rod, _)| rod)
    }
}

/// A vector of the world in the frame of the base direction; what is beside the plane of the axis is left out.
pub(super) fn into_plane(params: &Params, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let (sin, cos) = params.axis.elevation.sin_cos();
    let along = match params.axis.azimuth.0 {
        0.0 => x,
        _ => {
            let (sin, cos) = params.axis.azimuth.sin_cos();
            x * cos - z * sin
        }
    };
    [along * cos + y * sin, y * cos - along * sin]
}

/// A vector in the frame of the base direction as the world sees it.
pub(super) fn out_of_plane(params: &Params, [x, y]: [f64; 2]) -> [f64; 3] {
    let (sin, cos) = params.axis.elevation.sin_cos();
    turned(params.axis.azimuth, [x * cos - y * sin, y * cos + x * sin, 0.0])
}

/// A vector turned about the vertical; by nothing to the same bits.
pub(super) fn turned(azimuth: Degrees, [x, y, z]: [f64; 3]) -> [f64; 3] {
    if azimuth.0 == 0.0 {
        return [x, y, z];
    }
    let (sin, cos) = azimuth.sin_cos();
    [x * cos + z * sin, y, z * cos - x * sin]
}

/// As [`act`], in space.
pub(super) fn act_in_space(linkage: &Linkage, force: &mut [DVec3], rod: usize, pull: DVec3) {
    let mut rod = rod as u32;
    while rod != GROUND && pull != DVec3::ZERO {
        force[rod as usize] += pull;
        rod = linkage.parent[rod as usize];
    }
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
