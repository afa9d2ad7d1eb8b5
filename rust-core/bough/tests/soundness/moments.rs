//! The statics of a plant in space once more, from its result arrays alone.

use std::f64::consts::PI;

use bough::Plant;
use bough::mechanics::Status;
use bough::params::ArrangementPattern;

use super::forces::forces;

/// Panics if a joint does not bear the moment of all forces beyond it: bending and twisting together, up to the residual
/// that the plant states. O(n^2), for small plants. Around a rigid stem each copy stands for itself.
pub fn check_moments(plant: &Plant) {
    check(plant, !plant.params.loads.removed);
}

/// As [`check_moments`], of a plant that is held: the hand's force acts even where all loads are taken off.
pub fn check_held_moments(plant: &Plant) {
    check(plant, true);
}

fn check(plant: &Plant, pulled: bool) {
    let Plant { params, polylines, segments, report } = plant;
    if report.status != Status::Converged || params.arrangement.pattern == ArrangementPattern::Stem {
        return;
    }
    let (forces, size) = forces(plant, pulled);
    let count = segments.parent.len();
    let place = |point: usize| [0, 1, 2].map(|axis| polylines.points[3 * point + axis]);
    let bearer = |segment: usize| usize::try_from(segments.parent[segment]).ok();
    let (mut expected, mut reach) = (vec![[0.0_f64; 3]; count], 0.0);
    // A fork has a joint of its own at the end of its bearer, which counts for what is largest.
    let mut at_node = vec![[0.0_f64; 3]; count];
    for segment in 0..count {
        reach += segments.length[segment];
        let end = place(segments.point[segment] as usize);
        let [fx, fy, fz] = forces[segment];
        let act = |about: &mut [f64; 3], from: [f64; 3]| {
            let [x, y, z] = [0, 1, 2].map(|axis| end[axis] - from[axis]);
            about[0] += y * fz - z * fy;
            about[1] += z * fx - x * fz;
            about[2] += x * fy - y * fx;
        };
        let mut joint = Some(segment);
        while let Some(at) = joint {
            act(&mut expected[at], place(segments.point[at] as usize - 1));
            act(&mut at_node[at], place(segments.point[at] as usize));
            joint = bearer(at);
        }
    }
    let size_of = |[x, y, z]: &[f64; 3]| x.hypot(*y).hypot(*z);
    let sizes: Vec<f64> = expected.iter().map(size_of).collect();
    let largest = sizes.iter().copied().chain(at_node.iter().map(size_of)).fold(0.0, f64::max);
    // Rounding of places and sums, and of the angles that springs are bent by: stiffest is half a segment's spring.
    let stiffest = (0..count)
        .map(|segment| {
            let second_moment = 0.25 * PI * segments.radius[segment].powi(4);
            2.0 * params.material.youngs_modulus * second_moment / segments.length[segment]
        })
        .fold(0.0, f64::max);
    let winding: f64 = (0..count)
        .map(|segment| {
            (segments.curvature[segment].abs()
                + segments.rest_curvature[segment].abs()
                + params.axis.rest_twist.abs())
                * segments.length[segment]
        })
        .sum();
    let angles = PI + winding;
    let stiffest = stiffest * (1.0 + 2.0 * params.material.shear_modulus_ratio);
    let rounding = f64::EPSILON * angles * (8.0 * count as f64 * reach * size + 64.0 * stiffest);
    let allowed = report.residual.max(params.solver.tolerance) * largest + rounding;
    for (segment, expected) in sizes.into_iter().enumerate() {
        let found = segments.moment[segment].hypot(segments.twist_moment[segment]);
        assert!(
            (found - expected).abs() <= allowed,
            "segment {segment}: {found} {expected} {allowed}: {plant:?}"
        );
    }
}
