//! How far an upright plant is from buckling under its own weight.

use alloc::vec::Vec;

use glam::DVec3;

use super::balance::{Balance, Damping};
use super::shape::{Rods, Shape};

/// Relative width of the bracket at the end.
const PRECISION: f64 = 1e-9;
/// Loads farther than this from the present one are not looked at.
const FARTHEST: f64 = 1e6;

/// The present loads over those at which the plant, grown without load, would no longer stand: above 1 it is past its
/// critical height. `None` where the loads bend it from the start (no torque may exceed a millionth of the loads'
/// arms), so that there is nothing to buckle, and where no load up to a million times the present one suffices.
///
/// Bisection on the load, counting the Hessian's negative eigenvalues at rest: O(n) a try, some forty tries, 9 digits.
pub fn load_over_critical(rods: Rods, rest: &Shape, force: &[DVec3]) -> Option<f64> {
    let mut balance = Balance::default();
    balance.orient(rods, rest);
    let scaled = |factor: f64| -> Vec<DVec3> { force.iter().map(|force| *force * factor).collect() };
    balance.weigh(rods, rest, force, Damping::default());
    if !balance.is_unbent() || force.iter().all(|force| *force == DVec3::ZERO) {
        return None;
    }
    let mut buckles = |factor: f64| {
        balance.weigh(rods, rest, &scaled(factor), Damping::default());
        balance.unstable > 0
    };
    // From the present load on, up or down, until the critical one is between.
    let grows = !buckles(1.0);
    let mut edge = 1.0;
    while buckles(edge) != grows {
        edge = if grows { 8.0 * edge } else { edge / 8.0 };
        if !(FARTHEST.recip()..=FARTHEST).contains(&edge) {
            return None;
        }
    }
    let (mut stands, mut falls) = if grows { (edge / 8.0, edge) } else { (edge, 8.0 * edge) };
    while falls > stands * (1.0 + PRECISION) {
        let middle = 0.5 * (stands + falls);
        if buckles(middle) { falls = middle } else { stands = middle }
    }
    Some(1.0 / falls)
}
