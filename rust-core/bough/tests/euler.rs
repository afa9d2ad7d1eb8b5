//! Newton against the paper's Euler relaxation: two ways to one equilibrium.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::grow;
use bough::mechanics::Status;
use bough::params::{Degrees, Discretization, Method, Params, Thickening};
use support::{heavy_rod, piped_rod};

fn largest_distance(params: &Params) -> f64 {
    let newton = grow(params).unwrap();
    let mut relaxed = params.clone();
    relaxed.solver.method = Method::Euler;
    let euler = grow(&relaxed).unwrap();
    assert_eq!(newton.report.status, Status::Converged);
    assert_eq!(euler.report.status, Status::Converged);
    assert!(euler.report.worst_step_residual <= 1e-10, "{:?}", euler.report);
    println!(
        "{} Newton iterations, {} Euler steps over {} growth steps",
        newton.report.iterations, euler.report.iterations, newton.report.steps
    );
    let both = newton.polylines.points.iter().zip(&euler.polylines.points);
    both.map(|(newton, euler)| (newton - euler).abs()).fold(0.0, f64::max)
}

#[test]
fn they_agree_on_elastic_rods() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        for (elevation, q) in [(0.0, 1.0), (50.0, 10.0), (80.0, 5.0), (-30.0, 20.0)] {
            let mut params = heavy_rod(elevation, q, 40);
            params.solver.discretization = discretization;
            let distance = largest_distance(&params);
            println!("{discretization:?}, {elevation} deg, q {q}: {distance:.1e} L apart");
            assert!(distance < 1e-6);
        }
    }
}

#[test]
fn they_agree_through_a_growth_with_pipes_and_tropism() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        let mut params = piped_rod(50.0, 2.0, 40);
        assert_eq!(params.growth.thickening, Thickening::Pipes);
        params.tropism.elevation = Degrees(60.0);
        params.tropism.strength = 3.0;
        params.solver.discretization = discretization;
        let distance = largest_distance(&params);
        println!("{discretization:?}: {distance:.1e} L apart");
        assert!(distance < 1e-6);
    }
}

/// At its buckling load a column has next to no stiffness against leaning, and relaxation next to no speed: the
/// step limit is met far from balance, and the report says so.
#[test]
fn euler_says_when_it_does_not_get_there() {
    let column = |q: f64| heavy_rod(90.0, q, 6);
    let (mut stable, mut unstable) = (5.0, 10.0);
    while unstable - stable > 1e-12 {
        let middle = 0.5 * (stable + unstable);
        let upright = grow(&column(middle)).unwrap().report.self_buckling.unwrap() < 1.0;
        *(if upright { &mut stable } else { &mut unstable }) = middle;
    }
    let mut params = heavy_rod(90.0 - 1e-9, stable, 6);
    params.solver.method = Method::Euler;
    params.solver.stepping = bough::params::Stepping::Static;
    let report = grow(&params).unwrap().report;
    assert_eq!((report.status, report.stable), (Status::MaxIterations, None));
    assert!(report.residual > 1e-10, "{report:?}");
}
