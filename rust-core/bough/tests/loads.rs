//! Loads against the closed forms of beam theory, where bending is linear, and the honesty of forces that follow the shape.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod support;

use bough::angle::Degrees;
use bough::growth::{AIR, wind, wind_force};
use bough::mechanics::Status;
use bough::params::{Discretization, PRESETS, Params, PointForce, Stepping, Thickening};
use bough::{Plant, grow};
use core::f64::consts::PI;

const LENGTH: f64 = 1.0;
const RADIUS: f64 = 0.01;
const STIFF: f64 = 1e13;

/// A horizontal rod that bends so little (slopes below 1e-5) that what is not linear is below 1e-9, cut finely enough that
/// what the cut leaves (a quarter of h^2) is below 1e-7.
fn stiff_rod() -> Params {
    let mut params = Params::default();
    params.axis.segments = 2000;
    params.axis.segment_length = LENGTH / 2000.0;
    params.axis.radius = RADIUS;
    params.axis.elevation = Degrees(0.0);
    params.material.youngs_modulus = STIFF;
    params.solver.stepping = Stepping::Static;
    params
}

fn rigidity() -> f64 {
    STIFF * 0.25 * PI * RADIUS.powi(4)
}

/// Weight of a metre, N.
fn weight(params: &Params) -> f64 {
    params.material.density * PI * RADIUS * RADIUS * params.loads.gravity
}

/// Relative distance.
fn off(is: f64, expected: f64) -> f64 {
    (is / expected - 1.0).abs()
}

fn converged(plant: &Plant) {
    assert_eq!(plant.report.status, Status::Converged);
    assert!(plant.report.residual <= plant.params.solver.tolerance, "{}", plant.report.residual);
}

#[test]
fn a_tip_load_and_its_own_weight_bend_a_rod_as_beam_theory_says() {
    let mut params = stiff_rod();
    params.loads.tip_force = [0.0, -2.0, 0.0];
    let plant = grow(&params).unwrap();
    let sag = weight(&params) * LENGTH.powi(4) / 8.0 / rigidity() + 2.0 * LENGTH.powi(3) / 3.0 / rigidity();
    println!("tip load and weight: {:.1e}", off(-plant.tip(0)[1], sag));
    assert!(off(-plant.tip(0)[1], sag) < 1e-6);
    let moment = weight(&params) * LENGTH * LENGTH / 2.0 + 2.0 * LENGTH;
    assert!(off(-plant.segments.moment[0], moment) < 1e-9);
    converged(&plant);
}

#[test]
fn a_fruit_bends_a_rod_as_beam_theory_says() {
    let mut params = stiff_rod();
    params.material.density = 1e-6;
    params.loads.tip_mass = 0.3;
    let plant = grow(&params).unwrap();
    let sag = 0.3 * params.loads.gravity * LENGTH.powi(3) / 3.0 / rigidity();
    println!("fruit: {:.1e}", off(-plant.tip(0)[1], sag));
    assert!(off(-plant.tip(0)[1], sag) < 1e-6);
    // Picked, it is as if there had been none; without pipes nothing is remembered.
    params.loads.picked = true;
    let picked = grow(&params).unwrap();
    converged(&picked);
    assert!(picked.tip(0)[1].abs() < 1e-6 * sag);
}

#[test]
fn leaves_on_all_wood_are_as_so_much_more_weight() {
    let mut params = stiff_rod();
    params.loads.foliage = 0.7;
    params.loads.foliage_age = 100_000;
    let plant = grow(&params).unwrap();
    let line = weight(&params) + 0.7 * params.loads.gravity;
    assert!(off(-plant.tip(0)[1], line * LENGTH.powi(4) / 8.0 / rigidity()) < 1e-6);
    assert!(off(plant.report.gravity_number, line * LENGTH.powi(3) / rigidity()) < 1e-12);
    // Leaves on the outer part alone, from a to the end: w (L^4/8 - a^3 L/6 + a^4/24) (superposition).
    params.loads.foliage_age = 500;
    params.material.density = 1e-6;
    let plant = grow(&params).unwrap();
    let from: f64 = 0.75;
    let shape = LENGTH.powi(4) / 8.0 - from.powi(3) * LENGTH / 6.0 + from.powi(4) / 24.0;
    assert!(off(-plant.tip(0)[1], 0.7 * params.loads.gravity * shape / rigidity()) < 1e-6);
}

