//! What fuzzing found, each once and for all.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod soundness;

use bough::angle::Degrees;
use bough::mechanics::Status;
use bough::params::{
    ArrangementPattern, BranchingPattern, Discretization, Params, PointForce, Thickening, check,
};
use bough::{History, grow};
use soundness::{check_held, check_mirrored, check_moments, check_plant, check_shape};

/// One segment, which a force pulls until it points along it.
fn hair(radius: f64, length: f64) -> Params {
    let mut params = Params::default();
    params.axis.segments = 1;
    params.axis.radius = radius;
    params.axis.segment_length = length;
    params.solver.discretization = Discretization::Paper;
    params.loads.forces = vec![PointForce { segment: 0, force: [1e3, 1e3, 0.0] }];
    params
}

/// The torque of its load was 0 but for rounding, and the residual infinite.
#[test]
fn a_hair_pulled_straight_has_a_residual() {
    let plant = grow(&hair(1.9109718586691166e-7, 0.0375)).unwrap();
    assert_eq!(plant.report.status, Status::Converged);
    assert!(plant.report.residual.is_finite(), "{}", plant.report.residual);
    check_plant(&plant);
}

/// The bound of what Newton's last step leaves was held against the torque of before that step.
#[test]
fn a_last_step_that_takes_the_torque_away_is_not_the_last() {
    let mut params = hair(1.0669716874790748e-7, 1e-6);
    params.solver.tolerance = 0.0006674601361378348;
    let plant = grow(&params).unwrap();
    assert!(plant.report.residual <= params.solver.tolerance, "{}", plant.report.residual);
    check_plant(&plant);
}

/// All loads came back when somebody took hold of it.
#[test]
fn a_plant_without_its_loads_is_held_as_it_is_shown() {
    let mut params = Params::default();
    params.growth.thickening = Thickening::Pipes;
    params.loads.removed = true;
    let mut history = History::new(&params).unwrap();
    let shown = history.at(40);
    let [x, y, _] = shown.tip(0);
    check_held(&history.hold(39, [0.9 * x, 0.9 * y, 0.0]).unwrap());
}

/// It said that such a plant is stable, though it was in no equilibrium on the way there.
#[test]
fn a_held_plant_that_did_not_converge_is_not_called_stable() {
    let mut params = Params::default();
    params.axis.segments = 3;
    params.solver.method = bough::params::Method::Euler;
    // Not even the first step comes to rest within the limit.
    params.material.youngs_modulus = 1e-3;
    params.solver.tolerance = 1e-15;
    let mut history = History::new(&params).unwrap();
    let free = history.at(3);
    assert_ne!(free.report.status, Status::Converged);
    let held = history.hold(2, free.tip(0)).unwrap();
    assert_eq!((held.report.status, held.report.stable), (free.report.status, None));
}

/// The same in space, into which the wind takes an axis around a stem.
#[test]
fn a_held_plant_in_space_that_did_not_converge_is_not_called_stable() {
    let mut params = Params::default();
    params.axis.segments = 8;
    params.material.youngs_modulus = 2651.730670325792;
    params.tropism.strength = 836535101.1815326;
    params.arrangement.pattern = ArrangementPattern::Stem;
    params.arrangement.count = 2;
    params.arrangement.interval = 0;
    params.loads.gravity = 2240.90495992334;
    params.loads.wind = 853.1575158523057;
    params.loads.drag_coefficient = 4.217057637736653e-17;
    params.loads.foliage_drag = 1e-17;
    params.loads.picked = true;
    params.loads.removed = true;
    let mut history = History::new(&params).unwrap();
    let mut lost = 0;
    for step in 1..=8 {
        let free = history.at(step);
        for segment in 2..free.segments.parent.len() {
            let point = 3 * free.segments.point[segment] as usize;
            let [x, y, z] = free.polylines.points[point..point + 3] else { unreachable!() };
            let Some(held) = history.hold(segment as u32, [x, y - 0.001, z]) else { continue };
            let has_converged = held.report.status == Status::Converged;
            assert_eq!(held.report.stable.is_some(), has_converged, "{:?}", held.report);
            lost += u32::from(!has_converged);
        }
    }
    assert!(lost > 0);
}

