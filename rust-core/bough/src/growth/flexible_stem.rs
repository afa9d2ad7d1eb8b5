//! A stem that grows itself and bends and twists under its axes: each of its segments bears one at its end.

use glam::DQuat;

use super::axis::{Axis, STEM};
use super::state::Growth;
use crate::angle::Degrees;
use crate::mechanics::GROUND;
use crate::params::Params;
use crate::space::orientation;

/// The stem before it grows.
pub(super) fn stem_axis(params: &Params) -> Axis {
    Axis {
        generation: STEM,
        base_radius: params.arrangement.stem_radius,
        attached: GROUND,
        bearer: GROUND,
        branching_turn: 0.0,
        branching: orientation(params.arrangement.stem_elevation, Degrees(0.0)),
        azimuth: params.axis.azimuth,
        segments: 0,
        forked: false,
    }
}

/// The direction in which an axis leaves the stem, against the stem's: as declared where the stem is upright.
fn branching(params: &Params, azimuth: Degrees) -> DQuat {
    orientation(Degrees(90.0), Degrees(0.0)).conjugate() * orientation(params.axis.elevation, azimuth)
}

impl Growth {
    /// Adds as many segments to the stem as are due in this step, each with the beginning of an axis at its end.
    pub(super) fn extend_stem(&mut self) {
        let Some(stem) = &self.plan.stem else { return };
        let (count, arrangement) = (stem.length.len() as u32, &self.params.arrangement);
        let (interval, divergence) = (arrangement.interval, arrangement.divergence);
        let due = (self.state.step - 1).checked_div(interval).map_or(count, |before| before + 1).min(count);
        for index in self.state.axes[0].segments..due {
            self.extend_axis(0);
            let attached = self.state.axes[0].bearer;
            let bearer = self.end_in_node(0);
            self.state.axes[0].bearer = bearer;
            let turned = f64::from(index) * divergence.0 % 360.0;
            let azimuth = Degrees(self.params.axis.azimuth.0 + turned);
            self.state.axes.push(Axis {
                generation: 0,
                base_radius: self.params.axis.radius,
                attached,
                bearer,
                branching_turn: 0.0,
                branching: branching(&self.params, azimuth),
                azimuth,
                segments: 0,
                forked: false,
            });
        }
    }
}