#[test]
fn a_wind_bends_a_mast_as_beam_theory_says() {
    for (azimuth, side) in [(0.0, 1.0), (180.0, -1.0)] {
        let mut params = stiff_rod();
        params.axis.elevation = Degrees(90.0);
        params.loads.gravity = 0.0;
        params.loads.wind = 12.0;
        params.loads.wind_azimuth = Degrees(azimuth);
        let plant = grow(&params).unwrap();
        let line = 0.5 * AIR * params.loads.drag_coefficient * 2.0 * RADIUS * 12.0 * 12.0;
        let push = line * LENGTH.powi(4) / 8.0 / rigidity();
        println!("wind: {:.1e}", off(side * plant.tip(0)[0], push));
        assert!(off(side * plant.tip(0)[0], push) < 1e-6);
        converged(&plant);
        // Leaves add their area, whichever way they hang.
        params.loads.foliage = 0.2;
        params.loads.foliage_age = 100_000;
        let plant = grow(&params).unwrap();
        let leaves = 0.2 * params.loads.foliage_area * params.loads.foliage_drag;
        let line = line + 0.5 * AIR * leaves * 12.0 * 12.0;
        assert!(off(side * plant.tip(0)[0], line * LENGTH.powi(4) / 8.0 / rigidity()) < 1e-6);
    }
}

#[test]
fn snow_lies_on_what_is_seen_from_above() {
    for (elevation, projected) in [(0.0_f64, 1.0), (60.0, 0.5)] {
        let mut params = stiff_rod();
        params.axis.elevation = Degrees(elevation);
        params.material.density = 1e-6;
        params.loads.snow = 0.2;
        let plant = grow(&params).unwrap();
        converged(&plant);
        let line = 0.2 * 2.0 * RADIUS * projected * params.loads.gravity;
        let moment = line * LENGTH * LENGTH / 2.0 * elevation.to_radians().cos();
        assert!(off(-plant.segments.moment[0], moment) < 1e-6);
    }
}

/// Forces that follow the shape: the torques of the forces at the shape that is shown, summed here from its points, are what
/// its springs bear.
#[test]
fn the_residual_is_that_of_the_drag_at_the_shape_shown() {
    for discretization in [Discretization::SecondOrder, Discretization::Paper] {
        for (modulus, speed) in [(1e9, 5.0), (1e8, 10.0), (1e7, 10.0), (1e7, 30.0), (1e6, 60.0), (1e5, 30.0)]
        {
            let mut params = Params::default();
            params.solver.discretization = discretization;
            params.axis.elevation = Degrees(80.0);
            params.axis.segments = 30;
            params.axis.segment_length = 1.0 / 30.0;
            params.axis.radius = 0.004;
            params.material.youngs_modulus = modulus;
            params.loads.foliage = 0.02;
            params.loads.foliage_age = 12;
            params.loads.snow = 1.5;
            params.loads.wind = speed;
            let plant = grow(&params).unwrap();
            println!("E {modulus:e}, {speed} m/s: {:?}", plant.report);
            converged(&plant);
            let expected = moments(&plant);
            let largest = expected.iter().fold(0.0_f64, |most, moment| most.max(moment.abs()));
            for (moment, expected) in plant.segments.moment.iter().zip(&expected) {
                assert!((moment - expected).abs() <= 1e-9 * largest, "{moment} {expected}");
            }
        }
    }
}

/// Moment about the base of every segment of one axis, from the points that the result shows.
fn moments(plant: &Plant) -> Vec<f64> {
    let params = &plant.params;
    let point = |index: usize| -> [f64; 2] {
        [plant.polylines.points[3 * index], plant.polylines.points[3 * index + 1]]
    };
    let segments = plant.segments.length.len();
    let steps = plant.report.steps;
    let mut nodes = vec![[0.0; 2]; segments + 1];
    for segment in 0..segments {
        let ([x0, y0], [x1, y1]) = (point(segment), point(segment + 1));
        let length = plant.segments.length[segment];
        let along = [(x1 - x0) / length, (y1 - y0) / length, 0.0];
        let young = steps - plant.segments.birth[segment] < params.loads.foliage_age;
        let leaves = if young { params.loads.foliage * length } else { 0.0 };
        let side = 2.0 * plant.segments.radius[segment] * length;
        let [mut x, mut y, _] = wind_force(wind(params), along, params.loads.drag_coefficient * side);
        let area = leaves * params.loads.foliage_area;
        x += 0.5 * AIR * params.loads.foliage_drag * area * params.loads.wind.powi(2);
        let snow = params.loads.snow * (side * along[0].abs() + area);
        y -= (plant.segments.mass[segment] + leaves + snow) * params.loads.gravity;
        let below = if params.solver.discretization == Discretization::Paper { 0.0 } else { 0.5 };
        for (node, share) in [(segment, below), (segment + 1, 1.0 - below)] {
            nodes[node][0] += share * x;
            nodes[node][1] += share * y;
        }
    }
    let moment = |segment: usize| {
        let [x0, y0] = point(segment);
        let about = |node: usize| {
            let [x, y] = point(node);
            (x - x0) * nodes[node][1] - (y - y0) * nodes[node][0]
        };
        (segment + 1..=segments).map(about).sum()
    };
    (0..segments).map(moment).collect()
}

