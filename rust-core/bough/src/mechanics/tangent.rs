//! How an equilibrium moves with what it depends on: the implicit function theorem, with the Hessian's own elimination.

use alloc::vec;
use alloc::vec::Vec;

use super::hessian::Elimination;
use super::linkage::{GROUND, Linkage};
use super::loads::Loads;

/// By how much everything about a linkage and its loads changes with some parameter: one derivative a rod.
#[derive(Clone, Debug, Default)]
pub struct Tangent {
    /// Of the lengths.
    pub length: Vec<f64>,
    /// Of the spring constants.
    pub stiffness: Vec<f64>,
    /// Of the rest angles.
    pub rest: Vec<f64>,
    /// Of the deviations; those that keep the balance follow from all others.
    pub deviation: Vec<f64>,
    /// Of the loads beyond each rod, in the frame of the base direction.
    pub load: Loads,
}

impl Tangent {
    /// By how much each rod turns, radians a unit of the parameter, when its joints change by these sums.
    pub fn turns(&self, linkage: &Linkage, with_deviations: bool) -> Vec<f64> {
        let mut turns: Vec<f64> = Vec::with_capacity(self.rest.len());
        for (rod, rest) in self.rest.iter().enumerate() {
            let below = match linkage.parent[rod] {
                GROUND => 0.0,
                parent => turns[parent as usize],
            };
            turns.push(below + rest + if with_deviations { self.deviation[rod] } else { 0.0 });
        }
        turns
    }
}

impl Elimination {
    /// Writes the change of the deviations that keeps every joint in balance while all else changes as `tangent` says.
    /// The equilibrium was evaluated and eliminated before. O(n): the torques that the changes leave over, solved for as
    /// in a step of Newton's method.
    pub fn respond(&mut self, linkage: &Linkage, loads: &Loads, tangent: &mut Tangent) {
        let rods = linkage.len();
        let turned = tangent.turns(linkage, false);
        let mut beyond = vec![0.0; rods];
        let mut left = vec![0.0; rods];
        for rod in (0..rods).rev() {
            let (sin, cos) = self.sine_and_cosine(rod);
            let own = tangent.length[rod] * (cos * loads.y[rod] - sin * loads.x[rod])
                + linkage.length[rod] * (cos * tangent.load.y[rod] - sin * tangent.load.x[rod])
                - linkage.length[rod] * (cos * loads.x[rod] + sin * loads.y[rod]) * turned[rod];
            let torque = beyond[rod] + own;
            left[rod] = tangent.stiffness[rod] * linkage.deviation[rod] - torque;
            if linkage.parent[rod] != GROUND {
                beyond[linkage.parent[rod] as usize] += torque;
            }
        }
        self.solve(linkage, &left, &mut tangent.deviation);
    }
}
