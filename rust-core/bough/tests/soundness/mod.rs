//! What every plant must be, whatever it was grown from. The fuzz targets and the replay of their corpus share it: each
//! public function takes a fuzzer's bytes and panics if a promise is broken.
//!
//! The core's promises: any input ends in a plant with a truthful report or in one error; all numbers are finite, or the
//! report says otherwise; the stated residual is the real one; a stable shape is a minimum of energy; mirrored input gives
//! the mirrored plant to the last bit; and an age is the same whichever way it is reached.

#![allow(clippy::disallowed_methods, reason = "what is expected may come from any arithmetic")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::needless_range_loop, reason = "a test may stop")]
#![allow(dead_code, unused_imports, reason = "each fuzz target and test uses a part")]
#![allow(unreachable_pub, missing_docs, reason = "shared between crates by path")]

mod case;
mod forces;
mod mirror;
mod moments;
mod sound;
mod statics;

use arbitrary::{Result, Unstructured};
use bough::mechanics::Status;
use bough::params::{
    ArrangementPattern, BranchingPattern, Method, PARAMETERS, Params, Thickening, check, check_flat,
};
use bough::{History, Plant, grow};

pub use case::Values;
pub use mirror::check_mirrored;
pub use moments::{check_held_moments, check_moments};
pub use sound::{check_held, check_plant, check_shape};

/// Most segment-steps of a plant that is grown here: tens of microseconds each.
const MOST_STEPPED: f64 = 3e3;

/// Any bytes as the numbers that cross into wasm.
pub fn bytes(data: &[u8]) {
    let flat = case::flat(data);
    let issues = check_flat(&flat);
    for issue in &issues {
        let message = issue.message();
        assert!(message.contains(issue.path) && message.ends_with('.'), "{message}");
        assert!(PARAMETERS.iter().any(|parameter| parameter.path == issue.path), "{message}");
        assert!(!issue.min.zip(issue.max).is_some_and(|(min, max)| min > max), "{message}");
    }
    let params = Params::from_flat(&flat);
    if issues.is_empty() {
        let whole = params.to_flat();
        let again = Params::from_flat(&whole).to_flat();
        // What is left out is NaN, which equals nothing.
        assert!(again.iter().map(|number| number.to_bits()).eq(whole.iter().map(|number| number.to_bits())));
        if is_small(&params, MOST_STEPPED / 10.0) {
            let plant = grow(&params).unwrap();
            // Statics in space are checked by tests of their own.
            if planar(params.clone()).as_ref() == Some(&params) {
                check_plant(&plant)
            } else {
                check_shape(&plant)
            }
        }
    } else if format!("{:?}", params.to_flat()) == format!("{flat:?}") {
        assert_eq!(format!("{:?}", grow(&params).unwrap_err().issues), format!("{issues:?}"));
    }
}

/// Ordinary plants with some values from anywhere.
pub fn values(data: &[u8]) {
    let _ = grown(data, Values::Mixed, |_, _| Ok(()));
}

/// Every value at an end of its range, or beside it.
pub fn extremes(data: &[u8]) {
    let _ = grown(data, Values::Extreme, |_, _| Ok(()));
}

/// Forks upon forks, of all widths and angles.
pub fn forks(data: &[u8]) {
    let _ = grown(data, Values::Mixed, fork_often);
}

fn fork_often(params: &mut Params, bytes: &mut Unstructured) -> Result<()> {
    params.arrangement.pattern = ArrangementPattern::Single;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = bytes.int_in_range(0..=6)?;
    params.axis.segments = bytes.int_in_range(1..=3)?;
    params.branching.girth_ratio = [1e-9, 1e-3, 0.5, 1.0 - 1e-15, 1.0][bytes.choose_index(5)?];
    params.branching.exponent = [2.0, 2.0 + 1e-15, 2.49, 3.0, 100.0][bytes.choose_index(5)?];
    params.branching.length_ratio = [1e-3, 0.5, 1.0, 2.0][bytes.choose_index(4)?];
    Ok(())
}

/// The ages of a plant in any order and in slices of any size.
pub fn ages(data: &[u8]) {
    let _ = wander(data);
}

