//! What the plant weighs, and the loads that follow.

use super::state::Growth;
use crate::mechanics::{GROUND, Loads};
use crate::params::Discretization;

impl Growth {
    /// Mass of a segment's wood, kg (equation 23); 0 for the node of a fork.
    pub(super) fn mass(&self, rod: usize) -> f64 {
        f64::from(self.pipes(rod)) * self.state.wood[rod].pipe_mass
    }

    /// Mass lumped at each rod's distal end, kg: all of a segment's, or half of it with the other half at its base.
    pub(super) fn lumped_masses(&self) -> Vec<f64> {
        let linkage = &self.state.linkage;
        let mut lumped = vec![0.0; linkage.len()];
        for rod in 0..linkage.len() {
            let mass = self.mass(rod);
            if self.params.solver.discretization == Discretization::Paper {
                lumped[rod] += mass;
            } else {
                lumped[rod] += 0.5 * mass;
                if linkage.parent[rod] != GROUND {
                    lumped[linkage.parent[rod] as usize] += 0.5 * mass;
                }
            }
        }
        for axis in self.state.axes.iter().filter(|axis| !axis.forked && axis.segments > 0) {
            lumped[axis.bearer as usize] += self.params.loads.tip_mass;
        }
        lumped
    }

    /// All loads of the present plant, in the frame of the base direction.
    pub(super) fn weigh(&self, masses: &[f64]) -> Loads {
        let (sin, cos) = self.params.axis.elevation.sin_cos();
        let [tip_x, tip_y, _] = self.params.loads.tip_force;
        let gravity = self.params.loads.gravity;
        let main_tip = self.state.axes.first().map(|axis| axis.bearer as usize);
        let mut loads = Loads::none(masses.len());
        for (rod, mass) in masses.iter().enumerate() {
            let (x, y) = if Some(rod) == main_tip { (tip_x, tip_y) } else { (0.0, 0.0) };
            let y = y - mass * gravity;
            loads.x[rod] = x * cos + y * sin;
            loads.y[rod] = y * cos - x * sin;
        }
        loads.gather(&self.state.linkage);
        loads
    }

    /// Weight times squared length (along the longest path) over the flexural rigidity at the base.
    pub(super) fn gravity_number(&self) -> f64 {
        if self.state.wood.is_empty() {
            return 0.0;
        }
        let linkage = &self.state.linkage;
        let tips = self.state.axes.iter().filter(|axis| !axis.forked).count();
        let wood: f64 = (0..linkage.len()).map(|rod| self.mass(rod)).sum();
        let weight = (wood + tips as f64 * self.params.loads.tip_mass) * self.params.loads.gravity;
        let mut reach: Vec<f64> = Vec::with_capacity(linkage.len());
        let mut length = 0.0_f64;
        for rod in 0..linkage.len() {
            let below = if linkage.parent[rod] == GROUND { 0.0 } else { reach[linkage.parent[rod] as usize] };
            reach.push(below + linkage.length[rod]);
            length = length.max(below + linkage.length[rod]);
        }
        let rigidity = self.params.material.youngs_modulus * self.section(0).second_moment_of_area();
        weight * length * length / rigidity
    }
}