/// Radians of more than half a turn were rounded otherwise than those of less.
#[test]
fn a_tropism_past_half_a_turn_is_mirrored_to_the_bit() {
    let mut params = Params::default();
    params.axis.segments = 8;
    params.axis.elevation = Degrees(123.953125);
    params.tropism.elevation = Degrees(-180.0);
    params.tropism.strength = 1.115855987999741e-11;
    params.growth.thickening = Thickening::Pipes;
    params.solver.discretization = Discretization::Paper;
    params.solver.tolerance = 0.08821151720186576;
    check_mirrored(&params);
}

/// How often sines had been turned instead of computed was remembered from one step to another.
#[test]
fn going_back_with_a_tight_tolerance_takes_the_same_iterations() {
    let mut params = Params::default();
    params.axis.segments = 5;
    params.axis.segment_length = 231.28984099861052;
    params.tropism.strength = 1e9;
    params.solver.tolerance = 1e-15;
    let mut history = History::new(&params).unwrap();
    history.at(3);
    assert_eq!(history.at(1), History::new(&params).unwrap().at(1));
}

/// Their stiffness was 0, and the plant called converged and unstable.
#[test]
fn twigs_thinner_than_numbers_are_refused_with_the_generations_that_fit() {
    let mut params = Params::default();
    params.axis.segments = 1;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 7;
    params.branching.girth_ratio = 1e-9;
    let issues = check(&params);
    assert_eq!(issues[0].max, Some(3.0));
    assert_eq!(
        issues[0].message(),
        "branching.generations must be at most 3, or twigs have a radius below 1e-30 m; it is 7."
    );
    params.branching.generations = 3;
    check_plant(&grow(&params).unwrap());
    // By the taper, which pipes do not have.
    params.branching.girth_ratio = 0.8;
    params.axis.taper = 1e-300;
    assert_eq!(check(&params)[0].max, Some(0.0));
    params.growth.thickening = Thickening::Pipes;
    assert_eq!(check(&params), []);
}

/// Rounding of an angle of several turns moves a load by more than the tolerance.
#[test]
fn a_hair_wound_up_and_pulled_says_what_rounding_leaves() {
    let mut params = hair(0.005, 0.0375);
    params.solver.discretization = Discretization::SecondOrder;
    params.material.youngs_modulus = 1e-3;
    params.tropism.strength = 305229.52121070755;
    params.loads.forces[0].force = [-0.7503389582715565, 891.1491725448201, 0.0];
    check_plant(&grow(&params).unwrap());
}

/// Its weight was taken from sums in which it had left its rounding, a million times the tolerance.
#[test]
fn heavy_fruit_that_is_picked_leaves_nothing_behind() {
    for space in [false, true] {
        let mut params = Params::default();
        params.axis.segments = 6;
        params.loads.tip_mass = 1e9;
        params.loads.picked = true;
        params.solver.space = space;
        let plant = grow(&params).unwrap();
        if space {
            check_moments(&plant)
        } else {
            check_plant(&plant)
        }
        // It keeps no bend of that time: what is left is the plant that never bore fruit.
        params.loads.tip_mass = 0.0;
        let light = grow(&params).unwrap();
        for (left, never) in plant.polylines.points.iter().zip(&light.polylines.points) {
            assert!((left - never).abs() < 1e-9, "{left} is not {never}");
        }
    }
}