fn wander(data: &[u8]) -> Result<()> {
    let mut bytes = Unstructured::new(data);
    let Some(params) = planar(case::params(&mut bytes, Values::Mixed)?) else { return Ok(()) };
    let mut wandering = History::new(&params).unwrap();
    for _ in 0..bytes.int_in_range(1_u8..=4)? {
        let step = bytes.int_in_range(0..=wandering.steps() + 2)?;
        if bytes.arbitrary()? {
            // Left in the middle of a way.
            let budget = bytes.int_in_range(0..=40)?;
            wandering.seek(step, budget);
        }
        if bytes.ratio(1, 4)? {
            let work = bytes.int_in_range(0..=200)?;
            let is_there = wandering.reach(step, work);
            let plant = wandering.plant();
            assert!(is_there || plant.report.status >= Status::Budget);
            assert_eq!(plant.report.steps, wandering.step());
            check_plant(&plant);
        }
        if bytes.ratio(1, 4)? {
            let place = [case::number(&mut bytes, -1e3, 1e3)?, case::number(&mut bytes, -1e3, 1e3)?, 0.0];
            wandering.hold(bytes.int_in_range(0..=12)?, place);
        }
        let slices = bytes.int_in_range(1..=30)?;
        while !wandering.seek(step, slices) {}
        let plant = wandering.plant();
        check_plant(&plant);
        let direct = History::new(&params).unwrap().at(step);
        assert_eq!(plant.fingerprint(), direct.fingerprint(), "step {step} of {params:?}");
        assert_eq!(format!("{:?}", plant.report), format!("{:?}", direct.report));
    }
    Ok(())
}

/// A plant and its mirror image.
pub fn mirror(data: &[u8]) {
    let _ = grown(data, Values::Mixed, |params, bytes| {
        // Differences of such angles are exact.
        let degrees =
            |bytes: &mut Unstructured| Ok(f64::from(bytes.int_in_range(-11520_i16..=11520)?) / 64.0);
        params.arrangement.pattern = ArrangementPattern::Single;
        params.axis.elevation.0 = degrees(bytes)?;
        params.tropism.elevation.0 = degrees(bytes)?;
        mirror::check_mirrored(params);
        Ok(())
    });
}

/// Plants in space: what bends aside, twists, forks aside, is lit or blown at from aside, and is drawn aside by a point.
pub fn space(data: &[u8]) {
    let _ = draw_aside(data);
}

fn draw_aside(data: &[u8]) -> Result<()> {
    let mut bytes = Unstructured::new(data);
    let Some(params) = spatial(case::params(&mut bytes, Values::Mixed)?) else { return Ok(()) };
    let mut history = History::new(&params).unwrap();
    let free = history.at(history.steps());
    check_shape(&free);
    check_moments(&free);
    for _ in 0..bytes.int_in_range(0_u8..=2)? {
        let segment = bytes.int_in_range(0..=free.segments.parent.len() as u32)?;
        if let Some(held) = history.hold(segment, place_near(&mut bytes, &free)?) {
            assert_eq!(held.params.loads.forces.len(), 1);
            check_shape(&held);
            check_held_moments(&held);
        }
    }
    assert_eq!(history.plant().fingerprint(), free.fingerprint(), "letting go leaves a trace");
    Ok(())
}

/// Somewhere within three times the plant's reach, if need be far out of its plane.
fn place_near(bytes: &mut Unstructured, plant: &Plant) -> Result<[f64; 3]> {
    let reach = 3.0 * plant.segments.length.iter().sum::<f64>();
    let mut place = [0.0; 3];
    for along in &mut place {
        *along = case::number(bytes, -reach, reach)?;
    }
    Ok(place)
}

fn spatial(mut params: Params) -> Option<Params> {
    params.solver.space = true;
    params.solver.method = Method::Newton;
    grown_by_newton(params, MOST_STEPPED / 4.0)
}

/// A point held anywhere.
pub fn grips(data: &[u8]) {
    let _ = pull(data);
}

fn pull(data: &[u8]) -> Result<()> {
    let mut bytes = Unstructured::new(data);
    let Some(params) = planar(case::params(&mut bytes, Values::Mixed)?) else { return Ok(()) };
    let mut history = History::new(&params).unwrap();
    let free = history.at(bytes.int_in_range(1..=history.steps())?);
    for _ in 0..bytes.int_in_range(1_u8..=3)? {
        let reach = 3.0 * free.segments.length.iter().sum::<f64>();
        let place = [case::number(&mut bytes, -reach, reach)?, case::number(&mut bytes, -reach, reach)?, 0.0];
        let segment = bytes.int_in_range(0..=free.segments.parent.len() as u32)?;
        if let Some(held) = history.hold(segment, place) {
            assert_eq!(held.params.loads.forces.len(), 1);
            check_held(&held);
        }
    }
    let after = history.plant();
    assert_eq!(after.fingerprint(), free.fingerprint(), "letting go leaves a trace");
    Ok(())
}

/// Grows what the bytes and a change of it say, and checks the plant.
fn grown(
    data: &[u8],
    values: Values,
    change: impl Fn(&mut Params, &mut Unstructured) -> Result<()>,
) -> Result<()> {
    if let Some(params) = case_in_plane(data, values, change)? {
        check_plant(&grow(&params).unwrap());
    }
    Ok(())
}

fn case_in_plane(
    data: &[u8],
    values: Values,
    change: impl Fn(&mut Params, &mut Unstructured) -> Result<()>,
) -> Result<Option<Params>> {
    let mut bytes = Unstructured::new(data);
    let mut params = case::params(&mut bytes, values)?;
    change(&mut params, &mut bytes)?;
    Ok(planar(params))
}

