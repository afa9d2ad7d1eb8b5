//! What comes upon the grown plant: its fruit is picked, snow lies, wind blows, forces pull.

use alloc::vec;
use alloc::vec::Vec;

use glam::DVec3;

use super::pull::{act, act_in_space, into_plane};
use super::state::Growth;
use super::weather::wind;
use crate::mechanics::{Elimination, Linkage, Loads, Outcome, Report, Settings, Status, Workspace, settle};
use crate::params::PointForce;
use crate::space::{self, Balance, Shape, gather};
use crate::trigonometry::sin_cos;

/// Share of the tolerance that forces may still be off by when the shape that they follow has come to rest,
const SHARE: f64 = 0.25;
/// and share of it for the springs' balance: both together leave room for rounding.
const SPRINGS_SHARE: f64 = 0.5;
/// Most times that forces are made to follow the shape. They come nearer by a constant factor, and Aitken's by a smaller one.
const MOST_ROUNDS: u32 = 200;
/// Most iterations in all of these rounds: where each of them has to search long for its balance, none will be the last. Of all
/// presets in storms and under snow, those that come to rest take at most 261.
const MOST_ITERATIONS: u64 = 1000;

/// A shape that loads act on: in its plane or in space. Loads are sums over everything beyond each rod.
pub(super) trait Stance: Sized {
    type Loads: Clone + Default;
    type Workspace: Default;
    /// The loads that the plant grew with.
    fn grown_with(growth: &Growth) -> &Self::Loads;
    /// Those of the plane or those in space, whichever are its own.
    fn of(loads: Loads, force: Vec<DVec3>) -> Self::Loads;
    /// No loads.
    fn none(growth: &Growth) -> Self::Loads;
    /// Adds a force at the distal end of a rod, x, y, z in N.
    fn act(growth: &Growth, loads: &mut Self::Loads, rod: usize, force: [f64; 3]);
    /// Brings it to rest, from the loads that it was at rest with, to others.
    fn settle(
        &mut self,
        growth: &Growth,
        before: &Self::Loads,
        after: &Self::Loads,
        workspace: &mut Self::Workspace,
    ) -> Outcome;
    /// Those loads and the weather's in the present shape.
    fn with_weather(&self, growth: &Growth, steady: &Self::Loads) -> Self::Loads;
    /// The largest torque of loads about any joint, N m, and the residual that the springs leave of them.
    fn torques(&self, growth: &Growth, loads: &Self::Loads) -> (f64, f64);
    /// Adds other loads, so many times.
    fn add(loads: &mut Self::Loads, other: &Self::Loads, times: f64);
    /// Sum of the products of all components.
    fn dot(loads: &Self::Loads, other: &Self::Loads) -> f64;
}

/// Brings a shape to rest, from the loads that it was at rest with, to others; beside the outcome it gives the loads by which it
/// holds the shape (none by default).
pub(super) type Search<'a, S> =
    dyn FnMut(&mut S, &<S as Stance>::Loads, &<S as Stance>::Loads) -> (Outcome, <S as Stance>::Loads) + 'a;

impl Growth {
    /// The loads of the grown plant that do not depend on how it stands: those it grew with, less the fruit if that is picked;
    /// none if all are taken off.
    pub(super) fn steady_loads<S: Stance>(&self) -> S::Loads {
        let given = &self.params.loads;
        if given.removed {
            return S::none(self);
        }
        if given.picked && given.tip_mass > 0.0 {
            // Put together anew: to take the fruit from the sums would leave their rounding, and heavy fruit has much.
            let (mut loads, mut force) = (Loads::none(0), Vec::new());
            self.load_with(0.0, &mut loads, &mut force);
            return S::of(loads, force);
        }
        S::grown_with(self).clone()
    }

    /// Whether anything acts on the grown plant that did not act on the growing one.
    pub(super) fn has_aftermath(&self) -> bool {
        let loads = &self.params.loads;
        !loads.forces.is_empty() || loads.picked || self.has_weather()
    }

