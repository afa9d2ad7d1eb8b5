//! What comes upon the grown plant: its fruit is picked, snow lies, wind blows, forces pull.

use alloc::vec::Vec;

use super::pull::{act, into_plane, turned};
use super::state::Growth;
use crate::mechanics::{Elimination, Linkage, Loads, Outcome, Report, Settings, Status, Workspace, settle};
use crate::params::PointForce;
use crate::trigonometry::sin_cos;

/// Share of the tolerance that forces may still be off by when the shape that they follow has come to rest; the springs'
/// balance has what is left.
const SHARE: f64 = 0.25;
/// Most times that forces are made to follow the shape. They come nearer by a constant factor, and Aitken's by a smaller one.
const MOST_ROUNDS: u32 = 200;

impl Growth {
    /// The loads of the grown plant that do not depend on how it stands: those it grew with, less the fruit if that is picked.
    pub(super) fn steady_loads(&self, linkage: &Linkage) -> Loads {
        let mut loads = self.state.loads.clone();
        let params = &self.params.loads;
        if params.picked && params.tip_mass > 0.0 {
            let up = into_plane(&self.params, [0.0, params.tip_mass * params.gravity, 0.0]);
            for axis in self.state.axes.iter().filter(|axis| axis.is_tip()) {
                act(linkage, &mut loads, axis.bearer as usize, up);
            }
        }
        loads
    }

    /// Lets everything act that comes after growth. Segments that are not there yet are not pulled at.
    pub(super) fn endure(&self, linkage: &mut Linkage, loads: &mut Loads, report: &mut Report) {
        let params = &self.params.loads;
        if params.forces.is_empty() && !params.picked && !self.has_weather() {
            return;
        }
        let mut steady = self.steady_loads(linkage);
        for PointForce { segment, force } in &params.forces {
            if let Some(rod) = self.rod_of(*segment) {
                act(linkage, &mut steady, rod, into_plane(&self.params, *force));
            }
        }
        let settings = self.settings();
        let mut workspace = Workspace::default();
        let (outcome, borne) = self.rest_in_weather(linkage, steady, &mut |linkage, before, after| {
            settle(linkage, before, after, &[], settings, &mut workspace)
        });
        *loads = borne;
        report.status = report.status.max(outcome.status);
        report.residual = outcome.residual;
        report.iterations += outcome.iterations;
    }

    /// How exactly to balance, so that there is room in the tolerance for forces that follow the shape.
    pub(super) fn settings(&self) -> Settings {
        let tolerance = self.params.solver.tolerance;
        Settings { tolerance: if self.has_weather() { (1.0 - 2.0 * SHARE) * tolerance } else { tolerance } }
    }

    /// Brings the plant, which is in equilibrium with the loads that it grew with, to rest under `steady` loads and weather, by
    /// `seek`, which takes loads to start from and to end with. Returns the loads that then act.
    ///
    /// Drag and snow depend on how the plant stands. In each search they are those of the shape before (so the Hessian, and
    /// what the report says of stability, take them as dead loads); then they follow the shape, over-relaxed as the last two
    /// rounds tell (Aitken's method for vectors; Irons & Tuck 1969), until they no longer change.
    pub(super) fn rest_in_weather(
        &self,
        linkage: &mut Linkage,
        steady: Loads,
        seek: &mut dyn FnMut(&mut Linkage, &Loads, &Loads) -> Outcome,
    ) -> (Outcome, Loads) {
        if !self.has_weather() {
            return (seek(linkage, &self.state.loads, &steady), steady);
        }
        let (mut before, mut used) = (self.state.loads.clone(), self.with_weather(&steady, linkage));
        let mut last_gap = Loads::default();
        let (mut relaxation, mut iterations) = (1.0, 0);
        let mut state = Elimination::default();
        let mut rounds = MOST_ROUNDS;
        loop {
            let mut outcome = seek(linkage, &before, &used);
            iterations += outcome.iterations;
            outcome.iterations = iterations;
            let fresh = self.with_weather(&steady, linkage);
            let mut gap = fresh.clone();
            gap.add(&used, -1.0);
            state.evaluate(linkage, &gap);
            let off = state.largest_torque();
            state.evaluate(linkage, &fresh);
            outcome.residual = state.relative_residual();
            let near = off <= SHARE * self.params.solver.tolerance * state.largest_torque();
            rounds -= 1;
            if !near && rounds == 0 {
                outcome.status = outcome.status.max(Status::MaxIterations);
            }
            if near || outcome.status != Status::Converged {
                return (outcome, fresh);
            }
            relaxation *= aitken(&gap, &last_gap);
            before.clone_from(&used);
            used.add(&gap, relaxation);
            last_gap = gap;
        }
    }

    /// Loads, and the weather's in the present shape.
    fn with_weather(&self, steady: &Loads, linkage: &Linkage) -> Loads {
        let mut angle = Vec::new();
        linkage.angles(&mut angle);
        let base = self.params.axis.elevation.radians();
        let forces = self.weather(&mut |rod| {
            let (sin, cos) = sin_cos(base + angle[rod]);
            turned(self.params.axis.azimuth, [cos, sin, 0.0])
        });
        let mut loads = Loads::none(0);
        for force in forces {
            let [x, y] = into_plane(&self.params, force);
            loads.x.push(x);
            loads.y.push(y);
        }
        loads.gather(linkage);
        loads.add(steady, 1.0);
        loads
    }
}

/// By which factor to change the relaxation of a fixed-point iteration whose last two steps were these.
fn aitken(gap: &Loads, last_gap: &Loads) -> f64 {
    let (mut along, mut square) = (0.0, 0.0);
    for (gap, last) in [(&gap.x, &last_gap.x), (&gap.y, &last_gap.y)] {
        for (gap, last) in gap.iter().zip(last) {
            along += last * (last - gap);
            square += (last - gap) * (last - gap);
        }
    }
    if square > 0.0 { along / square } else { 1.0 }
}
