//! Figure 8 against figure 10: the same rod cut evenly and unevenly.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

use bough::grow;
use bough::params::{Discretization, PRESETS, Params};

/// The point of a centre line at a distance along it, by linear interpolation.
fn at(points: &[f64], distance: f64) -> [f64; 2] {
    let mut before = 0.0;
    for pair in points.windows(6).step_by(3) {
        let length = (pair[3] - pair[0]).hypot(pair[4] - pair[1]);
        if before + length >= distance {
            let share = (distance - before) / length;
            return [pair[0] + share * (pair[3] - pair[0]), pair[1] + share * (pair[4] - pair[1])];
        }
        before += length;
    }
    let end = points.len() - 3;
    [points[end], points[end + 1]]
}

fn preset(id: &str) -> Params {
    Params::of_preset(PRESETS.iter().find(|preset| preset.id == id).unwrap())
}

#[test]
fn both_cuts_approach_the_same_shape() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        let mut distances = Vec::new();
        for segments in [20, 40, 80, 160] {
            let shapes = ["figure-8d", "figure-10"].map(|id| {
                let mut params = preset(id);
                let total = f64::from(params.axis.segments) * params.axis.segment_length;
                params.axis.segments = segments;
                params.axis.segment_length = total / f64::from(segments);
                params.solver.discretization = discretization;
                grow(&params).unwrap().polylines.points
            });
            let apart = |share: i32| {
                let distance = 1.5 * f64::from(share) / 100.0;
                let [even, uneven] = [at(&shapes[0], distance), at(&shapes[1], distance)];
                (even[0] - uneven[0]).hypot(even[1] - uneven[1]) / 1.5
            };
            let largest = (0..=100).map(apart).fold(0.0, f64::max);
            println!("{discretization:?}, {segments} segments: largest distance {largest:.3e} L");
            distances.push(largest);
        }
        // First order halves with each doubling, second order quarters.
        let least = if discretization == Discretization::Paper { 1.8 } else { 3.5 };
        for pair in distances.windows(2) {
            assert!(pair[0] / pair[1] > least, "{distances:?}");
        }
    }
}
