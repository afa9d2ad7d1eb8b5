//! Gradient, Hessian and inertia against finite differences of the energy and dense matrices, on random chains
//! and trees.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::mechanics::{Elimination, GROUND, Linkage, Loads, energy, gradient};
use proptest::prelude::*;

/// A random tree in a random state: parents, lengths, stiffnesses, rest angles, deviations, forces.
fn tree(most: usize) -> impl Strategy<Value = (Linkage, Loads)> {
    let rod = (0.0..1.0, 0.1..2.0, 0.1..5.0, -1.0..1.0, -1.0..1.0, -3.0..3.0, -3.0..3.0);
    prop::collection::vec(rod, 1..most).prop_map(|rods| {
        let mut linkage = Linkage::default();
        let mut loads = Loads::none(rods.len());
        for (index, (bearer, length, stiffness, rest, deviation, x, y)) in rods.into_iter().enumerate() {
            let parent = match (index as f64 * bearer) as u32 {
                _ if index == 0 => GROUND,
                parent => parent,
            };
            linkage.push(parent, length, stiffness, rest);
            linkage.deviation[index] = deviation;
            loads.x[index] = x;
            loads.y[index] = y;
        }
        loads.gather(&linkage);
        (linkage, loads)
    })
}

/// Turns one rod, and nothing else, by a small angle.
fn with_rod_turned(linkage: &Linkage, rod: usize, turn: f64) -> Linkage {
    let mut turned = linkage.clone();
    turned.deviation[rod] += turn;
    for other in 0..linkage.len() {
        if linkage.parent[other] == rod as u32 {
            turned.deviation[other] -= turn;
        }
    }
    turned
}

/// The Hessian as a dense matrix, by central differences of the gradient.
fn dense_hessian(linkage: &Linkage, loads: &Loads) -> Vec<Vec<f64>> {
    let step = 1e-5;
    (0..linkage.len())
        .map(|rod| {
            let ahead = gradient(&with_rod_turned(linkage, rod, step), loads);
            let behind = gradient(&with_rod_turned(linkage, rod, -step), loads);
            ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * step)).collect()
        })
        .collect()
}

/// Eigenvalues of a symmetric matrix by Jacobi rotations.
fn eigenvalues(mut matrix: Vec<Vec<f64>>) -> Vec<f64> {
    let size = matrix.len();
    for _ in 0..60 {
        for row in 0..size {
            for column in row + 1..size {
                let off = matrix[row][column];
                if off.abs() < 1e-300 {
                    continue;
                }
                let ratio = (matrix[column][column] - matrix[row][row]) / (2.0 * off);
                let tangent = ratio.signum() / (ratio.abs() + (ratio * ratio + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                for line in &mut matrix {
                    let (a, b) = (line[row], line[column]);
                    line[row] = cosine * a - sine * b;
                    line[column] = sine * a + cosine * b;
                }
                for index in 0..size {
                    let (a, b) = (matrix[row][index], matrix[column][index]);
                    matrix[row][index] = cosine * a - sine * b;
                    matrix[column][index] = sine * a + cosine * b;
                }
            }
        }
    }
    (0..size).map(|index| matrix[index][index]).collect()
}

proptest! {
    #![proptest_config(support::cases(200))]

    #[test]
    fn the_gradient_is_the_slope_of_the_energy((linkage, loads) in tree(30)) {
        // Central differences of step h leave h^2 E''' + eps E / h: 1e-9 of the energy's scale at h = 1e-5.
        let exact = gradient(&linkage, &loads);
        let scale: f64 = 1.0 + exact.iter().fold(0.0, |largest, slope| f64::max(largest, slope.abs()));
        let size = 1.0 + energy(&linkage, &loads).abs();
        for rod in 0..linkage.len() {
            let ahead = energy(&with_rod_turned(&linkage, rod, 1e-5), &loads);
            let behind = energy(&with_rod_turned(&linkage, rod, -1e-5), &loads);
            let slope = (ahead - behind) / 2e-5;
            prop_assert!((slope - exact[rod]).abs() < 1e-9 * (scale + size), "{} {}", slope, exact[rod]);
        }
    }

    #[test]
    fn newton_solves_with_the_hessian((linkage, loads) in tree(30)) {
        let hessian = dense_hessian(&linkage, &loads);
        let slope = gradient(&linkage, &loads);
        let mut state = Elimination::default();
        state.evaluate(&linkage, &loads);
        let pivots_negative = state.eliminate(&linkage, 0.0);
        let mut increment = Vec::new();
        let turn = state.newton_step(&linkage, &mut increment);
        // Near a singular Hessian the step is large and the differences' error with it.
        prop_assume!(turn < 1e3);
        let mut turns: Vec<f64> = Vec::new();
        for rod in 0..linkage.len() {
            let below = match linkage.parent[rod] { GROUND => 0.0, parent => turns[parent as usize] };
            turns.push(below + increment[rod]);
        }
        for row in 0..linkage.len() {
            let product: f64 = hessian[row].iter().zip(&turns).map(|(entry, turn)| entry * turn).sum();
            prop_assert!((product + slope[row]).abs() < 1e-6 * (1.0 + turn) * (1.0 + slope[row].abs()));
        }
        // Sylvester: as many negative pivots as negative eigenvalues, unless one is as good as zero.
        let eigenvalues = eigenvalues(hessian);
        prop_assume!(eigenvalues.iter().all(|value| value.abs() > 1e-6));
        let negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
        prop_assert_eq!(negative, pivots_negative as usize);
    }
}
