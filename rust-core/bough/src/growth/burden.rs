//! What the plant carries beside its wood: leaves along young wood, and fruit at the tips.

use super::state::Growth;
use crate::mechanics::GROUND;
use crate::params::Discretization;

impl Growth {
    /// Whether a segment is young enough for leaves: born in the last `loads.foliageAge` growth steps.
    pub(super) fn bears_leaves(&self, rod: usize) -> bool {
        self.state.step < self.state.wood[rod].birth.saturating_add(self.params.loads.foliage_age)
    }

    /// Mass of a segment's leaves, kg.
    pub(super) fn leaf_mass(&self, rod: usize) -> f64 {
        if self.bears_leaves(rod) { self.params.loads.foliage * self.state.linkage.length[rod] } else { 0.0 }
    }

    /// Adds what leaves and so much fruit at every tip weigh to the masses lumped at the rods' distal ends, kg.
    pub(super) fn add_burden(&self, fruit: f64, lumped: &mut [f64]) {
        for axis in self.state.axes.iter().filter(|axis| axis.is_tip()) {
            lumped[axis.bearer as usize] += fruit;
        }
        if self.params.loads.foliage > 0.0 {
            for rod in 0..lumped.len() {
                let mass = self.leaf_mass(rod);
                self.shares(rod).for_each(|(node, share)| lumped[node] += share * mass);
            }
        }
    }

    /// Which nodes bear what lies evenly along a rod, and their shares: all at its distal end, or half of it at the end of its
    /// bearer, as the discretization has it. What the ground bears bends nothing.
    pub(super) fn shares(&self, rod: usize) -> impl Iterator<Item = (usize, f64)> {
        let bearer = self.state.linkage.parent[rod];
        let halves = self.params.solver.discretization == Discretization::SecondOrder;
        let share = if halves { 0.5 } else { 1.0 };
        let below = (halves && bearer != GROUND).then_some((bearer as usize, share));
        core::iter::once((rod, share)).chain(below)
    }
}