/// When a load is raised in parts, the last was `before + (after - before)`: of a heavy `before` rounding was left.
#[test]
fn a_load_that_is_raised_in_parts_ends_as_itself() {
    let mut params = Params::default();
    params.axis.segments = 2;
    params.axis.segment_length = 1e-6;
    params.axis.radius = 1e-7;
    params.axis.elevation = Degrees(-180.0);
    params.axis.rest_curvature = -1e6;
    params.material.youngs_modulus = 1e15;
    params.loads.gravity = 1e6;
    params.loads.tip_mass = 1e9;
    params.loads.tip_force = [-1e12, 5817.09132937437, 0.0];
    params.loads.forces = vec![PointForce { segment: 0, force: [1e3, 1e3, 0.0] }];
    params.loads.picked = true;
    params.solver.discretization = Discretization::Paper;
    params.solver.tolerance = 1e-15;
    check_plant(&grow(&params).unwrap());
}

/// The wind was made to follow its shape up to a share of its loads' torques, of which the hand left next to nothing; and the
/// report told what was left over under the wind of the round before.
#[test]
fn a_limp_plant_that_is_held_in_the_wind_is_in_balance() {
    let mut params = Params::default();
    params.axis.segments = 8;
    params.material.youngs_modulus = 0.013471370006941845;
    params.loads.wind = 0.00816068394368714;
    params.solver.tolerance = 0.0037372230571776546;
    let mut history = History::new(&params).unwrap();
    let mut times_held = 0;
    for place in [[0.12, 0.05, 0.0], [-0.05, 0.1, 0.0], [0.1, -0.12, 0.0]] {
        let free = history.at(6);
        if let Some(held) = history.hold(4, place) {
            assert!(held.report.residual <= params.solver.tolerance, "{}", held.report.residual);
            check_held(&held);
            times_held += 1;
        }
        assert_eq!(history.at(6).fingerprint(), free.fingerprint());
    }
    assert!(times_held > 0);
}

/// Beside twigs that were limp the stem took its step shortened with them, to nothing; that it helped nothing was taken for
/// rounding, and a plant all of whose torques were left over was called converged.
#[test]
fn a_stem_that_waits_for_limp_twigs_is_not_at_rest() {
    let mut params = Params::default();
    params.axis.segments = 9;
    params.axis.segment_length = 1000.0;
    params.axis.length_profile = 100.0;
    params.axis.radius = 100.0;
    params.axis.elevation = Degrees(180.0);
    params.axis.rest_curvature = 1e6;
    params.material.youngs_modulus = 1e15;
    params.growth.thickening = Thickening::Pipes;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 3;
    params.branching.length_ratio = 0.001;
    params.branching.exponent = 2.0;
    params.branching.girth_ratio = 1e-9;
    params.loads.gravity = 0.0;
    params.loads.wind = 1e3;
    params.loads.wind_azimuth = Degrees(180.0);
    params.loads.drag_coefficient = 1e3;
    params.loads.tip_force = [1e12, 1e12, 0.0];
    params.solver.tolerance = 0.1;
    let plant = grow(&params).unwrap();
    assert!(plant.report.status != Status::Converged || plant.report.residual <= 0.1, "{:?}", plant.report);
    check_plant(&plant);
}

/// What loads turn to one side, however little, was pushed to the other off an unstable balance, as its mirror image was.
#[test]
fn what_is_pushed_off_its_balance_is_mirrored_to_the_bit() {
    let mut params = Params::default();
    params.axis.segments = 1;
    params.axis.taper = 2.7000546158529753e-6;
    params.axis.elevation = Degrees(-180.0);
    params.axis.rest_curvature = -2.7000546158529755;
    params.material.density = 1058012.3328715505;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 2;
    params.branching.length_ratio = 0.3737223057177652;
    params.branching.exponent = 45.174302108589615;
    params.loads.gravity = 1e6;
    params.loads.tip_force = [0.0, 41225645.816107914, 0.0];
    params.solver.discretization = Discretization::Paper;
    params.solver.tolerance = 8.545062253604944e-7;
    check_mirrored(&params);
}

