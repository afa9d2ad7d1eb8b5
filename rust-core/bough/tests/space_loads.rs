//! What comes upon plants in space: weather from any side, pulls, forces at tips around a stem.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "tests may stop, and round as they like")]

use bough::angle::Degrees;
use bough::mechanics::Status;
use bough::params::{ArrangementPattern, Params};
use bough::{History, Plant, grow};

mod support;
use support::distance;
use support::space::{apart, assert_held, bush, length};

/// Every kind of load that a plant in space can have, after growth: it rests, by the forces that its shape shows, summed
/// here.
#[test]
fn weather_in_space_is_balanced_at_the_shape_shown() {
    let mut bush = bush();
    bush.loads.foliage = 0.01;
    bush.loads.foliage_age = 5;
    bush.loads.tip_mass = 0.001;
    for (wind, snow, picked) in [(6.0, 0.0, false), (0.0, 3.0, false), (0.0, 0.0, true), (4.0, 2.0, true)] {
        let calm = grow(&bush).unwrap();
        let mut params = bush.clone();
        (params.loads.wind, params.loads.snow, params.loads.picked) = (wind, snow, picked);
        params.loads.wind_azimuth = Degrees(70.0);
        let plant = grow(&params).unwrap();
        assert_eq!(plant.report.status, Status::Converged);
        assert!(plant.report.residual <= params.solver.tolerance, "{:?}", plant.report);
        assert!(apart(&plant, &calm, 0.0) > 1e-4 * length(&calm), "nothing has moved");
        assert_held(&plant);
        // Turned with its wind it is the same plant turned.
        params.axis.azimuth.0 += 40.0;
        params.loads.wind_azimuth.0 += 40.0;
        params.solver.tolerance = 1e-13;
        let tighter = grow(&params).unwrap();
        assert!(apart(&tighter, &plant, 40.0) < 1e-7 * length(&plant));
    }
}

/// In a wind the copies around a stem are no longer copies: each leans to where it blows, and that which points against it is
/// lifted or pressed as the same axis alone.
#[test]
fn axes_around_a_stem_lean_with_the_wind() {
    let mut params = Params::default();
    params.axis.segments = 10;
    params.axis.elevation = Degrees(60.0);
    params.arrangement.pattern = ArrangementPattern::Stem;
    params.arrangement.count = 4;
    params.arrangement.interval = 0;
    params.arrangement.divergence = Degrees(90.0);
    let calm = grow(&params).unwrap();
    params.loads.wind = 8.0;
    let blown = grow(&params).unwrap();
    assert_eq!(blown.report.status, Status::Converged);
    for axis in 1..=4 {
        let ([x, ..], [before, ..]) = (blown.tip(axis), calm.tip(axis));
        assert!(x > before + 1e-4, "axis {axis}: {before} to {x}");
        let mut alone = params.clone();
        alone.arrangement.pattern = ArrangementPattern::Single;
        alone.axis.azimuth = Degrees(90.0 * (axis - 1) as f64);
        let one = grow(&alone).unwrap();
        let mut foot = one.tip(0);
        foot[1] += axis as f64 * params.arrangement.spacing;
        assert!(distance(blown.tip(axis), foot) < 1e-12);
    }
}

/// A point held in a wind that blows across the plane.
#[test]
fn a_point_is_held_in_the_wind_in_space() {
    let mut params = Params::default();
    params.loads.wind = 6.0;
    params.loads.wind_azimuth = Degrees(90.0);
    let mut history = History::new(&params).unwrap();
    let [x, y, z] = history.at(40).tip(0);
    let place = [x, y + 0.03, z + 0.03];
    let held = history.hold(39, place).unwrap();
    assert!(held.report.residual <= params.solver.tolerance, "{}", held.report.residual);
    assert_eq!(held.report.stable, Some(true));
    assert!(distance(held.tip(0), place) < 1e-8);
    params.loads.forces = held.params.loads.forces.clone();
    let pulled = grow(&params).unwrap();
    assert!(distance(pulled.tip(0), held.tip(0)) < 1e-8);
}

/// Around a stem, rigid or not, the force at the tip points away from it in each axis's own plane; found by fuzzing.
#[test]
fn around_a_stem_every_tip_is_pulled_outward() {
    let mut params = Params::default();
    params.axis.segments = 8;
    params.arrangement.count = 3;
    params.arrangement.interval = 0;
    params.loads.gravity = 0.0;
    params.loads.tip_force = [0.05, 0.0, 0.0];
    let reach = |plant: &Plant, axis: usize| {
        let [x, _, z] = plant.tip(axis);
        x.hypot(z)
    };
    for (pattern, azimuth) in
        [(ArrangementPattern::FlexibleStem, None), (ArrangementPattern::Stem, Some(Degrees(20.0)))]
    {
        params.arrangement.pattern = pattern;
        // A light that attracts next to nothing makes copies that differ.
        params.tropism.azimuth = azimuth;
        params.tropism.strength = 1e-9;
        params.arrangement.stem_radius = 0.05;
        let pulled = grow(&params).unwrap();
        let mut free = params.clone();
        free.loads.tip_force = [0.0; 3];
        let free = grow(&free).unwrap();
        for axis in 1..=3 {
            assert!(reach(&pulled, axis) > reach(&free, axis) + 1e-4, "axis {axis}");
        }
        assert!((reach(&pulled, 1) / reach(&pulled, 3) - 1.0).abs() < 1e-3);
    }
}

/// A plant whose loads are taken off is held by the hand's force alone, whatever it was grown with and whatever weather there
/// would be, in its plane as in space.
#[test]
fn without_its_loads_a_plant_is_held_by_one_force_alone() {
    for space in [false, true] {
        let mut params = Params::default();
        params.solver.space = space;
        params.growth.thickening = bough::params::Thickening::Pipes;
        params.axis.radius = 0.002;
        params.loads.tip_mass = 0.01;
        (params.loads.wind, params.loads.snow, params.loads.removed) = (8.0, 3.0, true);
        let mut history = History::new(&params).unwrap();
        let [x, y, _] = history.at(40).tip(0);
        let held = history.hold(39, [x, y - 0.1, 0.0]).unwrap();
        let (force, tip) = (held.params.loads.forces[0].force, held.tip(0));
        // The force bends the base by its lever about it.
        let expected = (tip[0] * force[1] - tip[1] * force[0]).abs();
        assert!(expected > 1e-4);
        let found = held.segments.moment[0].abs();
        assert!((found / expected - 1.0).abs() < 1e-8, "in space: {space}: {found} {expected}");
    }
}

/// A bare trunk raises all axes, around a rigid stem and on one that bends.
#[test]
fn a_bare_trunk_raises_the_axes() {
    for pattern in [ArrangementPattern::Stem, ArrangementPattern::FlexibleStem] {
        let mut params = Params::default();
        params.axis.segments = 4;
        params.arrangement.pattern = pattern;
        params.arrangement.count = 3;
        params.arrangement.interval = 0;
        params.loads.gravity = 0.0;
        let low = grow(&params).unwrap();
        params.arrangement.trunk = 0.7;
        let high = grow(&params).unwrap();
        for axis in 0..4 {
            assert!((high.tip(axis)[1] - low.tip(axis)[1] - 0.7).abs() < 1e-12, "axis {axis}");
        }
    }
}
