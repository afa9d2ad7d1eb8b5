//! Any input ends in a plant with a truthful report, or in one error that lists every problem.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::mechanics::Status;
use bough::params::{ArrangementPattern, Kind, PARAMETERS, Params, check_flat, flat_length};
use bough::{History, grow};
use proptest::prelude::*;

/// Numbers that people, links and bugs produce.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(f64::NEG_INFINITY),
        Just(0.0),
        Just(-0.0),
        Just(1e308),
        Just(-1e308),
        Just(5e-324),
        Just(1e9),
        -10.0..10.0,
        any::<f64>(),
    ]
}

/// A number in a parameter's range, the ends and the smallest magnitudes included.
fn accepted(index: usize) -> BoxedStrategy<Vec<f64>> {
    let parameter = &PARAMETERS[index];
    let (min, max) = (parameter.min, parameter.max);
    let one: BoxedStrategy<f64> = match parameter.kind {
        // Growth to 10^5 segments is for the benchmarks.
        Kind::Integer => (1_u32..30).prop_map(f64::from).boxed(),
        Kind::Choice(_) | Kind::Flag => (min as u32..=max as u32).prop_map(f64::from).boxed(),
        _ if min > 0.0 => (min.ln()..=max.ln()).prop_map(move |log| log.exp().clamp(min, max)).boxed(),
        _ => prop_oneof![Just(min), Just(max), Just(0.0_f64.clamp(min, max)), min..=max].boxed(),
    };
    prop::collection::vec(one, parameter.kind.width()).boxed()
}

fn valid_flat() -> impl Strategy<Value = Vec<f64>> {
    let each: Vec<_> = (0..PARAMETERS.len()).map(accepted).collect();
    let euler = PARAMETERS.iter().take_while(|parameter| parameter.path != "solver.method");
    let method: usize = euler.map(|parameter| parameter.kind.width()).sum();
    each.prop_map(move |values| {
        let mut flat = values.concat();
        // Two million Euler steps a case are for the soak.
        flat[method] = 0.0;
        // What the machine's memory does not have: see the tests of the messages.
        let mut params = Params::from_flat(&flat);
        params.loads.wind_azimuth.0 = if params.loads.wind_azimuth.0 > 0.0 { 180.0 } else { 0.0 };
        if !bough::params::check(&params).iter().all(|issue| issue.path != "loads.wind") {
            params.loads.wind = 0.0;
            params.loads.snow = 0.0;
            params.loads.picked = false;
        }
        params.branching.generations %= 5;
        params.branching.length_ratio = params.branching.length_ratio.min(1.5);
        params.axis.taper = params.axis.taper.max(0.01);
        params.arrangement.count = params.arrangement.count.min(20);
        // In space a case takes ten times as long: fewer segments show as much.
        params.axis.segments = params.axis.segments.min(12);
        params.branching.generations %= 4;
        if params.arrangement.pattern == ArrangementPattern::FlexibleStem {
            params.arrangement.count = params.arrangement.count.min(4);
            params.arrangement.interval %= 5;
        }
        for refusal in bough::params::check(&params) {
            assert_eq!(refusal.path, "branching.generations");
            params.branching.generations = refusal.max.unwrap() as u32;
        }
        params.to_flat()
    })
}

