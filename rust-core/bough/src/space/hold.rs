//! The force that holds a point of a plant in space: what the pointer does when it drags a branch.

use alloc::vec::Vec;

use glam::{DMat3, DVec3};

use super::balance::{Balance, Damping};
use super::shape::{Rods, Shape};
use crate::mechanics::{GROUND, Outcome, Settings, Status};

/// How near a point is held to where it is wanted, over the length of the path to it.
const PLACE_TOLERANCE: f64 = 1e-10;
/// Reach that is used: a rod pulled quite straight would need a force without bound.
const USED_REACH: f64 = 0.998;
/// Turn of any rod in one iteration, radians.
const LARGEST_TURN: f64 = 0.3;
const ITERATIONS: u64 = 200;

/// A force and how the search for it ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// The force at the distal end of the rod, N.
    pub force: DVec3,
    /// How the search ended. When it did not converge, the shape is as it was.
    pub outcome: Outcome,
    /// Whether the shape is a minimum of energy with that force.
    pub stable: bool,
}

/// Finds the force on the distal end of `rod` that holds it at `place` (from the foot of its path) beside the loads `force`, and
/// brings the rods to equilibrium with both. A place out of reach is drawn in to 0.998 of the reach, that of a rod on
/// the ground to where its end can be. `start` is the force that the search starts from.
///
/// Newton's method for the shape and the force together: with the Hessian H and the derivative B of the point by the rods'
/// turns, the force changes by `(B H^-1 B^T)^-1` times what the point is still off. The held shape is stable when H has no
/// more negative directions than that compliance, so H is shifted until that is so. O(n) an iteration.
pub fn hold(
    rods: Rods,
    shape: &mut Shape,
    force: &[DVec3],
    rod: usize,
    place: DVec3,
    start: DVec3,
    settings: Settings,
) -> Held {
    let saved = shape.deviation.clone();
    let path = path_to(rods, rod);
    let reach: f64 = path.iter().map(|&rod| rods.length[rod]).sum();
    // No bend shortens a rod alone: its end is on a sphere.
    let is_alone = path.len() == 1;
    let most = if is_alone { reach } else { USED_REACH * reach };
    let away = place.length();
    let wanted = place * if is_alone || away > most { most / away } else { 1.0 };
    let mut balance = Balance::default();
    balance.keeps_pivots = true;
    let mut held = Held { force: start, ..Held::default() };
    held.outcome.status = Status::MaxIterations;
    let mut pulled: Vec<DVec3> = force.to_vec();
    balance.orient(rods, shape);
    while held.outcome.iterations < ITERATIONS {
        held.outcome.iterations += 1;
        for &rod in &path {
            pulled[rod] = force[rod] + held.force;
        }
        let off = wanted - end_of(&balance, rods, &path);
        balance.weigh(rods, shape, &pulled, Damping::default());
        let left = balance.largest_residual;
        held.outcome.residual = balance.relative_residual();
        if !left.is_finite() {
            held.outcome.status = Status::NonFinite;
            break;
        }
        let bound = f64::max(settings.tolerance * balance.largest_torque, balance.round_off);
        if left <= bound && off.length() <= PLACE_TOLERANCE * reach {
            held.outcome.status = Status::Converged;
            held.outcome.unstable_directions = Some(balance.unstable);
            held.stable = balance.unstable == 0;
            break;
        }
        let mut shift = 0.0;
        let (columns, compliance) = loop {
            let columns = balance.steps_for_forces(rods, &path);
            let column = |axis: usize| balance.moved(rods, &path, |place| columns[place][axis]);
            let mut compliance = DMat3::from_cols(column(0), column(1), column(2));
            if is_alone {
                // Along the rod nothing gives way, and nothing needs to.
                let along = balance.orientation[rod] * DVec3::X;
                let trace = compliance.x_axis.x + compliance.y_axis.y + compliance.z_axis.z;
                compliance +=
                    DMat3::from_cols(along * along.x, along * along.y, along * along.z) * trace.abs();
            }
            if balance.unstable == negatives(&compliance) || shift >= 4.0 {
                break (columns, compliance);
            }
            shift = f64::max(1.0 / 256.0, 4.0 * shift);
            balance.weigh(rods, shape, &pulled, Damping { shift, caution: 0.0 });
        };
        let own: Vec<DVec3> = path.iter().map(|&rod| *balance.step_mut(rod)).collect();
        let moved = balance.moved(rods, &path, |place| own[place]);
        let change = compliance.inverse() * (off - moved);
        for (&rod, columns) in path.iter().zip(&columns) {
            *balance.step_mut(rod) += columns[0] * change.x + columns[1] * change.y + columns[2] * change.z;
        }
        let kept = shape.deviation.clone();
        let oriented = balance.orientation.clone();
        let turn = balance.advance(rods, shape, 1.0, f64::INFINITY);
        let mut scale = 1.0;
        if turn.is_nan() || turn > LARGEST_TURN {
            scale = LARGEST_TURN / turn;
            shape.deviation.clone_from(&kept);
            balance.orientation = oriented;
            balance.advance(rods, shape, scale, f64::INFINITY);
        }
        held.force += change * scale;
        if !held.force.is_finite() {
            held.outcome.status = Status::NonFinite;
            break;
        }
    }
    if held.outcome.status != Status::Converged {
        shape.deviation = saved;
    }
    held
}

/// The rods from the ground to this one.
fn path_to(rods: Rods, rod: usize) -> Vec<usize> {
    let mut path = alloc::vec![rod];
    let mut rod = rod;
    while rods.parent[rod] != GROUND {
        rod = rods.parent[rod] as usize;
        path.push(rod);
    }
    path.reverse();
    path
}

/// Where the end of a path is, from its foot.
fn end_of(balance: &Balance, rods: Rods, path: &[usize]) -> DVec3 {
    path.iter().fold(DVec3::ZERO, |end, &rod| end + balance.orientation[rod] * DVec3::X * rods.length[rod])
}

/// How many eigenvalues of a symmetric matrix are negative, by its leading minors.
fn negatives(matrix: &DMat3) -> u32 {
    let [a, b] = [matrix.x_axis, matrix.y_axis];
    let minors = [a.x, a.x * b.y - a.y * b.x, matrix.determinant()];
    let mut before = true;
    minors.iter().fold(0, |count, &minor| {
        let now = minor > 0.0;
        let changed = now != before;
        before = now;
        count + u32::from(changed)
    })
}
