//! Plants in space: the planar ones turned and computed in space, and what has no plane.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "tests may stop, and round as they like")]

use bough::angle::Degrees;
use bough::mechanics::Status;
use bough::params::{
    ArrangementPattern, BranchingPattern, Discretization, PRESETS, Params, Stepping, Thickening, check,
};
use bough::{History, Plant, grow};

mod support;
use support::space::{all_planar, apart, assert_held, bush, length};
use support::{distance, heavy_rod};

fn assert_same(name: &str, space: &Plant, plane: &Plant, degrees: f64) {
    let off = apart(space, plane, degrees) / length(plane);
    assert!(off < 1e-9, "{name} at {degrees}: {off:e} L");
    assert_eq!(space.report.status, plane.report.status, "{name}");
    // A bow that is stable in its plane may fall over sideways, which rods in space alone can tell.
    assert!(space.report.stable <= plane.report.stable, "{name}");
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    for (here, there) in [
        (&space.segments.moment, &plane.segments.moment),
        (&space.segments.curvature, &plane.segments.curvature),
        (&space.segments.rest_curvature, &plane.segments.rest_curvature),
        (&space.segments.stress, &plane.segments.stress),
    ] {
        let size = largest(there);
        for (here, there) in here.iter().zip(there) {
            // In space these are sizes.
            assert!((here - there.abs()).abs() <= 1e-7 * size + 1e-12, "{name}: {here} {there}");
        }
    }
    assert_eq!(space.segments.parent, plane.segments.parent);
    assert_eq!(space.segments.point, plane.segments.point);
    assert!(
        largest(&space.segments.twist_moment) <= 1e-9 * largest(&plane.segments.moment) + 1e-300,
        "{name}"
    );
}

/// Every preset, in both discretizations, turned by some azimuth: what is left over at the tolerance of both is below 1e-9 L
/// where it is tightened.
#[test]
fn planar_plants_are_the_same_in_space() {
    for (index, preset) in PRESETS.iter().enumerate() {
        for discretization in [Discretization::SecondOrder, Discretization::Paper] {
            let mut params = Params::of_preset(preset);
            params.solver.discretization = discretization;
            params.solver.tolerance = 1e-13;
            let plane = grow(&params).unwrap();
            params.solver.space = true;
            params.axis.azimuth = Degrees([0.0, 30.0, -137.5, 200.0][index % 4]);
            // The wind turns with the plant, as far as it may.
            let blown = params.loads.wind_azimuth.0 + params.axis.azimuth.0;
            params.loads.wind_azimuth = Degrees(blown - 360.0 * (blown / 360.0).round());
            let space = grow(&params).unwrap();
            assert_same(preset.id, &space, &plane, params.axis.azimuth.0);
            // Turned in the plane it is the same as well.
            params.solver.space = false;
            let planar = grow(&params).unwrap();
            assert!(apart(&planar, &plane, params.axis.azimuth.0) < 1e-12 * length(&plane), "{}", preset.id);
        }
    }
}

#[test]
fn loads_bends_and_mirrored_forks_are_the_same_in_space() {
    for discretization in [Discretization::SecondOrder, Discretization::Paper] {
        for stepping in [Stepping::Exact, Stepping::Static] {
            let mut params = all_planar();
            params.solver.discretization = discretization;
            params.solver.stepping = stepping;
            let plane = grow(&params).unwrap();
            params.solver.space = true;
            assert_same("all", &grow(&params).unwrap(), &plane, 0.0);
            params.loads.removed = true;
            let relaxed = grow(&params).unwrap();
            params.solver.space = false;
            assert_same("relaxed", &relaxed, &grow(&params).unwrap(), 0.0);
        }
    }
}

