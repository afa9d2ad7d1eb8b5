//! Fibre stress, safety factor and the place that breaks first, against beam theory and an independent scan.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod support;

use bough::angle::Degrees;
use bough::params::{BranchingPattern, PRESETS, Params, PointForce, Stepping, Thickening};
use bough::plant::{Section, largest_principal_stress};
use bough::{History, Plant, grow};
use core::f64::consts::PI;

fn off(is: f64, expected: f64) -> f64 {
    (is / expected - 1.0).abs()
}

/// A solid round rod with a force at its tip: `M R / I` everywhere, `4 F (L - s) / (pi R^3)`.
#[test]
fn a_round_rod_is_stressed_as_beam_theory_says() {
    let mut params = Params::default();
    params.axis.elevation = Degrees(0.0);
    params.axis.segments = 50;
    params.axis.segment_length = 0.02;
    params.axis.radius = 0.006;
    // Slopes below 2e-5: what is not linear is below 1e-9.
    params.material.youngs_modulus = 1e14;
    params.loads.gravity = 0.0;
    params.loads.tip_force = [0.0, -3.0, 0.0];
    let plant = grow(&params).unwrap();
    for segment in 0..50 {
        let arm = 1.0 - 0.02 * segment as f64;
        let expected = 4.0 * 3.0 * arm / (PI * 0.006_f64.powi(3));
        assert!(off(plant.segments.stress[segment], expected) < 1e-8, "{segment}");
    }
    let largest = 4.0 * 3.0 / (PI * 0.006_f64.powi(3));
    assert_eq!(plant.report.breaks_first, Some(0));
    assert!(off(plant.report.safety_factor.unwrap(), params.material.modulus_of_rupture / largest) < 1e-8);
    // Twice the load, half the safety: breaking at 1.
    let factor = plant.report.safety_factor.unwrap();
    for (times, broken) in [(0.999, false), (1.001, true)] {
        params.loads.tip_force[1] = -3.0 * factor * times;
        let safety = grow(&params).unwrap().report.safety_factor.unwrap();
        assert_eq!(safety < 1.0, broken);
        assert!(off(safety, 1.0 / times) < 1e-6);
    }
}

/// A cone to a tenth under a tip force is stressed most inside, where `u / r^3` is largest, `u` counted from the tip:
/// at `u = r_tip / (2 c)` with `r = r_tip + c u`. A segment has the radius of its middle and the moment of its base, so
/// that place is found to a segment and its stress to first order in their length.
#[test]
fn a_cone_breaks_inside_where_beam_theory_says() {
    let mut params = Params::default();
    params.axis.elevation = Degrees(0.0);
    params.axis.segments = 1000;
    params.axis.segment_length = 0.001;
    params.axis.radius = 0.01;
    params.axis.taper = 0.1;
    params.material.youngs_modulus = 1e14;
    params.loads.gravity = 0.0;
    params.loads.tip_force = [0.0, -1.0, 0.0];
    params.solver.stepping = Stepping::Static;
    let plant = grow(&params).unwrap();
    let place = 1.0 - 0.001 / (2.0 * 0.009);
    let found = f64::from(plant.report.breaks_first.unwrap()) * 0.001;
    assert!((found - place).abs() < 0.0015, "{found} {place}");
    let radius = 0.001 + 0.009 * (1.0 - place);
    let expected = 4.0 * (1.0 - place) / (PI * radius.powi(3));
    let found = params.material.modulus_of_rupture / plant.report.safety_factor.unwrap();
    println!("cone: {:.1e}", off(found, expected));
    assert!(off(found, expected) < 5e-3);
}

