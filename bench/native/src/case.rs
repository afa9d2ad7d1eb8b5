//! The case that all contenders solve: a rod of length 1 and EI = 1, clamped at 50 degrees above the horizontal, of weight 10. Only
//! `q = w L^3 / EI = 10` counts.

use bough::mechanics::{GROUND, Linkage, Loads};
use bough::params::{BranchingPattern, Degrees, Method, Params, Stepping, Thickening};

/// Above the horizontal, degrees.
const CLAMP: f64 = 50.0;
/// `w L^3 / EI`
const GRAVITY_NUMBER: f64 = 10.0;

/// The rod in the second-order cut: half a segment's mass at each of its ends, twice the stiffness at the clamp. At rest.
pub fn rod(segments: usize) -> (Linkage, Loads) {
    let length = 1.0 / segments as f64;
    let (sine, cosine) = CLAMP.to_radians().sin_cos();
    let mut linkage = Linkage::default();
    let mut loads = Loads::none(segments);
    for segment in 0..segments {
        let first = segment == 0;
        let share = if segment + 1 == segments { 0.5 } else { 1.0 };
        linkage.push(
            if first { GROUND } else { segment as u32 - 1 },
            length,
            if first { 2.0 } else { 1.0 } / length,
            0.0,
        );
        // Along the base direction, and at right angles to it.
        loads.x[segment] = -GRAVITY_NUMBER * length * share * sine;
        loads.y[segment] = -GRAVITY_NUMBER * length * share * cosine;
    }
    loads.gather(&linkage);
    (linkage, loads)
}

/// Where a rod of length 1 ends.
pub fn tip(linkage: &Linkage) -> [f64; 2] {
    let mut angle = CLAMP.to_radians();
    let mut end = [0.0; 2];
    for (length, deviation) in linkage.length.iter().zip(&linkage.deviation) {
        angle += deviation;
        end = [end[0] + length * angle.cos(), end[1] + length * angle.sin()];
    }
    end
}

/// The same rod in params, 1 m long: solved at once, to 1e-6.
pub fn params(segments: usize) -> Params {
    let mut params = Params::default();
    params.axis.segments = segments as u32;
    params.axis.segment_length = 1.0 / segments as f64;
    params.axis.radius = 0.005;
    params.axis.elevation = Degrees(CLAMP);
    params.axis.taper = 1.0;
    params.tropism.strength = 0.0;
    params.growth.thickening = Thickening::None;
    params.branching.pattern = BranchingPattern::None;
    params.solver.stepping = Stepping::Static;
    params.solver.tolerance = 1e-6;
    let weight = params.material.density * params.loads.gravity;
    params.material.youngs_modulus =
        4.0 * weight / (GRAVITY_NUMBER * params.axis.radius * params.axis.radius);
    params
}

/// The rod grown step by step, to 1e-10 in each; with pipes its last segment is as thin as keeps the sag the same at every size.
pub fn growth(segments: usize, thickening: Thickening) -> Params {
    let mut params = params(segments);
    params.growth.thickening = thickening;
    params.solver.stepping = Stepping::Exact;
    params.solver.tolerance = 1e-10;
    if thickening == Thickening::Pipes {
        params.axis.radius *= 2.0 / (segments as f64).sqrt();
    }
    params
}

/// The rod relaxed as the paper does, each joint with its own damping.
pub fn relaxation(segments: usize) -> Params {
    let mut params = params(segments);
    params.solver.method = Method::Euler;
    params
}

/// A tree that forks until it has about so many segments, at rest: axes of 12 segments, one more generation for twice as many.
pub fn tree(segments: usize) -> Params {
    let mut params = Params::default();
    params.axis.segments = 12;
    params.axis.segment_length = 0.02;
    params.axis.radius = 0.02;
    params.axis.elevation = Degrees(70.0);
    params.material.youngs_modulus = 5e9;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = ((segments as f64 / 12.0 + 1.0).log2().round() - 1.0).max(0.0) as u32;
    params.tropism.strength = 0.0;
    params.growth.thickening = Thickening::None;
    params.solver.stepping = Stepping::Static;
    params
}