#[test]
fn a_plant_turned_about_the_vertical_is_the_same_plant_turned() {
    let mut params = bush();
    for light in [None, Some(Degrees(50.0))] {
        params.axis.azimuth = Degrees(0.0);
        params.tropism.azimuth = light;
        let plant = grow(&params).unwrap();
        assert_eq!(plant.report.status, Status::Converged);
        params.axis.azimuth = Degrees(111.0);
        params.tropism.azimuth = light.map(|light| Degrees(light.0 + 111.0));
        let other = grow(&params).unwrap();
        assert!(apart(&other, &plant, 111.0) < 1e-10 * length(&plant));
        for (here, there) in other.segments.twist_moment.iter().zip(&plant.segments.twist_moment) {
            assert!((here - there).abs() < 1e-10);
        }
    }
    // Light from aside draws the plant out of the plane that it would keep.
    let mut params = Params::default();
    params.tropism.elevation = Degrees(20.0);
    params.tropism.strength = 3.0;
    params.tropism.azimuth = Some(Degrees(90.0));
    let tip = grow(&params).unwrap().tip(0);
    assert!(tip[2] < -0.3, "{tip:?}");
    params.tropism.azimuth = Some(Degrees(-90.0));
    let other = grow(&params).unwrap().tip(0);
    assert!(distance(tip, [other[0], other[1], -other[2]]) < 1e-9);
}

/// Light from behind, in the plane of the axis: the planar path knows it too.
#[test]
fn light_from_behind_needs_no_space() {
    let mut params = Params::default();
    params.tropism.elevation = Degrees(60.0);
    params.tropism.strength = 2.0;
    params.tropism.azimuth = Some(Degrees(180.0));
    params.material.youngs_modulus = 5e9;
    params.solver.tolerance = 1e-13;
    let plane = grow(&params).unwrap();
    params.solver.space = true;
    assert_same("behind", &grow(&params).unwrap(), &plane, 0.0);
}

/// The moment at a base is that of all weights beyond about it.
#[test]
fn the_base_holds_the_moment_of_all_loads() {
    let mut all: Vec<(&str, Params)> =
        PRESETS.iter().map(|preset| (preset.id, Params::of_preset(preset))).collect();
    all.push(("bush", bush()));
    let mut stem = flexible_stem();
    stem.arrangement.stem_elevation = Degrees(75.0);
    all.push(("flexible stem", stem));
    for (id, mut params) in all {
        println!("{id}");
        if params.arrangement.pattern == ArrangementPattern::Stem {
            params.arrangement.pattern = ArrangementPattern::Single;
        }
        let plant = grow(&params).unwrap();
        assert_held(&plant);
    }
}

#[test]
fn built_in_bend_and_twist_make_a_helix() {
    let mut params = Params::default();
    params.loads.gravity = 0.0;
    params.axis.segments = 400;
    params.axis.segment_length = 0.01;
    params.axis.rest_curvature = 3.0;
    params.axis.rest_twist = 2.0;
    let plant = grow(&params).unwrap();
    // Radius 3/13, pitch 4 pi/13: the distance of points half a turn apart.
    let radius = 3.0 / 13.0;
    let (turn, pitch) = (2.0 * std::f64::consts::PI / 13_f64.sqrt(), 4.0 * std::f64::consts::PI / 13.0);
    let along = |distance: f64| {
        let (at, share) = ((distance / 0.01).floor() as usize, (distance / 0.01).fract());
        let point = |index: usize| [0, 1, 2].map(|axis| plant.polylines.points[3 * index + axis]);
        let (a, b) = (point(at), point(at + 1));
        [0, 1, 2].map(|axis| a[axis] + share * (b[axis] - a[axis]))
    };
    let whole = distance(along(0.1), along(0.1 + turn));
    assert!((whole / pitch - 1.0).abs() < 1e-4, "{whole} {pitch}");
    let half = distance(along(0.1), along(0.1 + 0.5 * turn));
    let expected = (4.0 * radius * radius + 0.25 * pitch * pitch).sqrt();
    assert!((half / expected - 1.0).abs() < 1e-4, "{half} {expected}");
}

/// Growth with all that is built in converges with second order when the axis is cut finer, but for growth's own first order:
/// grown without load it is of second order alone.
#[test]
fn built_in_bend_and_tropism_are_cut_to_second_order() {
    let tip = |segments: u32| {
        let mut params = Params::default();
        params.loads.gravity = 0.0;
        params.axis.segments = segments;
        params.axis.segment_length = 1.0 / f64::from(segments);
        params.axis.rest_curvature = 2.0;
        params.axis.rest_curvature_roll = Degrees(60.0);
        params.axis.rest_twist = 3.0;
        params.tropism.elevation = Degrees(10.0);
        params.tropism.azimuth = Some(Degrees(70.0));
        params.tropism.strength = 2.0;
        grow(&params).unwrap().tip(0)
    };
    let tips = [20, 40, 80, 160].map(tip);
    let steps: Vec<f64> = tips.windows(2).map(|pair| distance(pair[0], pair[1])).collect();
    for pair in steps.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }
}

