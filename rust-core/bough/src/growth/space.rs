//! Growth with rods in space: what differs from the plane.

use alloc::vec;
use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::axis::STEM;
use super::plant::{Pose, assemble};
use super::pull::{Grip, act_in_space};
use super::state::{Growth, State};
use super::tropism::{elasticity, turn_towards};
use crate::mechanics::{GROUND, Outcome, Report, Settings, Status};
use crate::params::{Params, PointForce, is_spatial};
use crate::plant::{Plant, largest_principal_stress};
use crate::space::{
    Balance, Damping, NEUTRAL, Rods, Shape, direction, exp, from_rodrigues, hold, log, rodrigues, settle,
};

/// A vector this much out of a plane, over its length, lies in it: its parts are rounded a few times when they are turned.
const ROUNDING: f64 = 1e-12;

/// The normal of the plane of a plant that lies in one and is computed in space all the same.
pub(super) fn plane_of(params: &Params) -> Option<DVec3> {
    let mut planar = params.clone();
    planar.solver.space = false;
    let (sin, cos) = params.axis.azimuth.sin_cos();
    (!is_spatial(&planar)).then_some(DVec3::new(sin, 0.0, cos))
}

impl Growth {
    /// The rods with their springs.
    pub(super) fn rods_in_space(&self) -> Rods<'_> {
        Rods { plane: self.plane, ..Rods::new(&self.state.linkage, self.twist_ratio()) }
    }

    /// `GJ / EI` of a round section: `2 G / E`.
    pub(super) fn twist_ratio(&self) -> f64 {
        2.0 * self.params.material.shear_modulus_ratio
    }

    /// Orientation of a rod when the step began.
    pub(super) fn orientation_of(&self, rod: u32) -> DQuat {
        if rod == GROUND { DQuat::IDENTITY } else { self.orientation[rod as usize] }
    }

    /// Rest rotation of new wood of an axis against its bearer, in two parts: the branching of a first segment; then the built-in
    /// bend and twist over a length, half of it before the tropism's turn and half after.
    pub(super) fn rest_in_space(&self, axis: usize, is_first: bool, length: f64) -> [DQuat; 2] {
        let axis = &self.state.axes[axis];
        let start = if is_first { axis.branching } else { DQuat::IDENTITY };
        if axis.generation == STEM || length == 0.0 {
            return [start, DQuat::IDENTITY];
        }
        let own = &self.params.axis;
        let (sin, cos) = own.rest_curvature_roll.sin_cos();
        let built_in =
            DVec3::new(own.rest_twist, -own.rest_curvature * sin, own.rest_curvature * cos) * length;
        let half = exp(0.5 * built_in);
        if !self.turns() {
            return [start, exp(built_in)];
        }
        let tropism = &self.params.tropism;
        let sought = direction(tropism.elevation, tropism.azimuth.unwrap_or(axis.azimuth));
        let from = self.orientation_of(axis.bearer) * start * half;
        let turn = turn_towards(from * DVec3::X, sought, elasticity(tropism.strength, length));
        [start, half * exp(from.conjugate() * turn) * half]
    }

    /// Newton's method in space, for a step whose loads act.
    pub(super) fn settle_in_space(&mut self, settings: Settings) -> Outcome {
        let twist_ratio = self.twist_ratio();
        let State { linkage, shape, force, trend, report, .. } = &mut self.state;
        trend.expect(&mut self.guess);
        let workspace = &mut self.workspace_in_space;
        workspace.is_weary = report.status != Status::Converged;
        let rods = Rods { plane: self.plane, ..Rods::new(linkage, twist_ratio) };
        let outcome = settle(rods, shape, &self.force_before, force, &self.guess, settings, workspace);
        trend.note(workspace.start.as_flattened(), shape.deviation.as_flattened());
        outcome
    }

    /// As [`Growth::thicken`]: stiffness grows, the deviation shrinks, and the rest rotation takes up the difference, so that
    /// neither the moment nor the shape changes. Keeps the rotations at which the pipes are laid where every step is one.
    pub(super) fn thicken_in_space(&mut self) {
        let is_kept = self.is_exact();
        let State { linkage, shape, pipes, step, .. } = &mut self.state;
        let thickened = |rod: usize| {
            let number = pipes.number(rod, *step);
            number * number * pipes.stiffness[rod]
        };
        shape.yield_to(
            |rod| 1.0 - linkage.stiffness[rod] / thickened(rod),
            |joint| self.laid.extend(is_kept.then(|| rodrigues(joint).to_array()).iter().flatten()),
        );
        for (rod, stiffness) in linkage.stiffness.iter_mut().enumerate() {
            *stiffness = thickened(rod);
        }
    }

    /// Keeps the rest rotation of the pipes that were laid in this step in new wood.
    pub(super) fn record_pipes_in_space(&mut self) {
        let State { shape, wood, step, .. } = &self.state;
        let old = wood.partition_point(|wood| wood.birth < *step);
        let joints = shape.rest[old..].iter().map(|rest| rodrigues(*rest).to_array());
        self.laid.extend(joints.flatten());
    }

    /// As [`Growth::shown`], in space.
    fn shown_in_space(&self) -> Shape {
        let mut shape = self.state.shape.clone();
        if self.params.loads.removed {
            shape.deviation.fill([0.0; 3]);
        }
        shape
    }

    /// The plant as it stands, in space.
    pub(super) fn plant_in_space(&self) -> Plant {
        let mut shape = self.shown_in_space();
        let mut force = self.state.force.clone();
        let mut report = self.state.report;
        if self.params.loads.removed {
            force.fill(DVec3::ZERO);
            report.residual = 0.0;
        } else {
            self.endure(&mut shape, &mut force, &mut report);
        }
        self.seen_in_space(&shape, &force, report)
    }

    /// The plant in this shape under these forces, with what there is to say of its balance.
    fn seen_in_space(&self, shape: &Shape, force: &[DVec3], mut report: Report) -> Plant {
        let rods = self.rods_in_space();
        let mut balance = Balance::default();
        balance.orient(rods, shape);
        balance.weigh(rods, shape, force, Damping::default());
        if report.status == Status::Converged {
            report.residual = balance.relative_residual();
            // Of a neutral direction rounding would decide.
            balance.weigh(rods, shape, force, NEUTRAL);
            report.stable = Some(balance.unstable + balance.unstable_sideways == 0);
        }
        report.gravity_number = self.gravity_number();
        report.self_buckling = self.self_buckling();
        assemble(self, &Pose::Space { shape, orientation: &balance.orientation }, report)
    }

    /// As [`Growth::hold`], in space: all of the place counts.
    pub(super) fn hold_in_space(
        &self,
        segment: u32,
        place: [f64; 3],
        grip: Option<Grip>,
    ) -> Option<(Plant, Grip)> {
        let rod = self.rod_of(segment)?;
        let settings = self.settings();
        let (mut shape, mut start) = match grip {
            Some(Grip::Space { segment: held, shape, force })
                if held == segment && shape.rest.len() == self.rods() =>
            {
                (shape, force)
            }
            _ => (self.shown_in_space(), DVec3::ZERO),
        };
        let mut place = DVec3::from_array(place);
        // What is drawn out of its plane, by more than rounding, is free to leave it.
        let lies_in = |plane: DVec3, vector: DVec3| plane.dot(vector).abs() <= ROUNDING * vector.length();
        let plane = self.plane.filter(|plane| lies_in(*plane, place) && lies_in(*plane, start));
        if let Some(plane) = plane {
            place -= plane * plane.dot(place);
        }
        let rods = Rods { plane, ..self.rods_in_space() };
        let (mut stable, mut pull) = (false, DVec3::ZERO);
        let (outcome, force) =
            self.rest_in_weather(&mut shape, self.steady_loads::<Shape>(), &mut |shape, _, loads| {
                let held = hold(rods, shape, loads, rod, place, start, settings);
                (start, pull, stable) = (held.force, held.force, held.stable);
                let mut by = vec![DVec3::ZERO; self.rods()];
                act_in_space(&self.state.linkage, &mut by, rod, pull);
                (held.outcome, by)
            });
        if outcome.status != Status::Converged {
            return None;
        }
        let iterations = self.state.report.iterations + outcome.iterations;
        let mut plant = self.seen_in_space(&shape, &force, Report { iterations, ..self.state.report });
        // What did not come to rest while it grew is not vouched for.
        plant.report.stable = plant.report.stable.map(|_| stable);
        plant.params.loads.forces = vec![PointForce { segment, force: pull.to_array() }];
        Some((plant, Grip::Space { segment, shape, force: pull }))
    }

    /// Largest fibre stress at every rod's base joint, as [`super::plant::stress`], of bending and twisting together.
    pub(super) fn stress_in_space(&self, shape: &Shape) -> Vec<f64> {
        let wood = &self.state.wood;
        let modulus = self.params.material.youngs_modulus;
        let strain = |rod: usize, radius: f64, bent: f64| modulus * radius * bent / wood[rod].joint_length;
        let shear = self.params.material.shear_modulus_ratio;
        let bend = |rod: usize, rotation: DVec3| {
            let [bent, twisted] = shape.across(rod, rotation);
            largest_principal_stress(bent, shear * twisted)
        };
        if !self.remembers_pipes() {
            let whole = |rod: usize| {
                strain(rod, self.section(rod).radius(), bend(rod, DVec3::from_array(shape.deviation[rod])))
            };
            return (0..wood.len()).map(whole).collect();
        }
        let joint: Vec<DQuat> = (0..wood.len()).map(|rod| shape.joint(rod)).collect();
        let mut largest = vec![0.0_f64; wood.len()];
        let mut laid = &self.laid[..];
        for step in 1..=self.state.step {
            let rods = wood.partition_point(|wood| wood.birth <= step);
            let Some((rest, later)) = laid.split_at_checked(3 * rods) else { break };
            laid = later;
            for (rod, rest) in rest.chunks_exact(3).enumerate() {
                let deviation = log(from_rodrigues(DVec3::from_slice(rest)).conjugate() * joint[rod]);
                let bent = bend(rod, deviation);
                let strained = (f64::from(step) - self.state.pipes.since[rod]) * bent * bent;
                largest[rod] = if strained > largest[rod] { strained } else { largest[rod] };
            }
        }
        let of_pipes =
            |(rod, largest): (usize, f64)| strain(rod, wood[rod].birth_radius, libm::sqrt(largest));
        largest.into_iter().enumerate().map(of_pipes).collect()
    }
}
