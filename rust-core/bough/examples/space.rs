//! Branching plants in space, grown with pipes and solved at once: time, iterations, memory, against the floor loop.
//!
//! `cargo run --release --example space`

#![allow(clippy::disallowed_methods, reason = "an example may look at the clock; the core may not")]

use std::time::Instant;

use bough::Growth;
use bough::mechanics::{GROUND, Linkage};
use bough::params::{BoughError, BranchingPattern, Degrees, Params, Stepping, Thickening};
use bough::space::{Balance, NEUTRAL, Rods, Shape, exp, gather};
use glam::{DQuat, DVec3};

#[path = "shared/floor.rs"]
mod floor;

/// Shortest time of the floor loop over 1000 segments, ns a segment: of moments so short that other work seldom falls into them.
fn floor_time() -> f64 {
    let angles: Vec<f64> = (0..1000).map(|segment| 0.001 * f64::from(segment)).collect();
    let mut sums = vec![0.0; 1000];
    let time = |sums: &mut [f64]| {
        let start = Instant::now();
        for _ in 0..20 {
            floor::floor(std::hint::black_box(&angles), sums);
        }
        start.elapsed().as_secs_f64() * 1e9 / 20e3
    };
    (0..2000).map(|_| time(&mut sums)).fold(f64::INFINITY, f64::min)
}

/// Shortest time of one iteration of a binary tree of rods in space, ns a rod.
fn iteration_time(segments: u32) -> f64 {
    let (mut linkage, mut shape) = (Linkage::default(), Shape::default());
    for rod in 0..segments {
        let parent = if rod == 0 { GROUND } else { (rod - 1) / 2 };
        linkage.push(parent, 0.1, 100.0, 0.0);
        let aside = DVec3::new(0.3, 0.2, if rod % 2 == 0 { 0.4 } else { -0.4 });
        shape.push(exp(aside), DQuat::IDENTITY);
    }
    let mut force = vec![DVec3::NEG_Y * 1e-3; segments as usize];
    gather(&linkage.parent, &mut force);
    let (rods, mut balance) = (Rods::new(&linkage, 0.2), Balance::default());
    balance.orient(rods, &shape);
    let mut time = |shape: &mut Shape| {
        let start = Instant::now();
        balance.weigh(rods, shape, &force, NEUTRAL);
        balance.advance(rods, shape, 1e-3, f64::INFINITY);
        start.elapsed().as_secs_f64() * 1e9 / f64::from(segments)
    };
    (0..10_000_000 / segments).map(|_| time(&mut shape)).fold(f64::INFINITY, f64::min)
}

/// A tree whose forks stand crosswise, on wood that seeks the light and thickens.
fn tree(generations: u32, stiffness: f64) -> Params {
    let mut params = Params::default();
    params.axis.segments = 15;
    params.axis.segment_length = 0.02;
    params.axis.radius = 0.002;
    params.axis.elevation = Degrees(70.0);
    params.material.youngs_modulus = stiffness;
    params.growth.thickening = Thickening::Pipes;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = generations;
    params.branching.roll = Degrees(75.0);
    params.tropism.strength = 1.0;
    params
}

fn main() -> Result<(), BoughError> {
    println!("floor loop: {:.2} ns a segment", floor_time());
    println!("one Newton iteration: torques, Hessian, elimination, step");
    for segments in [1000_u32, 100_000] {
        let (iteration, floor) = (iteration_time(segments), floor_time());
        println!("{segments:>8} segments {iteration:.0} ns a segment, {:.1} x floor", iteration / floor);
    }
    println!("grown with pipes, every step in equilibrium to 1e-10");
    println!("segments  steps  iterations/step      time  ns/(segment and iteration)  over floor    memory");
    let sizes: &[u32] = if std::env::args().any(|it| it == "--quick") { &[6, 9] } else { &[6, 9, 12, 15] };
    for &generations in sizes {
        let mut growth = Growth::new(&tree(generations, 5e9))?;
        let (mut worked, mut before) = (0.0, 0);
        let start = seconds();
        while growth.step() {
            let report = growth.report();
            worked += growth.segments() as f64 * (report.iterations - before) as f64;
            before = report.iterations;
        }
        let seconds = seconds() - start;
        let report = *growth.report();
        let each = seconds * 1e9 / worked;
        println!(
            "{:>8} {:>6} {:>16.2} {:>8.2} s {:>27.0} {:>11.1} {:>9}  {:?}, worst residual {:.1e}",
            growth.segments(),
            report.steps,
            report.iterations as f64 / f64::from(report.steps),
            seconds,
            each,
            each / floor_time(),
            peak_memory(),
            report.status,
            report.worst_step_residual,
        );
    }
    println!("solved at once, from the unloaded shape");
    for (name, generations, stiffness) in
        [("stiff", 12, 5e9), ("floppy", 12, 5e7), ("limp", 12, 5e5), ("floppy", 9, 5e7)]
    {
        let mut params = tree(generations, stiffness);
        params.solver.stepping = Stepping::Static;
        let start = seconds();
        let plant = bough::grow(&params)?;
        let report = plant.report;
        println!(
            "{name:>8} {:>8} segments, q = {:.1e}: {} iterations, {:.2} s, {:?}, stable {:?}, residual {:.1e}",
            plant.segments.length.len(),
            report.gravity_number,
            report.iterations,
            seconds() - start,
            report.status,
            report.stable,
            report.residual,
        );
    }
    Ok(())
}

/// Seconds that the processor has worked for this program, where the system tells, so that other work does not count; otherwise
/// those of the clock.
fn seconds() -> f64 {
    let worked = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = worked.split_whitespace().next().and_then(|number| number.parse::<f64>().ok());
    let clock = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    nanoseconds.map_or_else(|| clock.map_or(0.0, |it| it.as_secs_f64()), |it| it * 1e-9)
}

/// The process's largest resident size so far, where the system tells.
fn peak_memory() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    peak.map_or_else(|| "unknown".to_owned(), |peak| peak.split_whitespace().collect())
}