fn flexible_stem() -> Params {
    let mut params = Params::default();
    params.arrangement.pattern = ArrangementPattern::FlexibleStem;
    params.arrangement.count = 6;
    params.axis.segments = 10;
    params.axis.elevation = Degrees(20.0);
    params.axis.radius = 0.003;
    params
}

#[test]
fn a_stem_bends_and_twists_under_its_axes() {
    let params = flexible_stem();
    let plant = grow(&params).unwrap();
    assert_eq!((plant.report.status, plant.report.steps), (Status::Converged, 20));
    assert_eq!(plant.polylines.offsets.len(), 8);
    assert_eq!(plant.segments.parent.len(), 6 * 11);
    // Axis 0 is the stem; the others stand on its segments.
    for segment in 0..plant.segments.parent.len() {
        let (axis, parent) = (plant.segments.axis[segment], plant.segments.parent[segment]);
        assert_eq!(plant.segments.order[segment], u32::from(axis > 0));
        if parent >= 0 && plant.segments.axis[parent as usize] != axis {
            assert_eq!((plant.segments.axis[parent as usize], axis > 0), (0, true));
        }
    }
    // A stiff stem stands like the rigid one, and the axes on it as around that.
    let mut stiff = params.clone();
    stiff.arrangement.stem_radius = 10.0;
    stiff.arrangement.spacing = 0.4;
    stiff.arrangement.interval = 0;
    let on_stiff = grow(&stiff).unwrap();
    stiff.arrangement.pattern = ArrangementPattern::Stem;
    let rigid = grow(&stiff).unwrap();
    for (axis, copy) in (1..=6).zip(1..=6) {
        assert!(distance(on_stiff.tip(axis), rigid.tip(copy)) < 1e-6, "axis {axis}");
    }
    // One arm to the side of a level stem twists it: by the weight times the arm.
    let mut level = flexible_stem();
    level.arrangement.count = 1;
    level.arrangement.stem_elevation = Degrees(0.0);
    level.axis.azimuth = Degrees(90.0);
    level.axis.elevation = Degrees(0.0);
    level.material.youngs_modulus = 1e13;
    let plant = grow(&level).unwrap();
    let own: f64 = plant.segments.mass[1..].iter().sum();
    let expected = own * 9.81 * 0.5 * 10.0 * level.axis.segment_length;
    assert!(
        (plant.segments.twist_moment[0].abs() / expected - 1.0).abs() < 1e-3,
        "{:?}",
        plant.segments.twist_moment
    );
}

#[test]
fn around_a_stem_all_axes_seek_one_light() {
    let mut params = Params::default();
    params.arrangement.pattern = ArrangementPattern::Stem;
    params.arrangement.count = 4;
    params.arrangement.divergence = Degrees(90.0);
    params.arrangement.interval = 0;
    params.axis.segments = 12;
    params.tropism.elevation = Degrees(30.0);
    params.tropism.strength = 4.0;
    let own = grow(&params).unwrap();
    params.tropism.azimuth = Some(Degrees(0.0));
    let mut history = History::new(&params).unwrap();
    let lit = history.at(12);
    // The one that grows towards the light is as before; the one that grew away turns back to it.
    assert!(distance(own.tip(1), lit.tip(1)) < 1e-9);
    assert!(lit.tip(3)[0] > own.tip(3)[0] + 0.1);
    // The two to the sides are mirror images of each other, at their heights.
    let (left, right) = (lit.tip(2), lit.tip(4));
    assert!(distance([left[0], left[1] - 0.16, left[2]], [right[0], right[1] - 0.32, -right[2]]) < 1e-8);
    let held = history.hold(20, [0.3, 0.5, -0.3]).unwrap();
    assert!(held.params.loads.forces[0].force.iter().any(|force| *force != 0.0));
    assert_eq!(history.at(12), lit);
}