    /// Lets everything act that comes after growth. Segments that are not there yet are not pulled at.
    pub(super) fn endure<S: Stance>(&self, shape: &mut S, loads: &mut S::Loads, report: &mut Report) {
        if !self.has_aftermath() {
            return;
        }
        let mut steady = self.steady_loads::<S>();
        for PointForce { segment, force } in &self.params.loads.forces {
            if let Some(rod) = self.rod_of(*segment) {
                S::act(self, &mut steady, rod, *force);
            }
        }
        let mut workspace = S::Workspace::default();
        let (outcome, borne) = self.rest_in_weather(shape, steady, &mut |shape, before, after| {
            (shape.settle(self, before, after, &mut workspace), S::Loads::default())
        });
        *loads = borne;
        report.status = report.status.max(outcome.status);
        report.residual = outcome.residual;
        report.iterations += outcome.iterations;
    }

    /// How exactly to balance, so that there is room in the tolerance for forces that follow the shape.
    pub(super) fn settings(&self) -> Settings {
        let tolerance = self.params.solver.tolerance;
        Settings { tolerance: if self.has_weather() { SPRINGS_SHARE * tolerance } else { tolerance } }
    }

    /// Brings the plant, which is in equilibrium with the loads that it grew with, to rest under `steady` loads and weather, by
    /// `seek`, which takes loads to start from and to end with. Returns the loads that then act, those that hold it among them.
    ///
    /// Drag and snow depend on how the plant stands. In each search they are those of the shape before (so the Hessian, and
    /// what the report says of stability, take them as dead loads); then they follow the shape, over-relaxed as the last two
    /// rounds tell (Aitken's method for vectors; Irons & Tuck 1969), until they no longer change.
    pub(super) fn rest_in_weather<S: Stance>(
        &self,
        shape: &mut S,
        steady: S::Loads,
        seek: &mut Search<S>,
    ) -> (Outcome, S::Loads) {
        if !self.has_weather() {
            let (outcome, hold) = seek(shape, S::grown_with(self), &steady);
            let mut borne = steady;
            S::add(&mut borne, &hold, 1.0);
            return (outcome, borne);
        }
        let (mut before, mut used) = (S::grown_with(self).clone(), shape.with_weather(self, &steady));
        let mut last_gap = S::Loads::default();
        let (mut relaxation, mut iterations) = (1.0, 0);
        let mut rounds = MOST_ROUNDS;
        loop {
            let (mut outcome, hold) = seek(shape, &before, &used);
            iterations += outcome.iterations;
            outcome.iterations = iterations;
            let fresh = shape.with_weather(self, &steady);
            let mut gap = fresh.clone();
            S::add(&mut gap, &used, -1.0);
            let (off, _) = shape.torques(self, &gap);
            // What holds a floppy plant may leave very little of the torques of its loads.
            let mut borne = fresh;
            S::add(&mut borne, &hold, 1.0);
            let (largest, residual) = shape.torques(self, &borne);
            outcome.residual = residual;
            let near = off <= SHARE * self.params.solver.tolerance * largest;
            rounds -= 1;
            if !near && (rounds == 0 || iterations >= MOST_ITERATIONS) {
                outcome.status = outcome.status.max(Status::MaxIterations);
            }
            if near || outcome.status != Status::Converged {
                return (outcome, borne);
            }
            relaxation *= aitken::<S>(&gap, &last_gap);
            before.clone_from(&used);
            S::add(&mut used, &gap, relaxation);
            last_gap = gap;
        }
    }
}

/// By which factor to change the relaxation of a fixed-point iteration whose last two steps were these.
fn aitken<S: Stance>(gap: &S::Loads, last_gap: &S::Loads) -> f64 {
    let (last, both, now) = (S::dot(last_gap, last_gap), S::dot(last_gap, gap), S::dot(gap, gap));
    let square = last - 2.0 * both + now;
    if square > 0.0 && last > 0.0 { (last - both) / square } else { 1.0 }
}

impl Stance for Linkage {
    type Loads = Loads;
    type Workspace = Workspace;

    fn grown_with(growth: &Growth) -> &Loads {
        &growth.state.loads
    }

    fn of(loads: Loads, _: Vec<DVec3>) -> Loads {
        loads
    }

    fn none(growth: &Growth) -> Loads {
        Loads::none(growth.rods())
    }