/// A lying hair that is pushed together fell upwards to the left and downwards to the right; in space it falls as in the plane.
#[test]
fn what_lies_and_cannot_stay_falls_down_to_either_side() {
    for elevation in [0.0, 180.0] {
        let mut params = hair(0.005, 0.3);
        params.axis.segments = 8;
        params.axis.elevation = Degrees(elevation);
        params.loads.gravity = 0.0;
        params.loads.forces.clear();
        params.loads.tip_force = [if elevation == 0.0 { -3e-3 } else { 3e-3 }, 0.0, 0.0];
        params.material.youngs_modulus = 1e7;
        check_mirrored(&params);
        let planar = grow(&params).unwrap();
        params.solver.space = true;
        let spatial = grow(&params).unwrap();
        for plant in [&planar, &spatial] {
            let points = &plant.polylines.points;
            assert_eq!(plant.report.status, Status::Converged);
            assert!(points[points.len() - 2] < -1.0, "{points:?}");
        }
        for (here, there) in planar.polylines.points.iter().zip(&spatial.polylines.points) {
            assert!((here - there).abs() < 1e-9, "{here} and {there}");
        }
    }
}

/// Half a turn to the preferred direction was one to the left, and so was the mirror image's.
#[test]
fn a_tropism_half_a_turn_away_is_mirrored_to_the_bit() {
    let mut params = Params::default();
    params.axis.segments = 9;
    params.axis.elevation = Degrees(-123.78125);
    params.tropism.elevation = Degrees(56.21875);
    params.tropism.strength = 0.006085744643306699;
    params.axis.segment_length = 1000.0;
    params.axis.length_profile = 100.0;
    params.axis.radius = 1.1860775053920352e-5;
    params.material.youngs_modulus = 0.049444461011588274;
    params.growth.thickening = Thickening::Pipes;
    params.loads.tip_force = [0.40536209634181025, -1.0944997993195433e-6, 0.0];
    params.loads.removed = true;
    params.solver.tolerance = 2.6757835555986313e-14;
    check_mirrored(&params);
}

/// Two hundred rounds of a snow that follows limp twigs, each a long search, took seconds: they end when that is seen.
#[test]
fn weather_on_a_plant_that_finds_no_rest_ends_soon_and_says_so() {
    let mut params = Params::default();
    params.axis.segments = 3;
    params.axis.radius = 1.3751126982677162;
    params.axis.length_profile = 0.08582385058028537;
    params.tropism.strength = 1.27389801493233e-5;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 3;
    params.branching.girth_ratio = 1.8600960168952663e-7;
    params.arrangement.pattern = ArrangementPattern::FlexibleStem;
    params.arrangement.count = 3;
    params.arrangement.spacing = 0.10320181675594008;
    params.arrangement.interval = 0;
    params.arrangement.trunk = 0.0;
    params.arrangement.stem_radius = 1.260718106929512e-5;
    params.arrangement.stem_elevation = Degrees(0.0);
    params.loads.foliage_age = 21441;
    params.loads.foliage_area = 4.0;
    params.loads.wind = 25.71389333943694;
    params.solver.tolerance = 3.391472829547586e-12;
    params.solver.space = true;
    let plant = grow(&params).unwrap();
    check_shape(&plant);
    assert_eq!(plant.report.status, Status::MaxIterations);
    assert_eq!(plant.report.stable, None);
    assert!(plant.report.iterations < 10_000, "{}", plant.report.iterations);
}

/// A plant that had lost its balance looked for it as long as ever in each further step, and growth took seconds.
#[test]
fn growth_after_the_balance_is_lost_passes_soon_and_says_so() {
    let mut params = Params::default();
    params.axis.segments = 4;
    params.axis.segment_length = 1000.0;
    params.axis.length_profile = 100.0;
    params.axis.radius = 1e-7;
    params.axis.taper = 0.005314840014580977;
    params.axis.elevation = Degrees(-180.0);
    params.axis.rest_curvature = -835947.4711699479;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 3;
    params.branching.length_ratio = 1.43297008874769;
    params.solver.discretization = Discretization::Paper;
    let plant = grow(&params).unwrap();
    check_plant(&plant);
    assert_eq!((plant.report.status, plant.report.stable), (Status::MaxIterations, None));
    assert!(plant.report.iterations < 5_000, "{}", plant.report.iterations);
    check_mirrored(&params);
}
