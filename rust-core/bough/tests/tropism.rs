//! The one rule for tropism: equation 73 on each joint's length.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::angle::Degrees;
use bough::grow;
use bough::growth::turned;
use bough::params::{Discretization, Params};
use support::{distance, extrapolated, fitted_order, heavy_rod};

/// phi0, lambda, phi1 in degrees.
const EQUATION_73: &[(f64, f64, f64)] = &[
    (30.0, 0.1, 27.256826761),
    (30.0, 0.5, 18.461938415),
    (30.0, 1.0, 11.2592602875),
    (30.0, 2.0, 4.15361136259),
    (30.0, 4.0, 0.562371970046),
    (90.0, 0.1, 84.2799475412),
    (90.0, 0.5, 62.4761916077),
    (90.0, 1.0, 40.3950625791),
    (90.0, 2.0, 15.414626807),
    (90.0, 4.0, 2.09858297042),
];

#[test]
fn equation_73_as_listed() {
    for &(before, lambda, after) in EQUATION_73 {
        let found = turned(before.to_radians(), lambda).to_degrees();
        println!("phi0 {before}, lambda {lambda}: phi1 {found:.10} (listed {after})");
        assert!((found - after).abs() < 1e-9);
        assert_eq!(turned(-before.to_radians(), lambda), -turned(before.to_radians(), lambda));
    }
}

#[test]
fn turns_compose() {
    for degrees in [-170.0, -30.0, 1e-6, 30.0, 90.0, 179.0] {
        for parts in [2, 7, 100] {
            let mut angle = f64::to_radians(degrees);
            let whole = turned(angle, 1.7);
            for _ in 0..parts {
                angle = turned(angle, 1.7 / f64::from(parts));
            }
            assert!((angle - whole).abs() < 1e-12, "{degrees} degrees in {parts} parts");
        }
    }
}

/// Equation 66 solved exactly: the slope of a turn is minus the sine.
#[test]
fn a_turn_follows_the_sine_law() {
    for degrees in [10.0, 90.0, 150.0] {
        let angle = f64::to_radians(degrees);
        let step = 1e-5;
        let slope = (turned(angle, 1.0 + step) - turned(angle, 1.0 - step)) / (2.0 * step);
        assert!((slope + turned(angle, 1.0).sin()).abs() < 1e-9);
    }
}

fn turning_axis(segments: u32, gravity: f64) -> Params {
    let mut params = heavy_rod(-30.0, 3.0, segments);
    params.loads.gravity = gravity;
    params.tropism.elevation = Degrees(70.0);
    params.tropism.strength = 3.0;
    params
}

/// Without weight the axis is the curve `d(angle)/ds = -k sin(angle)`, whose end is known.
#[test]
fn a_turning_axis_converges_with_second_order() {
    let cuts = [20, 40, 80, 160, 320];
    for gravity in [0.0, 9.81] {
        let tips = cuts.map(|segments| grow(&turning_axis(segments, gravity)).unwrap().tip(0));
        let limit = if gravity == 0.0 {
            turning_curve()
        } else {
            [0, 1, 2].map(|axis| extrapolated(&cuts, &tips.map(|tip| tip[axis]), &[1, 2, 3]))
        };
        let errors = tips.map(|tip| distance(tip, limit));
        let order = fitted_order(&cuts[..4], &errors[..4]);
        println!("gravity {gravity}: limit {limit:.7?}, order {order:.3}");
        for (segments, (tip, error)) in cuts.iter().zip(tips.iter().zip(errors)) {
            println!("  {segments:3} segments: tip {tip:.7?}, {error:.2e} L off");
        }
        assert!((1.8..2.2).contains(&order));
        assert!(errors[0] < 1e-3);
    }
}

/// The end of the curve that an unloaded axis of length 1 follows, by Simpson's rule on the exact angle.
fn turning_curve() -> [f64; 3] {
    let (sought, start, strength) = (70_f64.to_radians(), -100_f64.to_radians(), 3.0);
    let angle = |s: f64| sought + 2.0 * ((0.5 * start).tan() * (-strength * s).exp()).atan();
    let parts = 2000;
    let mut end = [0.0; 3];
    for part in 0..=parts {
        let weight = match part {
            0 => 1.0,
            part if part == parts => 1.0,
            part if part % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let angle = angle(f64::from(part) / f64::from(parts));
        end[0] += weight * angle.cos() / (3.0 * f64::from(parts));
        end[1] += weight * angle.sin() / (3.0 * f64::from(parts));
    }
    end
}

#[test]
fn no_strength_leaves_growth_alone_to_the_bit() {
    let mut params = heavy_rod(20.0, 5.0, 30);
    let plain = grow(&params).unwrap();
    params.tropism.elevation = Degrees(-70.0);
    assert_eq!(grow(&params).unwrap().polylines, plain.polylines);
}

#[test]
fn full_strength_makes_new_wood_seek_the_direction_at_once() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        let mut params = heavy_rod(-30.0, 3.0, 30);
        params.loads.gravity = 0.0;
        params.tropism.elevation = Degrees(45.0);
        params.tropism.strength = 1e6;
        params.solver.discretization = discretization;
        let plant = grow(&params).unwrap();
        let [x, y] = [0, 1].map(|axis| plant.polylines.points[3 + axis] * 30.0);
        let first = y.atan2(x).to_degrees();
        // The paper's first segment keeps the elevation.
        let expected = if discretization == Discretization::Paper { -30.0 } else { 45.0 };
        assert!((first - expected).abs() < 1e-9);
        let [x, y] = [0, 1].map(|axis| plant.polylines.points[90 + axis] - plant.polylines.points[87 + axis]);
        assert!((y.atan2(x).to_degrees() - 45.0).abs() < 1e-9);
    }
}

/// New wood that points exactly away has no side to turn to: it keeps its direction, at every strength.
#[test]
fn exactly_away_is_a_fixed_point() {
    for strength in [0.1, 1.0, 100.0, 1e6, 1e9] {
        for elevation in [-90.0, 0.0, 37.0] {
            let mut params = heavy_rod(elevation, 3.0, 20);
            params.loads.gravity = 0.0;
            params.tropism.elevation =
                Degrees(if elevation > 0.0 { elevation - 180.0 } else { elevation + 180.0 });
            params.tropism.strength = strength;
            let tip = grow(&params).unwrap().tip(0);
            let straight = [elevation.to_radians().cos(), elevation.to_radians().sin(), 0.0];
            assert!(distance(tip, straight) < 1e-12, "{elevation} degrees, strength {strength}: {tip:?}");
        }
    }
}