proptest! {
    #![proptest_config(support::cases(100))]

    #[test]
    fn bad_numbers_are_all_listed(flat in prop::collection::vec(number(), 0..40)) {
        let issues = check_flat(&flat);
        for issue in &issues {
            prop_assert!(issue.message().contains(issue.path), "{}", issue.message());
            prop_assert!(issue.message().ends_with('.'));
        }
        let mut offset = 0;
        for parameter in PARAMETERS {
            for value in flat.iter().skip(offset).take(parameter.kind.width()) {
                let left_open = parameter.kind == Kind::Optional && value.is_nan();
                let outside = !left_open && !(parameter.min..=parameter.max).contains(value);
                if outside {
                    let named = issues.iter().any(|issue| {
                        issue.path == parameter.path && issue.value.to_bits() == value.to_bits()
                    });
                    prop_assert!(named, "{} = {}", parameter.path, value);
                }
            }
            offset += parameter.kind.width();
        }
        if !issues.is_empty() && flat.len() == flat_length() {
            prop_assert_eq!(grow(&Params::from_flat(&flat)).is_err() || flat.iter().any(|x| x.fract() != 0.0), true);
        }
    }

    #[test]
    fn accepted_params_end_in_a_truthful_plant(flat in valid_flat()) {
        let params = Params::from_flat(&flat);
        prop_assert_eq!(check_flat(&flat), vec![]);
        let plant = grow(&params).unwrap();
        let arrays = [&plant.polylines.points, &plant.polylines.radii, &plant.segments.rotation];
        for number in arrays.into_iter().flatten() {
            prop_assert!(number.is_finite());
        }
        let report = plant.report;
        prop_assert!(!report.residual.is_nan());
        prop_assert_eq!(report.stable.is_some(), report.status == Status::Converged);
        let steps = bough::Growth::new(&params).unwrap().steps();
        prop_assert!(report.steps == steps || report.status == Status::NonFinite);
    }

    #[test]
    fn a_step_is_the_same_whichever_way_it_is_reached(flat in valid_flat(), steps in prop::collection::vec(1_u32..30, 1..6)) {
        let params = Params::from_flat(&flat);
        let mut wandering = History::new(&params).unwrap();
        for step in steps {
            let direct = History::new(&params).unwrap().at(step).fingerprint();
            prop_assert_eq!(wandering.at(step).fingerprint(), direct);
        }
    }
}

#[test]
fn messages_are_worded_for_a_person() {
    let mut params = Params::default();
    params.axis.segments = 1_000_000_000;
    params.axis.radius = -0.01;
    params.material.youngs_modulus = f64::NAN;
    params.loads.gravity = 1e308;
    let error = grow(&params).unwrap_err();
    let messages: Vec<_> = error.issues.iter().map(bough::params::Issue::message).collect();
    assert_eq!(
        messages,
        [
            "axis.segments must be a whole number from 1 to 100000; it is 1e9.",
            "axis.radius must be a number from 1e-7 to 100 m; it is -0.01.",
            "material.youngsModulus must be a number from 0.001 to 1e15 Pa; it is NaN.",
            "loads.gravity must be a number from 0 to 1e6 m/s2; it is 1e308.",
        ]
    );
}

#[test]
fn forks_from_a_point_are_refused() {
    let mut params = Params::default();
    params.branching.pattern = bough::params::BranchingPattern::Bifurcation;
    params.axis.taper = 0.0;
    let error = grow(&params).unwrap_err();
    let paths: Vec<_> = error.issues.iter().map(|issue| (issue.code, issue.path)).collect();
    assert_eq!(paths, [("unsupported", "axis.taper")]);
}

#[test]
fn too_many_segments_are_refused_with_their_number_and_what_fits() {
    let mut params = Params::default();
    params.branching.pattern = bough::params::BranchingPattern::Bifurcation;
    params.axis.segments = 12;
    params.branching.generations = 30;
    let error = grow(&params).unwrap_err();
    assert_eq!(
        error.to_string(),
        "branching.generations would make 2.5769803764e10 segments, and 1e6 is the limit; at most 15 fits here."
    );
    params.branching.generations = 15;
    assert_eq!(bough::params::check(&params), []);
    // 12 (2^16 - 1) segments are below a million; 13 are not, and fewer segments are the way out at 0 generations.
    params.axis.segments = 100_000;
    params.branching.generations = 4;
    assert_eq!(grow(&params).unwrap_err().issues[0].max, Some(2.0));
}

#[test]
fn pipes_beyond_memory_are_refused_with_the_largest_count_that_fits() {
    let mut params = Params::default();
    params.growth.thickening = bough::params::Thickening::Pipes;
    params.axis.segments = 100_000;
    let error = grow(&params).unwrap_err();
    assert_eq!((error.issues[0].code, error.issues[0].max), ("tooLarge", Some(14141.0)));
    params.axis.segments = 14141;
    assert_eq!(bough::params::check(&params), []);
}
