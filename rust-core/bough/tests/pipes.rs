//! The composite section: stiffness, rest angle and springback of a bundle of pipes.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::params::{BranchingPattern, Params, Stepping};
use bough::{History, grow};
use support::{heavy_rod, piped_rod};

/// Equations 39 and 40 with equal pipes, from nothing but the ages of the plant: `kappa_n = n^2 kappa_1`, and the
/// composite rest angle is the mean of the angles at which the pipes were laid, weighted with `2k - 1`.
#[test]
fn the_bundle_acts_as_one_spring() {
    let segments = 40;
    let params = piped_rod(50.0, 2.0, segments);
    let mut history = History::new(&params).unwrap();
    let ages: Vec<_> = (1..=segments).map(|step| history.at(step)).collect();
    let last = ages.last().unwrap();
    for segment in 0..segments as usize {
        let joint = if segment == 0 { 0.5 / f64::from(segments) } else { 1.0 / f64::from(segments) };
        // The first pipe is born straight (no tropism); each later one is laid in the shape of the step before.
        let first_pipe = 0.0;
        let birth = segment + 1;
        let laid = (birth + 1..=segments as usize).map(|step| ages[step - 2].segments.curvature[segment]);
        let angles: Vec<f64> = std::iter::once(first_pipe).chain(laid).map(|bend| bend * joint).collect();
        let pipes = angles.len() as f64;
        let weighted: f64 =
            angles.iter().enumerate().map(|(index, angle)| (2.0 * index as f64 + 1.0) * angle).sum();
        let rest = weighted / (pipes * pipes);
        let found = last.segments.rest_curvature[segment] * joint;
        assert!((rest - found).abs() < 1e-12, "segment {segment}: {rest} {found}");
        let section = std::f64::consts::PI * 0.25 * params.axis.radius.powi(4);
        let stiffness = pipes * pipes * params.material.youngs_modulus * section / joint;
        let deviation = (last.segments.curvature[segment] - last.segments.rest_curvature[segment]) * joint;
        let torque = last.segments.moment[segment];
        assert!((stiffness * deviation - torque).abs() < 1e-12 * stiffness, "segment {segment}");
        let radius = params.axis.radius * pipes.sqrt();
        assert!((last.segments.radius[segment] - radius).abs() < 1e-12 * radius);
        let mass = params.material.density * std::f64::consts::PI * radius * radius / f64::from(segments);
        assert!((last.segments.mass[segment] - mass).abs() < 1e-12 * mass);
    }
}

/// Taken off its loads, every joint springs back by its torque over its composite stiffness, and no further.
#[test]
fn springback_is_the_elastic_part_only() {
    for params in [piped_rod(50.0, 2.0, 40), heavy_rod(50.0, 8.0, 40)] {
        let loaded = grow(&params).unwrap();
        let mut unloaded = params.clone();
        unloaded.loads.removed = true;
        let free = grow(&unloaded).unwrap();
        assert_eq!(free.report.residual, 0.0);
        assert_eq!(free.report.stable, Some(true));
        for segment in 0..40 {
            let rigidity = params.material.youngs_modulus
                * std::f64::consts::PI
                * 0.25
                * loaded.segments.radius[segment].powi(4);
            let back = loaded.segments.curvature[segment] - free.segments.curvature[segment];
            let expected = loaded.segments.moment[segment] / rigidity;
            assert!((back - expected).abs() <= 1e-9 * expected.abs(), "segment {segment}: {back} {expected}");
            assert_eq!(free.segments.moment[segment], 0.0);
        }
        // An elastic rod comes back straight; wood that grew bent stays bent.
        let bent = free.segments.curvature.iter().fold(0.0, |most: f64, bend| most.max(bend.abs()));
        assert_eq!(bent > 1e-3, params.growth.thickening == bough::params::Thickening::Pipes);
    }
}

/// Stress against beam theory: without memory the outermost fibre bears `E R (curvature)`.
#[test]
fn stress_is_that_of_the_worst_pipe() {
    let params = heavy_rod(0.0, 2.0, 30);
    let plant = grow(&params).unwrap();
    for segment in 0..30 {
        let radius = plant.segments.radius[segment];
        let section_modulus = std::f64::consts::PI * radius.powi(3) / 4.0;
        let expected = plant.segments.moment[segment].abs() / section_modulus;
        assert!((plant.segments.stress[segment] - expected).abs() <= 1e-12 * expected);
    }
    // Pipes: recomputed by following every pipe from the shapes of all ages, along an axis and through forks.
    let mut forking = piped_rod(50.0, 2.0, 10);
    forking.branching.pattern = BranchingPattern::Bifurcation;
    forking.branching.generations = 2;
    stress_follows_every_pipe(&piped_rod(50.0, 2.0, 30));
    stress_follows_every_pipe(&forking);
}

fn stress_follows_every_pipe(params: &Params) {
    let mut history = History::new(params).unwrap();
    let ages: Vec<_> = (1..=history.steps()).map(|step| history.at(step)).collect();
    let last = ages.last().unwrap();
    for segment in 0..last.segments.parent.len() {
        let mut worst = 0.0_f64;
        let birth = last.segments.birth[segment] as usize;
        let pipes = ages.len() - birth + 1;
        for pipe in 1..=pipes {
            // Without tropism the first pipe is born straight, or at the branching angle, from which bends count.
            let laid = if pipe == 1 { 0.0 } else { ages[birth + pipe - 3].segments.curvature[segment] };
            let radius = last.segments.radius[segment] * (pipe as f64 / pipes as f64).sqrt();
            let strain = radius * (last.segments.curvature[segment] - laid).abs();
            worst = worst.max(params.material.youngs_modulus * strain);
        }
        let found = last.segments.stress[segment];
        assert!((found - worst).abs() <= 1e-11 * worst.max(1.0), "segment {segment}: {found} {worst}");
    }
}

#[test]
fn static_stepping_of_an_elastic_rod_is_what_growth_ends_in() {
    let mut params = heavy_rod(50.0, 8.0, 40);
    let grown = grow(&params).unwrap();
    params.solver.stepping = Stepping::Static;
    let solved = grow(&params).unwrap();
    for (grown, solved) in grown.polylines.points.iter().zip(&solved.polylines.points) {
        assert!((grown - solved).abs() < 1e-10);
    }
}
