//! What several tests share: rods given by their dimensionless groups, and convergence orders.
#![allow(dead_code, reason = "each test uses a part")]

pub(crate) mod space;

use bough::params::{Params, Thickening};

/// A uniform rod of length 1 m and radius 10 mm with `q = w L^3 / EI`, cut into equal segments.
pub(crate) fn heavy_rod(elevation: f64, q: f64, segments: u32) -> Params {
    let mut params = Params::default();
    params.axis.elevation = bough::angle::Degrees(elevation);
    params.axis.segments = segments;
    params.axis.segment_length = 1.0 / f64::from(segments);
    params.axis.radius = 0.01;
    // q = rho g pi R^2 L^3 / (E pi R^4 / 4)
    let weight = params.material.density * params.loads.gravity;
    params.material.youngs_modulus = 4.0 * weight / (q * params.axis.radius * params.axis.radius);
    params
}

/// An axis of length 1 m that grows by pipes with `K L^2 = rho g A1 l L^2 / (2 E I1)`, cut into equal segments.
pub(crate) fn piped_rod(elevation: f64, k_l_squared: f64, segments: u32) -> Params {
    // K L^2 = (1/2) l q(one pipe): the pipe's own q, times half a segment over the length.
    let q = 2.0 * k_l_squared * f64::from(segments);
    let mut params = heavy_rod(elevation, q, segments);
    params.growth.thickening = Thickening::Pipes;
    params
}

/// Slope of log(error) against log(segments), by least squares; positive when the error falls.
pub(crate) fn fitted_order(segments: &[u32], errors: &[f64]) -> f64 {
    let points: Vec<(f64, f64)> =
        segments.iter().zip(errors).map(|(&n, &error)| (f64::from(n).ln(), error.ln())).collect();
    let count = points.len() as f64;
    let mean_x = points.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = points.iter().map(|(_, y)| y).sum::<f64>() / count;
    let covariance: f64 = points.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let variance: f64 = points.iter().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
    -covariance / variance
}

/// Distance of two points.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The limit at infinitely many segments of values whose error is a power series in `1 / segments` with these
/// lowest powers, by eliminating one term after the other (Richardson).
pub(crate) fn extrapolated(segments: &[u32], values: &[f64], powers: &[i32]) -> f64 {
    assert!(segments.len() == values.len() && powers.len() < segments.len());
    assert!(segments.windows(2).all(|pair| pair[1] == 2 * pair[0]), "each cut twice as fine");
    let mut values = values.to_vec();
    for &power in powers {
        let factor = 2_f64.powi(power);
        values = values.windows(2).map(|pair| (factor * pair[1] - pair[0]) / (factor - 1.0)).collect();
    }
    values[values.len() - 1]
}

/// So many random cases, the same ones in every run: a check that fails must fail again. `BOUGH_SEED` draws others.
pub(crate) fn cases(cases: u32) -> proptest::test_runner::Config {
    let seed = std::env::var("BOUGH_SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(1998);
    proptest::test_runner::Config {
        cases,
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(seed),
        ..Default::default()
    }
}
