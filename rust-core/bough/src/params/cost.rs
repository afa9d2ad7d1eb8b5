//! What growing a plant would cost, known before it is grown.

use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

use super::declaration::{ArrangementPattern, Branching, BranchingPattern, Params, Stepping, Thickening};
use super::issue::{Issue, Sentence};
use super::plane::is_spatial;

/// Most segments of all axes together.
pub const MAX_SEGMENTS: f64 = 1e6;
/// Most segment-steps of exact growth; about half an hour on one core.
pub const MAX_STEPPED: f64 = 1e10;
/// Most segment-steps of exact growth with pipes, whose history is kept: 8 bytes each.
pub const MAX_PIPES_LAID: f64 = 1e8;

/// Whether growth can be foreseen at every age from coarser cuts: one axis that is cut evenly, bears no leaves (their age counts
/// the steps of this cut) and is let alone afterwards (its stress is foreseen too).
pub(crate) fn is_foreseeable(params: &Params) -> bool {
    let Params { axis, growth, branching, loads, .. } = params;
    let alone = loads.foliage == 0.0 && loads.snow == 0.0 && loads.wind == 0.0 && !loads.picked;
    let even = axis.length_profile == 1.0 && (axis.taper == 1.0 || growth.thickening == Thickening::Pipes);
    even && alone && branching.pattern == BranchingPattern::None && !is_spatial(params)
}

/// How many segments an axis of each generation grows to.
pub(crate) fn segments_of_generations(params: &Params) -> impl Iterator<Item = u32> {
    let Branching { pattern, generations, length_ratio, .. } = params.branching;
    let forks = if pattern == BranchingPattern::None { 0 } else { generations };
    let segments = f64::from(params.axis.segments);
    (0..=forks).scan(1.0, move |scale, _| {
        let grown = libm::round(segments * *scale).max(1.0);
        *scale *= length_ratio;
        Some(grown as u32)
    })
}

/// Number of segments of the full grown plant, all copies of an arrangement together (at most: younger copies
/// are smaller).
fn segments(params: &Params) -> f64 {
    let copies = match params.arrangement.pattern {
        ArrangementPattern::Single => 1.0,
        ArrangementPattern::Stem | ArrangementPattern::FlexibleStem => f64::from(params.arrangement.count),
    };
    let mut axes = 1.0;
    let mut sum = 0.0;
    for segments in segments_of_generations(params) {
        sum += axes * f64::from(segments);
        axes *= 2.0;
    }
    copies * sum
}

/// Growth steps until the plant is full grown: of the last axis on a flexible stem, else of one plant.
pub(crate) fn steps_of(params: &Params) -> f64 {
    let one: f64 = segments_of_generations(params).map(f64::from).sum();
    let arrangement = &params.arrangement;
    match arrangement.pattern {
        ArrangementPattern::FlexibleStem => {
            one + (f64::from(arrangement.count) - 1.0) * f64::from(arrangement.interval)
        }
        _ => one,
    }
}

/// Segments summed over all growth steps of one copy; on a flexible stem of all, at most.
fn stepped(params: &Params) -> f64 {
    if params.arrangement.pattern == ArrangementPattern::FlexibleStem {
        return (segments(params) + f64::from(params.arrangement.count)) * steps_of(params);
    }
    let generations: Vec<f64> = segments_of_generations(params).map(f64::from).collect();
    let mut later: f64 = generations.iter().sum();
    let mut axes = 1.0;
    let mut sum = 0.0;
    for segments in generations {
        later -= segments;
        sum += axes * segments * (0.5 * (segments + 1.0) + later);
        axes *= 2.0;
    }
    sum
}

/// What is too large about a plant, with the largest value that fits.
pub(super) fn too_large(params: &Params) -> Vec<Issue> {
    let with = |change: &dyn Fn(&mut Params)| {
        let mut changed = params.clone();
        change(&mut changed);
        changed
    };
    let total = segments(params);
    if total > MAX_SEGMENTS {
        let fewer_generations = params.branching.pattern == BranchingPattern::Bifurcation
            && segments(&with(&|params| params.branching.generations = 0)) <= MAX_SEGMENTS;
        let sentence = |most: u32, path: &str| {
            let pattern =
                format!("{path} would make {{}} segments, and {{}} is the limit; at most {{}} fits here.");
            Sentence::new(pattern, &[total, MAX_SEGMENTS, f64::from(most)])
        };
        if fewer_generations {
            let most = largest(params.branching.generations, |generations| {
                segments(&with(&|params| params.branching.generations = generations)) <= MAX_SEGMENTS
            });
            let value = f64::from(params.branching.generations);
            let path = "branching.generations";
            return vec![issue(path, value, 0.0, most, sentence(most, path))];
        }
        let most = largest(params.axis.segments, |count| {
            segments(&with(&|params| params.axis.segments = count)) <= MAX_SEGMENTS
        });
        if most > 0 {
            let path = "axis.segments";
            return vec![issue(path, f64::from(params.axis.segments), 1.0, most, sentence(most, path))];
        }
        let most = largest(params.arrangement.count, |count| {
            segments(&with(&|params| params.arrangement.count = count)) <= MAX_SEGMENTS
        });
        let path = "arrangement.count";
        return vec![issue(path, f64::from(params.arrangement.count), 1.0, most, sentence(most, path))];
    }
    let foreseen = params.solver.stepping == Stepping::Extrapolated && is_foreseeable(params);
    if params.solver.stepping == Stepping::Static || foreseen {
        return Vec::new();
    }
    let pipes = params.growth.thickening == Thickening::Pipes;
    // In space three numbers are kept of each.
    let kept = if is_spatial(params) { MAX_PIPES_LAID / 3.0 } else { MAX_PIPES_LAID };
    let limit = if pipes { kept } else { MAX_STEPPED };
    if stepped(params) <= limit {
        return Vec::new();
    }
    let most = largest(params.axis.segments, |count| {
        stepped(&with(&|params| params.axis.segments = count)) <= limit
    });
    let why =
        if pipes { "when wood thickens by pipes, whose history is kept" } else { "to be grown step by step" };
    let segments = params.axis.segments;
    let pattern = format!(
        "axis.segments must be at most {{}} {why}; it is {{}}. Fewer, longer segments give the same shape."
    );
    let message = Sentence::new(pattern, &[f64::from(most), f64::from(segments)]);
    vec![issue("axis.segments", f64::from(segments), 1.0, most, message)]
}

fn issue(path: &'static str, value: f64, min: f64, most: u32, sentence: Sentence) -> Issue {
    Issue { code: "tooLarge", path, value, sentence, min: Some(min), max: Some(f64::from(most)) }
}

/// The largest whole number below `above` for which `fits` holds, when it holds for all smaller ones; 0 if none.
fn largest(above: u32, fits: impl Fn(u32) -> bool) -> u32 {
    let (mut good, mut bad) = (0, above);
    while bad - good > 1 {
        let middle = good + (bad - good) / 2;
        if fits(middle) { good = middle } else { bad = middle }
    }
    good
}