/// Pipes that were laid without load share one strain when a force comes later: the bundle is a solid section.
#[test]
fn pipes_laid_without_load_are_a_solid_section() {
    let mut params = Params::default();
    params.axis.elevation = Degrees(0.0);
    params.axis.segments = 20;
    params.axis.segment_length = 0.05;
    params.axis.radius = 0.002;
    params.growth.thickening = Thickening::Pipes;
    params.material.youngs_modulus = 1e13;
    params.loads.gravity = 0.0;
    params.loads.forces = vec![PointForce { segment: 19, force: [0.0, -2.0, 0.0] }];
    let plant = grow(&params).unwrap();
    for segment in 0..20 {
        let section = Section { birth_radius: 0.002, pipes: 20 - segment as u32 };
        assert!(off(plant.segments.radius[segment], section.radius()) < 1e-14);
        let moment = 2.0 * (1.0 - 0.05 * segment as f64);
        let expected = section.fibre_stress(moment, 0.0);
        assert!(off(plant.segments.stress[segment], expected) < 1e-7, "{segment}");
    }
}

/// Stress of pipes that were laid under load, computed from the curvatures of all ages alone: each pipe is strained by the
/// change of curvature since it was laid, at its own outer radius.
fn stress_by_ages(params: &Params) -> Vec<f64> {
    let mut history = History::new(params).unwrap();
    let plants: Vec<Plant> = (1..=history.steps()).map(|step| history.at(step)).collect();
    let last = plants.last().unwrap();
    let modulus = params.material.youngs_modulus;
    let segments = 0..last.segments.length.len();
    let stress = segments.map(|segment| {
        let birth = last.segments.birth[segment] as usize;
        let now = last.segments.curvature[segment];
        let pipes = last.report.steps as usize - birth + 1;
        let pipe_stress = |pipe: usize| {
            // The first pipe is laid at rest in the rest shape of its birth, pipe p at the end of the step before its own.
            let laid = if pipe == 1 {
                plants[birth - 1].segments.rest_curvature[segment]
            } else {
                plants[birth + pipe - 3].segments.curvature[segment]
            };
            let radius = params.axis.radius * (pipe as f64).sqrt();
            modulus * radius * (now - laid).abs()
        };
        (1..=pipes).map(pipe_stress).fold(0.0, f64::max)
    });
    stress.collect()
}

#[test]
fn pipes_laid_under_load_are_stressed_by_the_change_since() {
    for taken_off in [false, true] {
        let mut params = support::piped_rod(30.0, 0.02, 25);
        params.axis.radius = 0.002;
        params.loads.tip_mass = 0.02;
        params.loads.foliage = 0.05;
        params.loads.foliage_age = 8;
        params.loads.picked = taken_off;
        params.material.youngs_modulus = 2e9;
        let plant = grow(&params).unwrap();
        let mut grown = params.clone();
        grown.loads.picked = false;
        let expected = if taken_off { return_stress(&grown, &plant) } else { stress_by_ages(&params) };
        let largest = expected.iter().copied().fold(0.0, f64::max);
        for (segment, (stress, expected)) in plant.segments.stress.iter().zip(&expected).enumerate() {
            assert!((stress - expected).abs() < 1e-8 * largest, "{segment}: {stress} {expected}");
        }
        let first = expected.iter().position(|&stress| stress == largest).unwrap();
        let found = plant.report.breaks_first.unwrap() as usize;
        assert!(off(expected[found], largest) < 1e-8, "{found} {first}");
        assert!(
            off(plant.report.safety_factor.unwrap(), params.material.modulus_of_rupture / largest) < 1e-8
        );
    }
}

/// As [`stress_by_ages`], for a plant whose last shape is not one it grew through.
fn return_stress(grown: &Params, picked: &Plant) -> Vec<f64> {
    let mut history = History::new(grown).unwrap();
    let plants: Vec<Plant> = (1..=history.steps()).map(|step| history.at(step)).collect();
    let stress = (0..picked.segments.length.len()).map(|segment| {
        let birth = picked.segments.birth[segment] as usize;
        let laid = (birth..plants.len()).map(|step| plants[step - 1].segments.curvature[segment]);
        let first = plants[birth - 1].segments.rest_curvature[segment];
        let pipes = core::iter::once(first).chain(laid).enumerate();
        let strain = |(pipe, laid): (usize, f64)| {
            let radius = grown.axis.radius * ((pipe + 1) as f64).sqrt();
            radius * (picked.segments.curvature[segment] - laid).abs()
        };
        grown.material.youngs_modulus * pipes.map(strain).fold(0.0, f64::max)
    });
    stress.collect()
}

