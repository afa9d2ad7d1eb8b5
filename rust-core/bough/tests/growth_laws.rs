//! What growth does to the shape: closed forms for small slopes, continuum limits for large ones.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::angle::Degrees;
use bough::grow;
use bough::params::{ArrangementPattern, Params, Stepping};
use support::{distance, extrapolated, fitted_order, heavy_rod, piped_rod};

const CUTS: [u32; 5] = [20, 40, 80, 160, 320];
const FULL: f64 = 1e6;

fn sag(params: &Params) -> f64 {
    -grow(params).unwrap().tip(0)[1]
}

fn with_full_tropism(mut params: Params) -> Params {
    params.tropism.elevation = params.axis.elevation;
    params.tropism.strength = FULL;
    params
}

/// Slopes are below 1e-3, so the nonlinear part of the sag, relative slope^2, is below 1e-6.
#[test]
fn small_sags_follow_the_closed_forms() {
    let small = 1e-3;
    type Rod = fn(u32) -> Params;
    let cases: [(&str, Rod, f64, f64); 4] = [
        ("elastic", |n| heavy_rod(0.0, 1e-3, n), small / 8.0, 2.0),
        ("tropism", |n| with_full_tropism(heavy_rod(0.0, 1e-3, n)), small / 12.0, 1.0),
        ("pipes", |n| piped_rod(0.0, 1e-3, n), small / 3.0, 2.0),
        ("both", |n| with_full_tropism(piped_rod(0.0, 1e-3, n)), small / 6.0, 1.0),
    ];
    for (name, rod, exact, expected_order) in cases {
        let sags = CUTS.map(|segments| sag(&rod(segments)));
        let errors = sags.map(|sag| (sag / exact - 1.0).abs());
        let order = fitted_order(&CUTS, &errors);
        let powers = if expected_order == 1.0 { [1, 2] } else { [2, 4] };
        let limit = extrapolated(&CUTS, &sags, &powers) / exact;
        println!("{name:8} order {order:.3} (expected {expected_order}), limit / closed form {limit:.7}");
        assert!((order - expected_order).abs() < 0.1, "{name}: order {order}");
        assert!((limit - 1.0).abs() < 1e-4, "{name}: limit {limit}");
    }
}

#[test]
fn without_memory_the_piped_rod_sags_a_third() {
    let sags = CUTS.map(|segments| {
        let mut params = piped_rod(0.0, 1e-3, segments);
        params.solver.stepping = Stepping::Static;
        sag(&params)
    });
    let limit = extrapolated(&CUTS, &sags, &[1, 2]);
    println!("memoryless sag / (K L^3 / 9): {:.7}", limit / (1e-3 / 9.0));
    assert!((limit / (1e-3 / 9.0) - 1.0).abs() < 1e-4);
}

/// Continuum limits with about five digits.
#[test]
fn large_growth_tends_to_the_continuum() {
    type Rod = fn(u32) -> Params;
    let cases: [(&str, Rod, [f64; 2]); 3] = [
        ("pipes, K L^2 = 1", |n| piped_rod(0.0, 1.0, n), [0.938566, -0.314449]),
        (
            "pipes and tropism, K L^2 = 1",
            |n| with_full_tropism(piped_rod(0.0, 1.0, n)),
            [0.983954, -0.162701],
        ),
        ("tropism, q = 5", |n| with_full_tropism(heavy_rod(0.0, 5.0, n)), [0.922007, -0.350505]),
    ];
    for (name, rod, exact) in cases {
        let tips = CUTS.map(|segments| grow(&rod(segments)).unwrap().tip(0));
        let limit = [0, 1].map(|axis| extrapolated(&CUTS, &tips.map(|tip| tip[axis]), &[1, 2, 3]));
        let off = (limit[0] - exact[0]).hypot(limit[1] - exact[1]);
        println!("{name}: limit {limit:.6?}, continuum {exact:.6?}, {off:.1e} L apart");
        assert!(off < 2e-5);
    }
}

/// Load at which the grown column stops standing straight, as its report has it; a thousandth beside it does or does not.
fn critical(segments: u32, mut column: impl FnMut(f64) -> Params) -> f64 {
    let mut grown = |load: f64| {
        let mut params = column(load);
        params.axis.elevation = Degrees(90.0);
        params.axis.segments = segments;
        grow(&params).unwrap()
    };
    let load = 10.0 / grown(10.0).report.self_buckling.unwrap();
    let (below, above) = (grown(0.999 * load), grown(1.001 * load));
    assert!((below.report.self_buckling.unwrap() - 0.999).abs() < 1e-6);
    assert!((above.report.self_buckling.unwrap() - 1.001).abs() < 1e-6);
    assert_eq!((below.tip(0)[0], below.report.residual), (0.0, 0.0), "a straight column is in equilibrium");
    // Always to the same side.
    assert!(above.tip(0)[0] > 0.0);
    assert_eq!((below.report.stable, above.report.stable), (Some(true), Some(true)));
    load
}