    fn act(growth: &Growth, loads: &mut Loads, rod: usize, force: [f64; 3]) {
        act(&growth.state.linkage, loads, rod, into_plane(&growth.params, force));
    }

    fn settle(
        &mut self,
        growth: &Growth,
        before: &Loads,
        after: &Loads,
        workspace: &mut Workspace,
    ) -> Outcome {
        settle(self, before, after, &[], growth.settings(), workspace)
    }

    fn with_weather(&self, growth: &Growth, steady: &Loads) -> Loads {
        let mut angle = Vec::new();
        self.angles(&mut angle);
        // In the frame of the base direction, where mirrored plants have mirrored numbers to the last bit.
        let in_plane = |vector| {
            let [x, y] = into_plane(&growth.params, vector);
            [x, y, 0.0]
        };
        let (wind, up) = (in_plane(wind(&growth.params)), in_plane([0.0, 1.0, 0.0]));
        let mut loads = Loads::none(0);
        for [x, y, _] in growth.weather(wind, up, &mut |rod| {
            let (sin, cos) = sin_cos(angle[rod]);
            [cos, sin, 0.0]
        }) {
            loads.x.push(x);
            loads.y.push(y);
        }
        loads.gather(self);
        loads.add(steady, 1.0);
        loads
    }

    fn torques(&self, _: &Growth, loads: &Loads) -> (f64, f64) {
        let mut state = Elimination::default();
        state.evaluate(self, loads);
        (state.largest_torque(), state.relative_residual())
    }

    fn add(loads: &mut Loads, other: &Loads, times: f64) {
        loads.add(other, times);
    }

    fn dot(loads: &Loads, other: &Loads) -> f64 {
        let product = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        product(&loads.x, &other.x) + product(&loads.y, &other.y)
    }
}

impl Stance for Shape {
    type Loads = Vec<DVec3>;
    type Workspace = space::Workspace;

    fn grown_with(growth: &Growth) -> &Vec<DVec3> {
        &growth.state.force
    }

    fn of(_: Loads, force: Vec<DVec3>) -> Vec<DVec3> {
        force
    }

    fn none(growth: &Growth) -> Vec<DVec3> {
        vec![DVec3::ZERO; growth.rods()]
    }

    fn act(growth: &Growth, loads: &mut Vec<DVec3>, rod: usize, force: [f64; 3]) {
        act_in_space(&growth.state.linkage, loads, rod, DVec3::from_array(force));
    }

    fn settle(
        &mut self,
        growth: &Growth,
        before: &Vec<DVec3>,
        after: &Vec<DVec3>,
        workspace: &mut space::Workspace,
    ) -> Outcome {
        space::settle(growth.rods_in_space(), self, before, after, &[], growth.settings(), workspace)
    }

    fn with_weather(&self, growth: &Growth, steady: &Vec<DVec3>) -> Vec<DVec3> {
        let mut balance = Balance::default();
        balance.orient(growth.rods_in_space(), self);
        let (wind, up) = (wind(&growth.params), [0.0, 1.0, 0.0]);
        let forces = growth.weather(wind, up, &mut |rod| (balance.orientation[rod] * DVec3::X).to_array());
        let mut loads: Vec<DVec3> = forces.into_iter().map(DVec3::from_array).collect();
        gather(&growth.state.linkage.parent, &mut loads);
        Self::add(&mut loads, steady, 1.0);
        loads
    }

    fn torques(&self, growth: &Growth, loads: &Vec<DVec3>) -> (f64, f64) {
        let rods = growth.rods_in_space();
        let mut balance = Balance::default();
        balance.orient(rods, self);
        balance.look(rods, self, loads);
        (balance.largest_torque, balance.relative_residual())
    }

    fn add(loads: &mut Vec<DVec3>, other: &Vec<DVec3>, times: f64) {
        loads.iter_mut().zip(other).for_each(|(to, &from)| *to += times * from);
    }

    fn dot(loads: &Vec<DVec3>, other: &Vec<DVec3>) -> f64 {
        loads.iter().zip(other).map(|(a, b)| a.dot(*b)).sum()
    }
}