/// The first-breaking segment is that of an independent scan, in trees and around stems too; every preset that is not made
/// to break is whole.
#[test]
fn the_weakest_segment_of_every_preset_is_found_by_a_scan() {
    for preset in PRESETS {
        let params = Params::of_preset(preset);
        let mut history = History::new(&params).unwrap();
        let plant = history.at(preset.step.unwrap_or(u32::MAX));
        let mut order: Vec<usize> = (0..plant.segments.stress.len()).collect();
        order.sort_by(|&a, &b| plant.segments.stress[b].total_cmp(&plant.segments.stress[a]).then(a.cmp(&b)));
        let most = plant.segments.stress[order[0]];
        println!(
            "{}: safety {:?}, segment {:?}",
            preset.id, plant.report.safety_factor, plant.report.breaks_first
        );
        if most == 0.0 {
            assert_eq!((plant.report.breaks_first, plant.report.safety_factor), (None, None));
            continue;
        }
        assert_eq!(plant.report.breaks_first, Some(order[0] as u32), "{}", preset.id);
        assert_eq!(plant.report.safety_factor, Some(params.material.modulus_of_rupture / most));
    }
}

/// A load past the first break is not silent: the plant is shown in equilibrium at that load, and the report says where it breaks.
#[test]
fn a_load_past_the_first_break_is_shown_and_said() {
    let mut params = Params::default();
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.loads.snow = 2000.0;
    let plant = grow(&params).unwrap();
    assert!(plant.report.residual <= params.solver.tolerance);
    let safety = plant.report.safety_factor.unwrap();
    assert!(safety < 1.0);
    let broken = plant.report.breaks_first.unwrap() as usize;
    assert!(plant.segments.stress[broken] > params.material.modulus_of_rupture);
}

#[test]
fn bending_and_twisting_add_as_a_principal_stress() {
    // Mohr's circle by its invariants: s1 + s2 = sigma, s1 s2 = -tau^2.
    for (sigma, tau) in [(3e7, 0.0), (0.0, 2e7), (3e7, 2e7), (-5e6, 1e6)] {
        let first: f64 = largest_principal_stress(sigma, tau);
        let second = sigma.abs() - first;
        assert!((first * second + tau * tau).abs() <= 1e-14 * (first * first));
    }
}

/// An arm across the end of a shaft, with a load at its end: the shaft is bent and twisted, and its stress is what beam theory
/// makes of both, Rankine's criterion.
#[test]
fn bending_and_twisting_stress_together() {
    let mut params = Params::default();
    params.axis.segments = 40;
    params.axis.elevation = Degrees(0.0);
    params.axis.segment_length = 0.01;
    params.material.youngs_modulus = 1e13;
    params.loads.gravity = 0.0;
    // A rod bent by half a turn's quarter in its rest: an arm that goes aside, with a force up at its end.
    params.axis.rest_curvature = 5.0;
    params.axis.rest_curvature_roll = Degrees(90.0);
    params.loads.tip_force = [0.0, 2.0, 0.0];
    params.solver.stepping = Stepping::Static;
    let plant = grow(&params).unwrap();
    let [x, _, z] = plant.tip(0);
    let (bending, twisting) = (2.0 * x, 2.0 * z.abs());
    assert!(twisting > 0.1);
    let radius = params.axis.radius;
    let unit = 4.0 / (core::f64::consts::PI * radius.powi(3));
    let (bent, sheared) = (unit * bending, 0.5 * unit * twisting);
    let expected = 0.5 * bent + (0.25 * bent * bent + sheared * sheared).sqrt();
    let found = plant.segments.stress[0];
    // The base joint is tilted by half a cut's turn, which turns a share of h kappa / 2 of the moments into each other.
    assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
    let section = bough::plant::Section::new(radius);
    let exact = section.fibre_stress(plant.segments.moment[0], plant.segments.twist_moment[0]);
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    assert!(
        (plant.report.safety_factor.unwrap() * found / params.material.modulus_of_rupture - 1.0).abs()
            < 1e-12
    );
}
