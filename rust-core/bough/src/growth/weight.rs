//! What the plant weighs, and the loads that follow.

use alloc::vec;
use alloc::vec::Vec;

use glam::DVec3;

use super::pull::{act, act_in_space, into_plane, turned};
use super::state::{Growth, State};
use crate::mechanics::{GROUND, Loads, pass_down};
use crate::params::{ArrangementPattern, Discretization, Thickening};

impl Growth {
    /// Mass of a segment's wood, kg (equation 23); 0 for the node of a fork.
    pub(super) fn mass(&self, rod: usize) -> f64 {
        f64::from(self.pipes(rod)) * self.state.pipes.mass[rod]
    }

    /// Mass lumped at each rod's distal end, kg, with leaves and fruit.
    pub(super) fn lumped_masses(&self) -> Vec<f64> {
        let mut lumped = vec![0.0; self.rods()];
        for rod in 0..lumped.len() {
            let mass = self.mass(rod);
            self.shares(rod).for_each(|(node, share)| lumped[node] += share * mass);
        }
        self.add_burden(self.params.loads.tip_mass, &mut lumped);
        lumped
    }

    /// Puts all loads on the present plant; those before are kept aside.
    pub(super) fn weigh(&mut self) {
        core::mem::swap(&mut self.state.loads, &mut self.before);
        core::mem::swap(&mut self.state.force, &mut self.force_before);
        let mut loads = core::mem::take(&mut self.state.loads);
        let mut force = core::mem::take(&mut self.state.force);
        self.load_with(self.params.loads.tip_mass, &mut loads, &mut force);
        self.state.loads = loads;
        self.state.force = force;
    }

    /// All loads on the present plant, with a mass of fruit at every tip, kg: in its plane, or in space.
    pub(super) fn load_with(&self, fruit: f64, loads: &mut Loads, force: &mut Vec<DVec3>) {
        let rods = self.rods();
        for array in [&mut loads.x, &mut loads.y] {
            array.clear();
            array.resize(rods, 0.0);
        }
        // Until its turn, the x of a rod holds the mass beyond it.
        self.add_burden(fruit, &mut loads.x);
        let params = &self.params;
        let State { step, linkage, pipes, axes, .. } = &self.state;
        let Loads { x, y } = loads;
        // Without thickening every rod has one pipe: none more in any step.
        let (step, each) = match params.growth.thickening {
            Thickening::None => (1.0, 0.0),
            Thickening::Pipes => (f64::from(*step), 1.0),
        };
        let share = if params.solver.discretization == Discretization::Paper { 1.0 } else { 0.5 };
        let (sin, cos) = params.axis.elevation.sin_cos();
        let gravity = params.loads.gravity;
        // In space the loads' x alone is used, for the weight beyond each rod.
        let (down_x, down_y) =
            if self.is_spatial { (-gravity, 0.0) } else { (-gravity * sin, -gravity * cos) };
        // From the tips down: each rod bears what is beyond it and its own share; its parent bears all of it.
        let mut passed = 0.0;
        let (parent, since, first) = (&linkage.parent[..rods], &pipes.since[..rods], &pipes.mass[..rods]);
        let (x, y) = (&mut x[..rods], &mut y[..rods]);
        for rod in (0..rods).rev() {
            let mass = (step - each * since[rod]) * first[rod];
            let beyond = x[rod] + passed;
            let borne = beyond + share * mass;
            x[rod] = borne * down_x;
            y[rod] = borne * down_y;
            passed = pass_down(parent[rod], rod, beyond + mass, x);
        }
        if self.is_spatial {
            force.clear();
            force.extend(x.iter().map(|&weight| DVec3::new(0.0, weight, 0.0)));
        }
        let mains = axes.iter().filter(|axis| axis.generation == 0 && axis.segments > 0);
        // Around a stem every axis is pulled at, in its own plane.
        let around = params.arrangement.pattern != ArrangementPattern::Single;
        let most = if around { axes.len() } else { 1 };
        for main in mains.take(most) {
            let tip = main.bearer as usize;
            let pull =
                if around { turned(main.azimuth, params.loads.tip_force) } else { params.loads.tip_force };
            if self.is_spatial {
                act_in_space(linkage, force, tip, DVec3::from_array(pull));
            } else {
                act(linkage, loads, tip, into_plane(params, pull));
            }
        }
    }

    /// Weight times squared length (along the longest path) over the flexural rigidity at the base.
    pub(super) fn gravity_number(&self) -> f64 {
        if self.state.wood.is_empty() {
            return 0.0;
        }
        let linkage = &self.state.linkage;
        let tips = self.state.axes.iter().filter(|axis| axis.is_tip()).count();
        let grown: f64 = (0..linkage.len()).map(|rod| self.mass(rod) + self.leaf_mass(rod)).sum();
        let weight = (grown + tips as f64 * self.params.loads.tip_mass) * self.params.loads.gravity;
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