/// The pointer holds any point at any place of space that is within reach.
#[test]
fn points_are_held_in_space() {
    // What lies in a plane, though it is computed in space, is drawn out of it as well.
    let mut planar = Params::default();
    planar.solver.space = true;
    // Limp enough that it can be drawn on in any direction.
    planar.material.youngs_modulus /= 10.0;
    let mut turned = planar.clone();
    turned.axis.azimuth = Degrees(50.0);
    for (params, segment) in [(bush(), 60), (flexible_stem(), 30), (planar, 30), (turned, 39)] {
        let mut history = History::new(&params).unwrap();
        let free = history.at(history.steps());
        let point = 3 * free.segments.point[segment] as usize;
        let place = |plant: &Plant| [0, 1, 2].map(|axis| plant.polylines.points[point + axis]);
        let size = 0.05 * length(&free);
        for aim in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.5, -0.5, 0.5]] {
            let start = place(&free);
            let wanted = [0, 1, 2].map(|axis| start[axis] + size * aim[axis]);
            let held = history.hold(segment as u32, wanted).unwrap();
            assert_eq!(held.report.status, Status::Converged);
            assert!(distance(place(&held), wanted) < 1e-8 * length(&free), "{aim:?}");
            // Given as a force it is the same shape.
            let mut pulled = params.clone();
            pulled.loads.forces = held.params.loads.forces.clone();
            let pulled = grow(&pulled).unwrap();
            if held.report.stable == Some(true) {
                assert!(apart(&pulled, &held, 0.0) < 1e-6 * length(&free), "{aim:?}");
            }
        }
        assert_eq!(history.plant(), free);
    }
}

/// Solved at once, from stiff to limp: twigs that snap over by the hundred do not wait for each other. Loads used to be
/// raised by guesses that nobody had corrected.
#[test]
fn floppy_trees_come_to_rest_within_60_iterations() {
    for stiffness in [5e9, 5e8, 5e7, 5e6, 5e5] {
        let mut params = Params::default();
        params.axis.segments = 15;
        params.axis.segment_length = 0.02;
        params.axis.radius = 0.002;
        params.axis.elevation = Degrees(70.0);
        params.material.youngs_modulus = stiffness;
        params.growth.thickening = Thickening::Pipes;
        params.branching.pattern = BranchingPattern::Bifurcation;
        params.branching.generations = 7;
        params.branching.roll = Degrees(75.0);
        params.tropism.strength = 1.0;
        params.solver.stepping = Stepping::Static;
        let report = grow(&params).unwrap().report;
        assert_eq!(report.status, Status::Converged, "{stiffness:e}");
        assert_eq!(report.stable, Some(true), "{stiffness:e}");
        assert!(report.iterations <= 60, "{stiffness:e}: {}", report.iterations);
    }
}

/// What does not fit is refused by name.
#[test]
fn bad_input_is_named() {
    for ratio in [0.0, -1.0, f64::NAN] {
        let mut params = Params::default();
        params.material.shear_modulus_ratio = ratio;
        assert_eq!(check(&params)[0].path, "material.shearModulusRatio");
    }
    let mut params = Params::default();
    params.axis.rest_twist = 1.0;
    params.solver.method = bough::params::Method::Euler;
    assert_eq!(check(&params)[0].path, "solver.method");
    let mut params = heavy_rod(50.0, 5.0, 10);
    params.tropism.azimuth = Some(Degrees(f64::INFINITY));
    assert_eq!((check(&params)[0].path, check(&params)[0].code), ("tropism.azimuth", "notFinite"));
}

/// Heavy and steep: two stable equilibria and one that is not (60 degrees, q = 30). In space, too, growth and a load raised at
/// once lead to the physical one.
#[test]
fn the_physical_branch_is_followed_in_space() {
    for (elevation, q, segments) in [(60.0, 30.0, 80), (80.0, 25.0, 60), (45.0, 60.0, 40), (85.0, 100.0, 40)]
    {
        let mut params = heavy_rod(elevation, q, segments);
        let plane = grow(&params).unwrap();
        // Built-in twist leaves the plane to the solver alone: a round rod bends as without it.
        params.axis.rest_twist = 0.3;
        for stepping in [Stepping::Exact, Stepping::Static] {
            params.solver.stepping = stepping;
            let space = grow(&params).unwrap();
            assert_eq!((space.report.status, space.report.stable), (Status::Converged, Some(true)));
            assert!(
                apart(&space, &plane, 0.0) < 1e-6,
                "{elevation}, q = {q}: {:?} {:?}",
                space.tip(0),
                plane.tip(0)
            );
        }
    }
}
