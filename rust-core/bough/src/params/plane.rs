//! Whether a plant lies in one vertical plane, so that the quicker planar rods are enough.

use super::declaration::{ArrangementPattern, BranchingPattern, Params};
use crate::angle::Degrees;

/// Whether these params need rods in space.
pub(crate) fn is_spatial(params: &Params) -> bool {
    let Params { axis, branching, arrangement, loads, solver, .. } = params;
    let bends_aside = axis.rest_curvature != 0.0 && !is_half_turns(axis.rest_curvature_roll);
    let forks_aside = branching.pattern == BranchingPattern::Bifurcation && !is_half_turns(branching.roll);
    // Around a rigid stem forces are given in each axis's own plane.
    let azimuth = if arrangement.pattern == ArrangementPattern::Stem { Degrees(0.0) } else { axis.azimuth };
    let (sin, cos) = azimuth.sin_cos();
    let pulls_aside = |force: [f64; 3]| force[0] * sin + force[2] * cos != 0.0;
    solver.space
        || arrangement.pattern == ArrangementPattern::FlexibleStem
        || axis.rest_twist != 0.0
        || bends_aside
        || forks_aside
        || sought_in_plane(params).is_none()
        || pulls_aside(loads.tip_force)
        || loads.forces.iter().any(|pull| pulls_aside(pull.force))
        || blows_aside(params)
}

/// Whether the wind blows across the plane of the axis.
fn blows_aside(Params { axis, arrangement, loads, .. }: &Params) -> bool {
    let is_alone = arrangement.pattern != ArrangementPattern::Stem;
    is_alone && loads.wind > 0.0 && !is_half_turns(Degrees(loads.wind_azimuth.0 - axis.azimuth.0))
}

/// The preferred direction above the horizontal, as an angle in the plane of the axis; `None` where it lies beside that plane.
pub(crate) fn sought_in_plane(params: &Params) -> Option<Degrees> {
    let Params { axis, tropism, .. } = params;
    let Some(azimuth) = tropism.azimuth else { return Some(tropism.elevation) };
    let aside = Degrees(azimuth.0 - axis.azimuth.0);
    let is_vertical = Degrees(tropism.elevation.0).sin_cos().1 == 0.0;
    if tropism.strength == 0.0 || is_vertical || aside.0 % 360.0 == 0.0 {
        Some(tropism.elevation)
    } else if is_half_turns(aside) {
        Some(Degrees(180.0 - tropism.elevation.0))
    } else {
        None
    }
}

/// Whether the copies around a rigid stem differ by more than their azimuth, because they seek one direction in space or stand
/// in one wind.
pub(crate) fn copies_differ(params: &Params) -> bool {
    let Params { tropism, arrangement, loads, .. } = params;
    let seeks = tropism.strength > 0.0 && tropism.azimuth.is_some() && tropism.elevation.sin_cos().1 != 0.0;
    arrangement.pattern == ArrangementPattern::Stem && (seeks || loads.wind > 0.0)
}

fn is_half_turns(angle: Degrees) -> bool {
    angle.0 % 180.0 == 0.0
}