/// A point held in the wind: the force that holds it is in balance with the drag on the shape as it is then held.
#[test]
fn a_point_is_held_in_the_wind() {
    let mut params = Params::default();
    params.axis.elevation = Degrees(90.0);
    params.loads.wind = 8.0;
    let mut history = bough::History::new(&params).unwrap();
    let free = history.at(40);
    let [x, y, _] = free.tip(0);
    let held = history.hold(39, [x - 0.1, y + 0.08, 0.0]).unwrap();
    assert!(held.report.residual <= params.solver.tolerance && held.report.stable == Some(true));
    assert!((held.tip(0)[0] - x + 0.1).abs() < 1e-9);
    params.loads.forces = held.params.loads.forces.clone();
    let pulled = grow(&params).unwrap();
    converged(&pulled);
    assert!(support::distance(pulled.tip(0), held.tip(0)) < 1e-8);
    assert_eq!(history.plant(), free);
}

/// The branch grew with its fruit, and the wood laid down meanwhile remembers: picked, it rises again, by less than it sank.
#[test]
fn an_apple_branch_rises_less_than_it_sank() {
    let mut params = Params::default();
    params.axis.elevation = Degrees(40.0);
    params.axis.radius = 0.002;
    params.axis.segments = 30;
    params.axis.segment_length = 0.03;
    params.material.youngs_modulus = 1.1e9;
    params.growth.thickening = Thickening::Pipes;
    let height = |mass: f64, picked: bool, thickening: Thickening| {
        let mut params = params.clone();
        params.loads.tip_mass = mass;
        params.loads.picked = picked;
        params.growth.thickening = thickening;
        if thickening == Thickening::None {
            params.axis.radius = 0.006;
        }
        let plant = grow(&params).unwrap();
        converged(&plant);
        plant.tip(0)[1]
    };
    let sank = height(0.0, false, Thickening::Pipes) - height(0.05, false, Thickening::Pipes);
    let rose = height(0.05, true, Thickening::Pipes) - height(0.05, false, Thickening::Pipes);
    println!("sank {sank:.3} m, rose {rose:.3} m");
    assert!(rose > 0.01 * sank && rose < 0.9 * sank);
    // Without thickening nothing is remembered: it rises all the way.
    let sank = height(0.0, false, Thickening::None) - height(0.05, false, Thickening::None);
    let rose = height(0.05, true, Thickening::None) - height(0.05, false, Thickening::None);
    assert!(sank > 0.01 && (rose / sank - 1.0).abs() < 1e-8);
}

/// Forces by hand and weather act together.
#[test]
fn a_pull_against_the_wind_brings_a_mast_back() {
    let mut params = stiff_rod();
    params.axis.segments = 200;
    params.axis.segment_length = LENGTH / 200.0;
    params.axis.elevation = Degrees(90.0);
    params.loads.gravity = 0.0;
    params.loads.wind = 10.0;
    let line = 0.5 * AIR * 2.0 * RADIUS * 100.0;
    // As wind and tip force bend: w L^4 / 8 = F L^3 / 3.
    params.loads.forces = vec![PointForce { segment: 199, force: [-0.375 * line * LENGTH, 0.0, 0.0] }];
    let plant = grow(&params).unwrap();
    converged(&plant);
    assert!(plant.tip(0)[0].abs() < 1e-4 * line * LENGTH.powi(4) / 8.0 / rigidity());
}

/// The search for a shape at rest in weather is given up after a thousand iterations: what comes to rest must not be near that.
#[test]
fn presets_in_storms_come_to_rest_long_before_the_search_is_given_up() {
    let (mut rested, mut longest) = (0, 0);
    for preset in PRESETS {
        let mut params = Params::of_preset(preset);
        let calm = grow(&params).unwrap().report.iterations;
        for (wind, snow) in [(5.0, 0.0), (20.0, 0.0), (40.0, 0.0), (0.0, 20.0), (15.0, 5.0)] {
            (params.loads.wind, params.loads.snow) = (wind, snow);
            let report = grow(&params).unwrap().report;
            if report.status == Status::Converged {
                rested += 1;
                longest = longest.max(report.iterations.saturating_sub(calm));
            }
        }
    }
    println!("{rested} of {} rest, after at most {longest} iterations", 5 * PRESETS.len());
    assert!(rested > 4 * PRESETS.len() && longest < 500, "{rested} {longest}");
}
