//! The exact derivatives of the shape against central differences of whole growths.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod support;

use bough::angle::Degrees;
use bough::growth::sensitivity;
use bough::mechanics::Status;
use bough::params::{
    BranchingPattern, Discretization, Method, PARAMETERS, PRESETS, Params, PointForce, Solver, Stepping,
    Thickening,
};
use bough::{History, growth::iterations, relaxation};
use proptest::prelude::*;

/// How the sensitivity may differ from central differences, relative to the largest slope of any point. At a residual of
/// 1e-14 and a step of 1e-4 differences of fourth order are off by some 1e-10; finely cut, limp axes by a thousand times that.
const AGREEMENT: f64 = 1e-6;

/// Where a parameter's numbers are in the flat form.
fn place(path: &str) -> u32 {
    let before = PARAMETERS.iter().take_while(|parameter| parameter.path != path);
    before.map(|parameter| parameter.kind.width() as u32).sum()
}

/// The points of the plant with one number of the flat form changed.
fn points(params: &Params, place: u32, change: f64, step: u32) -> Vec<f64> {
    let mut flat = params.to_flat();
    flat[place as usize] += change;
    let changed = Params::from_flat(&flat);
    History::new(&changed).unwrap().at(step).polylines.points
}

/// Compares with central differences.
fn check_against_differences(params: &Params, paths: &[&str], step: u32) -> Result<(), TestCaseError> {
    let mut params = params.clone();
    params.solver.tolerance = 1e-14;
    for path in paths {
        let place = place(path);
        let found = sensitivity(&params, step, &[place]).unwrap().unwrap();
        let value = params.to_flat()[place as usize];
        let is_angle = path.contains("levation");
        // Differences are too coarse with a long step and drown in rounding with a short one: the best of a few counts.
        let mut best = f64::INFINITY;
        for relative in [1e-3, 3e-4, 1e-4, 3e-5, 1e-5] {
            let h = relative
                * if is_angle {
                    10.0
                } else if value == 0.0 {
                    1e-2
                } else {
                    value.abs()
                };
            // Of fourth order: long steps are good enough then.
            let at = |times: f64| points(&params, place, times * h, step);
            let (near, far) = ([at(1.0), at(-1.0)], [at(2.0), at(-2.0)]);
            let differences = (0..near[0].len())
                .map(|k| (8.0 * (near[0][k] - near[1][k]) - (far[0][k] - far[1][k])) / (12.0 * h));
            let largest = found.slopes.iter().fold(0.0, |most: f64, slope| most.max(slope.abs()));
            let off = differences.zip(&found.slopes).map(|(difference, slope)| (difference - slope).abs());
            best = best.min(off.fold(0.0, f64::max) / largest.max(1e-300));
            if largest == 0.0 && best == 0.0 {
                break;
            }
        }
        prop_assert!(best < AGREEMENT, "{}: {:e} off, of {:?}", path, best, params);
    }
    Ok(())
}

const ALWAYS: &[&str] = &[
    "axis.segmentLength",
    "axis.lengthProfile",
    "axis.radius",
    "axis.elevation",
    "material.youngsModulus",
    "material.density",
    "loads.gravity",
    "loads.tipMass",
    "loads.tipForce",
    "tropism.elevation",
    "tropism.strength",
];

fn forked() -> Params {
    let mut params = Params::default();
    params.axis.segments = 7;
    params.axis.segment_length = 0.05;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 2;
    params.branching.length_ratio = 0.8;
    params.tropism.strength = 1.5;
    params.tropism.elevation = Degrees(70.0);
    params.loads.tip_mass = 2e-4;
    params.material.youngs_modulus = 3e8;
    params
}

#[test]
fn along_an_axis_they_agree_with_differences() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        for thickening in [Thickening::None, Thickening::Pipes] {
            for stepping in [Stepping::Exact, Stepping::Static] {
                let mut params = Params::default();
                params.axis.segments = 12;
                params.axis.segment_length = 0.08;
                params.axis.length_profile = 1.7;
                params.axis.taper = 0.6;
                params.axis.radius = 0.003;
                params.material.youngs_modulus = 4e8;
                params.tropism.strength = 0.8;
                params.tropism.elevation = Degrees(75.0);
                params.loads.tip_mass = 3e-4;
                params.loads.tip_force = [1e-3, -2e-3, 0.0];
                params.solver.discretization = discretization;
                params.solver.stepping = stepping;
                params.growth.thickening = thickening;
                check_against_differences(&params, ALWAYS, 12).unwrap();
                check_against_differences(&params, &["axis.taper"], 9).unwrap();
                params.loads.removed = true;
                check_against_differences(&params, ALWAYS, 12).unwrap();
            }
        }
    }
}

