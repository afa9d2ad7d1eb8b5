//! How long the core takes, over a floor loop of one sine, one cosine and ten flops a segment: medians in one run.
//!
//! `cargo run --release --example speed`

#![allow(clippy::disallowed_methods, reason = "an example may look at the clock; the core may not")]

use std::hint::black_box;
use std::time::Instant;

use bough::grow;
use bough::mechanics::{Elimination, GROUND, Linkage, Loads};
use bough::params::{BoughError, Params, Stepping, Thickening};

#[path = "shared/floor.rs"]
mod floor;
use floor::floor;

/// Median and range of the seconds that `work` takes.
fn timed(runs: usize, mut work: impl FnMut()) -> [f64; 3] {
    let mut seconds: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    [seconds[0], seconds[runs / 2], seconds[runs - 1]]
}

/// A rod of length 1 with EI = 1 and q = 10, in its second-order cut.
fn rod(segments: usize) -> (Linkage, Loads) {
    let length = 1.0 / segments as f64;
    let mut linkage = Linkage::default();
    let mut loads = Loads::none(segments);
    for segment in 0..segments {
        let stiffness = if segment == 0 { 2.0 / length } else { 1.0 / length };
        linkage.push(if segment == 0 { GROUND } else { segment as u32 - 1 }, length, stiffness, 0.0);
        linkage.deviation[segment] = -1e-4;
        loads.y[segment] = -10.0 * length;
    }
    loads.gather(&linkage);
    (linkage, loads)
}

fn main() -> Result<(), BoughError> {
    println!("{:44} {:>10} {:>22}", "", "median", "range");
    let mut floor_time = 0.0;
    for segments in [20, 100, 1000, 10_000, 100_000] {
        let rounds = (2_000_000 / segments).max(1);
        let per_segment =
            |seconds: [f64; 3]| seconds.map(|seconds| seconds * 1e9 / (segments * rounds) as f64);
        let angles: Vec<f64> = (0..segments).map(|index| index as f64 / segments as f64).collect();
        let mut sums = vec![0.0; segments];
        let [least, median, most] = per_segment(timed(15, || {
            for _ in 0..rounds {
                floor(black_box(&angles), &mut sums);
            }
        }));
        black_box(&sums);
        floor_time = if segments == 1000 { median } else { floor_time };
        println!(
            "{:44} {median:>7.2} ns {least:>9.2} .. {most:>8.2}",
            format!("floor loop, {segments}, a segment")
        );
        let (mut linkage, loads) = rod(segments);
        let start = linkage.deviation.clone();
        let mut state = Elimination::default();
        let [least, median, most] = per_segment(timed(15, || {
            for _ in 0..rounds {
                linkage.deviation.copy_from_slice(&start);
                state.evaluate(black_box(&linkage), &loads);
                black_box(state.largest_residual() + state.largest_torque());
                black_box(state.newton(&mut linkage));
            }
        }));
        println!(
            "{:44} {median:>7.2} ns {least:>9.2} .. {most:>8.2}",
            format!("Newton iteration, {segments}, a segment")
        );
    }
    for segments in [20_u32, 100, 1000] {
        for (name, thickening, stepping) in [
            ("static solve", Thickening::None, Stepping::Static),
            ("growth", Thickening::None, Stepping::Exact),
            ("growth with pipes", Thickening::Pipes, Stepping::Exact),
        ] {
            let mut params = Params::default();
            params.axis.segments = segments;
            params.axis.segment_length = 1.5 / f64::from(segments);
            params.axis.radius =
                if thickening == Thickening::Pipes { 0.0127 / f64::from(segments).sqrt() } else { 0.005 };
            params.growth.thickening = thickening;
            params.solver.stepping = stepping;
            let mut iterations = 0;
            let [least, median, most] = timed(9, || {
                iterations = grow(black_box(&params)).map_or(0, |plant| plant.report.iterations);
            })
            .map(|seconds| seconds * 1e3);
            println!(
                "{:44} {median:>7.3} ms {least:>9.3} .. {most:>8.3}   {iterations} iterations",
                format!("{name}, {segments}")
            );
        }
    }
    Ok(())
}
