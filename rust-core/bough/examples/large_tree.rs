//! A tree of about 100,000 segments, solved at once and grown over 12 generations: time, iterations, residual,
//! memory.
//!
//! `cargo run --release --example large_tree`

#![allow(clippy::disallowed_methods, reason = "an example may look at the clock; the core may not")]

use std::time::Instant;

use bough::grow;
use bough::params::{BoughError, BranchingPattern, Degrees, Params, Stepping, Thickening};

fn main() -> Result<(), BoughError> {
    println!(
        "{:28} {:>9} {:>7} {:>6} {:>9} {:>11} {:>9}",
        "", "segments", "steps", "its", "time", "residual", "peak"
    );
    for (name, stepping, thickening) in [
        ("static", Stepping::Static, Thickening::None),
        ("grown", Stepping::Exact, Thickening::None),
        ("grown with pipes", Stepping::Exact, Thickening::Pipes),
        ("grown with pipes, tropism", Stepping::Exact, Thickening::Pipes),
    ] {
        let mut params = Params::default();
        params.axis.segments = 12;
        params.axis.segment_length = 0.02;
        params.axis.radius = if thickening == Thickening::Pipes { 0.002 } else { 0.02 };
        params.axis.elevation = Degrees(70.0);
        params.material.youngs_modulus = 5e9;
        params.branching.pattern = BranchingPattern::Bifurcation;
        params.branching.generations = 12;
        params.tropism.strength = if name.ends_with("tropism") { 1.0 } else { 0.0 };
        params.growth.thickening = thickening;
        params.solver.stepping = stepping;
        let start = Instant::now();
        let plant = grow(&params)?;
        let report = plant.report;
        println!(
            "{name:28} {:>9} {:>7} {:>6} {:>7.0}ms {:>11.1e} {:>9}  {:?}, stable {:?}",
            plant.segments.length.len(),
            report.steps,
            report.iterations,
            start.elapsed().as_secs_f64() * 1e3,
            report.worst_step_residual,
            peak_memory(),
            report.status,
            report.stable,
        );
    }
    Ok(())
}

/// The process's largest resident size so far, where the system tells.
fn peak_memory() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    peak.map_or_else(|| "unknown".to_owned(), |peak| peak.split_whitespace().collect())
}