#[test]
fn columns_buckle_at_the_published_loads() {
    type Column = fn(u32, f64) -> Params;
    let cone: Column = |n, load| {
        let mut params = heavy_rod(90.0, load, n);
        params.axis.taper = 0.0;
        params
    };
    let pipes: Column = |n, load| piped_rod(90.0, 0.5 * load, n);
    let uniform: Column = |n, load| heavy_rod(90.0, load, n);
    let cuts = [80, 160, 320];
    // A whole number of pipes makes the base one pipe thicker than the smooth taper: first order in 1 / n.
    for (name, column, exact, powers) in [
        ("uniform", uniform, 7.83734743894, [2, 4]),
        ("pipes", pipes, 19.7392088022, [1, 2]),
        ("cone", cone, 30.5298493637, [2, 4]),
    ] {
        let loads = cuts.map(|segments| critical(segments, |load| column(segments, load)));
        let limit = extrapolated(&cuts, &loads, &powers);
        println!("{name:7} lambda {limit:.6}, published {exact:.6}; K L^2 {:.6}", 0.5 * limit);
        assert!((limit / exact - 1.0).abs() < 1e-3, "{name}: {limit} from {loads:?}");
    }
}

/// Past its critical height a stem leans to the side of its azimuth, in the plane and in space alike, and its report says by
/// how much it is past.
#[test]
fn a_stem_past_its_critical_height_leans_and_says_so() {
    let critical = 7.83734743894;
    for load in [6.0, 9.0, 12.0] {
        let mut params = heavy_rod(90.0, load, 160);
        params.solver.tolerance = 1e-13;
        let plane = grow(&params).unwrap();
        let past = plane.report.self_buckling.unwrap();
        println!("q = {load}: {past:.5} of the critical load, tip {:.4} aside", plane.tip(0)[0]);
        // 1 / n^2 of the cut.
        assert!((past * critical / load - 1.0).abs() < 1e-4);
        assert_eq!(plane.tip(0)[0] > 0.1, load > critical);
        params.solver.space = true;
        params.axis.azimuth = Degrees(40.0);
        let space = grow(&params).unwrap();
        let (sin, cos) = 40_f64.to_radians().sin_cos();
        let [x, y, z] = plane.tip(0);
        assert!(distance(space.tip(0), [x * cos + z * sin, y, z * cos - x * sin]) < 1e-9);
        assert_eq!((space.report.stable, plane.report.stable), (Some(true), Some(true)));
        assert!((space.report.self_buckling.unwrap() - past).abs() < 1e-8);
    }
    // A breath, ten million times less than the weight, turns it to the other side, whether it is in the plane or in space.
    let mut params = heavy_rod(90.0, 12.0, 40);
    let still = grow(&params).unwrap();
    params.loads.tip_force =
        [-1e-7 * params.loads.gravity * still.segments.mass.iter().sum::<f64>(), 0.0, 0.0];
    for space in [false, true] {
        params.solver.space = space;
        let breath = grow(&params).unwrap();
        assert!(breath.report.self_buckling.unwrap() > 1.0);
        // What it adds to a bend of order 1 is of its own order, divided by how far the load is past the critical one.
        assert!((breath.tip(0)[0] + still.tip(0)[0]).abs() < 1e-6 * still.tip(0)[0], "{space}");
    }
    // What leans anyway has no critical height.
    assert_eq!(grow(&heavy_rod(89.0, 9.0, 20)).unwrap().report.self_buckling, None);
    // A stem with axes buckles only where they stand upright as it does.
    let mut stem = Params::default();
    stem.axis.segments = 4;
    stem.arrangement.pattern = ArrangementPattern::FlexibleStem;
    stem.arrangement.count = 3;
    for (stands, points, has) in [(90.0, 90.0, true), (80.0, 90.0, false), (90.0, 40.0, false)] {
        (stem.arrangement.stem_elevation.0, stem.axis.elevation.0) = (stands, points);
        assert_eq!(grow(&stem).unwrap().report.self_buckling.is_some(), has, "{stands}, {points}");
    }
}

/// A hair too little out of balance to bend by itself falls to the side it leans to, grown or not.
#[test]
fn a_stem_that_leans_by_a_hair_falls_to_that_side() {
    for (elevation, side) in [(90.0 - 1e-7, 1.0), (90.0 + 1e-7, -1.0)] {
        for stepping in [Stepping::Exact, Stepping::Static] {
            let mut params = heavy_rod(elevation, 30.0, 20);
            params.solver.stepping = stepping;
            let plant = grow(&params).unwrap();
            let aside = plant.tip(0)[0] / side;
            assert!(aside > 0.1, "{elevation} degrees, {stepping:?}: {aside} m");
            assert_eq!(plant.report.stable, Some(true));
        }
    }
}

/// What hangs and is pulled up stands as unstably as what stands and is weighed down: both give way to the side of the azimuth.
#[test]
fn a_hanging_stem_that_is_pulled_up_gives_way_to_the_side_of_its_azimuth() {
    let mut params = heavy_rod(-90.0, 1.0, 20);
    let weight = params.loads.gravity * grow(&params).unwrap().segments.mass.iter().sum::<f64>();
    params.loads.tip_force = [0.0, 20.0 * weight, 0.0];
    for stepping in [Stepping::Exact, Stepping::Static] {
        params.solver.stepping = stepping;
        let plant = grow(&params).unwrap();
        assert!(plant.tip(0)[0] > 0.1, "{stepping:?}: {:?}", plant.tip(0));
        assert_eq!(plant.report.stable, Some(true));
    }
}