/// Kept inputs that are a plant each: what they are called, the file, and which plant one is.
pub type Kept = (&'static str, &'static str, fn(&[u8]) -> Option<Params>);

/// All of them.
pub const CASES: [Kept; 4] = [
    ("values", include_str!("../corpus/values.txt"), |data| {
        case_in_plane(data, Values::Mixed, |_, _| Ok(())).ok()?
    }),
    ("extremes", include_str!("../corpus/extremes.txt"), |data| {
        case_in_plane(data, Values::Extreme, |_, _| Ok(())).ok()?
    }),
    ("forks", include_str!("../corpus/forks.txt"), |data| {
        case_in_plane(data, Values::Mixed, fork_often).ok()?
    }),
    ("space", include_str!("../corpus/space.txt"), |data| {
        spatial(case::params(&mut Unstructured::new(data), Values::Mixed).ok()?)
    }),
];

/// The bytes that a line of the corpus stands for.
pub fn unhexed(line: &str) -> Vec<u8> {
    let digits: Vec<u32> = line.chars().map(|digit| digit.to_digit(16).unwrap()).collect();
    digits.chunks(2).map(|two| (16 * two[0] + two[1]) as u8).collect()
}

/// The nearest params that the planar model has; none if there is nothing near.
fn planar(mut params: Params) -> Option<Params> {
    // Rods in space have checks of their own: these are the planar ones.
    params.solver.space = false;
    params.axis.azimuth.0 = 0.0;
    params.axis.rest_twist = 0.0;
    params.axis.rest_curvature_roll.0 = 0.0;
    params.tropism.azimuth = None;
    if params.arrangement.pattern == ArrangementPattern::FlexibleStem {
        params.arrangement.pattern = ArrangementPattern::Single;
    }
    params.loads.tip_force[2] = 0.0;
    params.loads.wind_azimuth.0 = if params.loads.wind_azimuth.0 > 0.0 { 180.0 } else { 0.0 };
    params.branching.roll.0 = if params.branching.roll.0 > 0.0 { 180.0 } else { 0.0 };
    grown_by_newton(params, MOST_STEPPED)
}

/// The params with what no refusal but that of size is expected of, if they are small enough.
fn grown_by_newton(mut params: Params, most: f64) -> Option<Params> {
    if params.branching.pattern == BranchingPattern::Bifurcation
        && params.growth.thickening == Thickening::None
    {
        params.axis.taper = params.axis.taper.max(1e-9);
    }
    if params.arrangement.pattern == ArrangementPattern::Stem {
        params.loads.forces.clear();
    }
    let issues = check(&params);
    for issue in &issues {
        let is_expected = issue.code == "tooLarge" || issue.path == "branching.generations";
        assert!(is_expected, "{issue:?}");
        check_refusal(&params, issue);
    }
    (issues.is_empty() && is_small(&params, most)).then_some(params)
}

/// A refusal names the largest value that fits: with that the plant is not refused for the same reason, with one more it is.
fn check_refusal(params: &Params, issue: &bough::params::Issue) {
    let most = issue.max.unwrap_or_else(|| panic!("{issue:?} names no value that fits"));
    let with = |value: f64| {
        let mut params = params.clone();
        match issue.path {
            "branching.generations" => params.branching.generations = value as u32,
            "axis.segments" => params.axis.segments = value as u32,
            "arrangement.count" => params.arrangement.count = value as u32,
            path => panic!("{path} is refused"),
        }
        check(&params)
    };
    let is_same = |other: &bough::params::Issue| (other.code, other.path) == (issue.code, issue.path);
    assert!(!with(most).iter().any(is_same), "{issue:?} of {params:?}");
    assert!(with(most + 1.0).iter().any(is_same), "{issue:?} of {params:?}");
}

/// Whether the segments of all growth steps together are few enough, counted step by step.
fn is_small(params: &Params, most: f64) -> bool {
    let euler = params.solver.method == Method::Euler;
    let (mut axes, mut scale, mut whole, mut stepped) = (1.0, 1.0, 0.0, 0.0);
    let forks = match params.branching.pattern {
        BranchingPattern::None => 0,
        BranchingPattern::Bifurcation => params.branching.generations,
    };
    for _ in 0..=forks {
        let segments = (f64::from(params.axis.segments) * scale).round().max(1.0);
        whole += axes * segments;
        stepped += segments * whole;
        axes *= 2.0;
        scale *= params.branching.length_ratio;
    }
    let copies = match params.arrangement.pattern {
        ArrangementPattern::Single => 1.0,
        ArrangementPattern::Stem | ArrangementPattern::FlexibleStem => f64::from(params.arrangement.count),
    };
    !euler && copies * stepped <= most && whole <= 300.0
}