#[test]
fn over_forks_they_agree_with_differences() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        for (thickening, roll) in [(Thickening::None, 0.0), (Thickening::Pipes, 180.0)] {
            let mut params = forked();
            params.solver.discretization = discretization;
            params.growth.thickening = thickening;
            params.branching.roll = Degrees(roll);
            params.axis.taper = 0.7;
            check_against_differences(&params, ALWAYS, 18).unwrap();
            check_against_differences(
                &params,
                &["branching.exponent", "branching.girthRatio", "axis.taper"],
                18,
            )
            .unwrap();
        }
    }
}

/// The first segment of an axis is its last here, with the turn of the fork in it.
#[test]
fn over_axes_of_one_segment_they_agree_with_differences() {
    let mut params = forked();
    params.axis.segments = 1;
    params.branching.length_ratio = 1.0;
    check_against_differences(&params, ALWAYS, 3).unwrap();
}

#[test]
fn on_every_preset_they_agree_with_differences() {
    for preset in PRESETS {
        let params = Params::of_preset(preset);
        let step = params.axis.segments.min(12);
        // Without weight nothing bends, and gravity is at the end of its range.
        if params.loads.gravity == 0.0 {
            continue;
        }
        let mut single = params.clone();
        single.arrangement.pattern = bough::params::ArrangementPattern::Single;
        // Derived is the shape that has grown.
        single.loads.wind = 0.0;
        single.loads.picked = false;
        check_against_differences(&single, &["material.youngsModulus", "loads.gravity"], step).unwrap();
    }
}

#[test]
fn a_tropism_that_is_off_has_a_slope_all_the_same() {
    let mut params = Params::default();
    params.axis.segments = 10;
    let place = place("tropism.strength");
    let found = sensitivity(&params, 10, &[place]).unwrap().unwrap();
    // One-sided: strengths are not negative. The error is about h.
    params.solver.tolerance = 1e-14;
    let (here, ahead) = (points(&params, place, 0.0, 10), points(&params, place, 1e-6, 10));
    let largest = found.slopes.iter().fold(0.0, |most: f64, slope| most.max(slope.abs()));
    assert!(largest > 0.01);
    for (slope, (ahead, here)) in found.slopes.iter().zip(ahead.iter().zip(&here)) {
        assert!((slope - (ahead - here) / 1e-6).abs() < 1e-5 * largest);
    }
}

/// The equilibrium has the slopes, not the way to it: they are those of Newton's method also where the paper's is chosen.
#[test]
fn the_method_does_not_matter() {
    let mut params = Params::default();
    params.axis.segments = 6;
    let modulus = [place("material.youngsModulus")];
    let by_newton = sensitivity(&params, 6, &modulus).unwrap().unwrap();
    params.solver.method = Method::Euler;
    let by_euler = sensitivity(&params, 6, &modulus).unwrap().unwrap();
    assert_eq!(by_newton.slopes, by_euler.slopes);
    assert_eq!(by_newton.plant.report.iterations, by_euler.plant.report.iterations);
    // So are the steps before the one whose way to rest is shown.
    let of = |method| Params { solver: Solver { method, ..params.solver.clone() }, ..params.clone() };
    let (newton, euler) = (of(Method::Newton), of(Method::Euler));
    assert_eq!(relaxation(&newton, 4).unwrap(), relaxation(&euler, 4).unwrap());
    assert_eq!(iterations(&newton, 4).unwrap(), iterations(&euler, 4).unwrap());
}

