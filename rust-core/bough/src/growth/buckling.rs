//! How far an upright plant is from its critical height, or past it.

use alloc::vec::Vec;

use glam::DVec3;

use super::pull::out_of_plane;
use super::state::Growth;
use crate::params::ArrangementPattern;
use crate::space::{Shape, exp, load_over_critical, orientation};

impl Growth {
    /// The present loads over those at which the upright plant would buckle under them; `None` for one that leans or is bent
    /// anyway. About forty times the cost of an iteration.
    pub(super) fn self_buckling(&self) -> Option<f64> {
        let upright = match self.params.arrangement.pattern {
            ArrangementPattern::FlexibleStem => self.params.arrangement.stem_elevation,
            _ => self.params.axis.elevation,
        };
        if upright.0 != 90.0 || self.params.loads.removed || self.state.wood.is_empty() {
            return None;
        }
        let rods = self.rods_in_space();
        if self.is_spatial {
            let mut rest = self.state.shape.clone();
            rest.deviation.fill([0.0; 3]);
            return load_over_critical(rods, &rest, &self.state.force);
        }
        let (mut rest, loads) = (Shape::default(), &self.state.loads);
        let base = orientation(self.params.axis.elevation, self.params.axis.azimuth);
        for (rod, angle) in self.state.linkage.rest.iter().enumerate() {
            let bend = exp(DVec3::Z * *angle);
            let stands = if rod == 0 { base } else { glam::DQuat::IDENTITY };
            rest.push(stands, bend);
        }
        let forces = loads.x.iter().zip(&loads.y);
        let force: Vec<DVec3> =
            forces.map(|(x, y)| DVec3::from_array(out_of_plane(&self.params, [*x, *y]))).collect();
        load_over_critical(rods, &rest, &force)
    }
}