#[test]
fn where_there_are_none_none_are_given() {
    let modulus = [place("material.youngsModulus")];
    let mut pulled = Params::default();
    pulled.loads.forces = vec![PointForce { segment: 3, force: [0.0, 0.1, 0.0] }];
    assert!(sensitivity(&pulled, 40, &modulus).unwrap().is_none());
    let mut foreseen = Params::default();
    foreseen.solver.stepping = Stepping::Extrapolated;
    assert!(sensitivity(&foreseen, 40, &modulus).unwrap().is_none());
    let (mut bent, mut spatial) = (Params::default(), Params::default());
    bent.axis.rest_curvature = 1.0;
    spatial.solver.space = true;
    assert!(sensitivity(&bent, 40, &modulus).unwrap().is_none());
    assert!(sensitivity(&spatial, 40, &modulus).unwrap().is_none());
    // A forked hair upside down comes to no rest: what is shown of it is no equilibrium, whose slopes alone are derived. Any
    // other plant that finds no rest would do.
    let mut restless = Params::default();
    restless.axis.segments = 2;
    restless.axis.segment_length = 1.0;
    restless.axis.radius = 1e-4;
    restless.axis.elevation = Degrees(-90.0);
    restless.branching.pattern = BranchingPattern::Bifurcation;
    restless.branching.generations = 3;
    restless.branching.girth_ratio = 0.5;
    assert_eq!(bough::grow(&restless).unwrap().report.status, Status::MaxIterations);
    assert!(sensitivity(&restless, 40, &modulus).unwrap().is_none());
    // What is counted, chosen, or unknown has no slope; nor has a tip that points exactly away from where it seeks.
    let mut away = Params::default();
    away.axis.elevation = Degrees(-90.0);
    away.tropism.strength = 2.0;
    let wanted =
        [place("axis.segments"), place("growth.thickening"), 10_000, place("axis.elevation"), modulus[0]];
    let found = sensitivity(&away, 40, &wanted).unwrap().unwrap();
    let size = found.plant.polylines.points.len();
    let nothing = |wanted: usize| found.slopes[wanted * size..][..size].iter().all(|slope| slope.is_nan());
    assert_eq!([0, 1, 2, 3, 4].map(nothing), [true, true, true, true, false]);
    // What does not seek at all would turn a long way by the least wish to, and by nothing else.
    away.tropism.strength = 0.0;
    let wanted = ["tropism.strength", "tropism.elevation", "axis.elevation"].map(place);
    let found = sensitivity(&away, 40, &wanted).unwrap().unwrap();
    let nothing = |wanted: usize| found.slopes[wanted * size..][..size].iter().all(|slope| slope.is_nan());
    assert_eq!([0, 1, 2].map(nothing), [true, false, false]);
    let mut bad = Params::default();
    bad.axis.radius = -1.0;
    assert!(sensitivity(&bad, 40, &modulus).is_err());
}

#[test]
fn newtons_iterations_and_the_relaxation_end_in_one_shape() {
    let params =
        Params { axis: bough::params::Axis { segments: 12, ..Params::default().axis }, ..Params::default() };
    let (newton, euler) = (iterations(&params, 12).unwrap(), relaxation(&params, 12).unwrap());
    assert_eq!(newton.segments, 12);
    assert_eq!(newton.residuals.len(), newton.time.len());
    assert_eq!(euler.residuals.len(), euler.time.len());
    assert_eq!(newton.angle[..12], euler.angle[..12]);
    assert_eq!(newton.outcome.iterations as usize + 1, newton.time.len());
    // Iterations have no duration: they are counted.
    assert!(newton.time.iter().zip(0..).all(|(time, count)| *time == f64::from(count)));
    assert!(newton.time.len() < 8 && *newton.residuals.last().unwrap() <= 1e-10);
    assert_eq!(newton.outcome.residual, *newton.residuals.last().unwrap());
    assert!(newton.outcome.residual > 0.0);
    let (a, b) = (&newton.angle[newton.angle.len() - 12..], &euler.angle[euler.angle.len() - 12..]);
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-7));
}

/// A heavy axis that is solved at once: Newton's method alone would land on a wrong branch, or nowhere.
#[test]
fn where_newton_is_not_trusted_the_equilibrium_is_shown_all_the_same() {
    let mut params = support::heavy_rod(60.0, 30.0, 20);
    params.solver.stepping = Stepping::Static;
    let shown = iterations(&params, 20).unwrap();
    assert!(shown.is_led);
    // To be played, the shape that it is led to must come after those before it.
    assert!(shown.time.len() >= 2 && shown.time.windows(2).all(|pair| pair[1] > pair[0]));
    let plant = bough::grow(&params).unwrap();
    let [x, y, _] = plant.tip(0);
    let last = &shown.angle[shown.angle.len() - 20..];
    let end = last.iter().fold([0.0, 0.0], |[x, y], angle| [x + 0.05 * angle.cos(), y + 0.05 * angle.sin()]);
    assert!((end[0] - x).abs() + (end[1] - y).abs() < 1e-9);
}

proptest! {
    #![proptest_config(support::cases(25))]

    #[test]
    fn on_random_axes_they_agree_with_differences(
        elevation in -80.0..85.0_f64,
        q in 0.1..25.0_f64,
        strength in 0.0..4.0_f64,
        sought in -60.0..60.0_f64,
        segments in 2_u32..16,
        pipes in proptest::bool::ANY,
    ) {
        let mut params = support::heavy_rod(elevation, q, segments);
        if pipes {
            params = support::piped_rod(elevation, 0.3 * q, segments);
        }
        params.tropism.strength = 0.01 + strength;
        params.loads.tip_mass = 1e-3;
        params.tropism.elevation = Degrees(elevation + sought);
        check_against_differences(&params, ALWAYS, segments)?;
    }
}
