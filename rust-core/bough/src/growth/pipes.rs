//! The pipes of every rod, and how wood thickens by them.

use alloc::vec::Vec;

use super::state::{Growth, State};
use crate::mechanics::Linkage;
use crate::params::Thickening;
use crate::plant::Section;

/// What the first pipe of each rod is like. All pipes of a rod are equal in area.
#[derive(Clone, Debug, Default)]
pub(super) struct Pipes {
    /// Growth step before the first pipe was laid: that before birth, or for the node of a fork before the birth of the
    /// segment it ends. A whole number.
    pub(super) since: Vec<f64>,
    /// Spring constant of the base joint's first pipe, N m (equation 41).
    pub(super) stiffness: Vec<f64>,
    /// Mass of the first pipe, kg; 0 for the node of a fork.
    pub(super) mass: Vec<f64>,
}

/// One rod's.
#[derive(Clone, Copy, Debug)]
pub(super) struct FirstPipe {
    pub(super) since: f64,
    pub(super) stiffness: f64,
    pub(super) mass: f64,
}

impl Pipes {
    pub(super) fn push(&mut self, FirstPipe { since, stiffness, mass }: FirstPipe) {
        self.since.push(since);
        self.stiffness.push(stiffness);
        self.mass.push(mass);
    }

    /// Gives every joint the stiffness of its pipes at a step. Slices that a function is given cannot overlap, so compilers
    /// make vector code of this loop; inlined they would lose that knowledge.
    #[inline(never)]
    fn lay(&self, step: f64, stiffness: &mut [f64], rest: &mut [f64], deviation: &mut [f64]) {
        let rods = stiffness.len();
        // Slices of one length: their bounds are checked once.
        let (since, first) = (&self.since[..rods], &self.stiffness[..rods]);
        let (rest, deviation) = (&mut rest[..rods], &mut deviation[..rods]);
        for rod in 0..rods {
            let pipes = step - since[rod];
            let thickened = pipes * pipes * first[rod];
            let shrunk = deviation[rod] * (stiffness[rod] / thickened);
            rest[rod] += deviation[rod] - shrunk;
            deviation[rod] = shrunk;
            stiffness[rod] = thickened;
        }
    }

    /// How many pipes a rod has when each step adds one.
    pub(super) fn number(&self, rod: usize, step: u32) -> f64 {
        f64::from(step) - self.since[rod]
    }
}

impl Growth {
    /// How many pipes a rod has.
    pub(super) fn pipes(&self, rod: usize) -> u32 {
        match self.params.growth.thickening {
            Thickening::None => 1,
            Thickening::Pipes => self.state.pipes.number(rod, self.state.step) as u32,
        }
    }

    /// The cross-section of a segment.
    pub(super) fn section(&self, rod: usize) -> Section {
        Section { birth_radius: self.state.wood[rod].birth_radius, pipes: self.pipes(rod) }
    }

    /// Gives every rod the stiffness of its present pipes, the new ones unstressed in the present shape (equations 36
    /// to 40): the torque stays what it was, so the deviation shrinks as the stiffness grows, and the rest angle takes
    /// up the difference.
    pub(super) fn thicken(&mut self) {
        if self.params.growth.thickening == Thickening::None {
            return;
        }
        if self.is_spatial {
            return self.thicken_in_space();
        }
        let State { linkage, pipes, step, .. } = &mut self.state;
        let Linkage { stiffness, rest, deviation, .. } = linkage;
        pipes.lay(f64::from(*step), stiffness, rest, deviation);
    }

    /// Keeps the rest angle of the pipes that were laid in this step.
    pub(super) fn record_pipes(&mut self) {
        if self.is_spatial {
            return self.record_pipes_in_space();
        }
        let Linkage { rest, deviation, .. } = &self.state.linkage;
        self.laid.extend(rest.iter().zip(deviation).map(|(rest, deviation)| rest + deviation));
    }
}

#[cfg(test)]
mod tests {
    use super::super::state::Underway;
    use super::*;
    use crate::angle::Degrees;
    use crate::mechanics::Loads;
    use crate::params::{Params, Stepping};

    impl Growth {
        /// Lets the weights of the present wood act, outside any step.
        fn load(&mut self) {
            self.weigh();
            self.underway = Some(Underway::Newton);
            self.settle(&mut u64::MAX.clone());
        }
    }

    /// A horizontal axis that bends little: slopes below 1e-4, so that the sag is linear to 1e-8.
    fn stiff_axis(segments: u32) -> Growth {
        let mut params = Params::default();
        params.axis.elevation = Degrees(0.0);
        params.axis.segments = segments;
        params.axis.segment_length = 1.0 / f64::from(segments);
        params.material.youngs_modulus = 1e13;
        Growth::new(&params).unwrap()
    }

    /// An axis of fixed length whose wood thickens from `first` to `last` pipes, each laid before its weight
    /// acts. Returns the sag over the one that the first pipes alone have.
    fn thickened_sag(first: u32, last: u32) -> f64 {
        let mut growth = stiff_axis(20);
        growth.params.solver.stepping = Stepping::Static;
        growth.work(20, &mut u64::MAX.clone());
        growth.params.solver.stepping = Stepping::Exact;
        growth.params.growth.thickening = Thickening::Pipes;
        growth.state.linkage.deviation.fill(0.0);
        growth.state.loads = Loads::none(0);
        // As many pipes everywhere, all from the beginning.
        let lay = |growth: &mut Growth, pipes: u32| {
            growth.state.step = pipes;
            growth.state.pipes.since.fill(0.0);
            growth.thicken();
        };
        lay(&mut growth, first);
        growth.load();
        let sag = |growth: &Growth| -growth.plant().tip(0)[1];
        let before = sag(&growth);
        for pipes in first + 1..=last {
            lay(&mut growth, pipes);
            growth.load();
        }
        sag(&growth) / before
    }

    #[test]
    fn thickening_at_fixed_length_sags_by_the_incremental_law() {
        // From one pipe on: the sum of 1 / k^2.
        for pipes in [1_u32, 2, 10, 200] {
            let expected: f64 = (1..=pipes).map(|pipe| 1.0 / f64::from(pipe * pipe)).sum();
            assert!((thickened_sag(1, pipes) / expected - 1.0).abs() < 1e-6, "{pipes} pipes");
        }
        // Many thin pipes: 2 - (R0 / R)^2, with the areas in the ratio 1 to 4. The sum over pipes differs from the
        // integral by half its end terms, 15 / 32 / first.
        let off = [100, 200, 400].map(|first| (thickened_sag(first, 4 * first) - (2.0 - 0.25)).abs());
        assert!(off[2] < 0.48 / 400.0 && off[0] / off[1] > 1.9 && off[1] / off[2] > 1.9, "{off:?}");
    }

    /// A joint under constant torque: each pipe is laid unstressed, so the joint does not move, and the rest angle
    /// of the bundle is `mu - T / (n^2 kappa_1)`.
    #[test]
    fn under_constant_torque_the_rest_angle_creeps_after_the_joint() {
        let mut growth = stiff_axis(1);
        growth.params.loads.gravity = 0.0;
        growth.params.loads.tip_force = [0.0, -50.0, 0.0];
        growth.params.material.youngs_modulus = 1e9;
        growth.step();
        growth.params.growth.thickening = Thickening::Pipes;
        let angle = growth.state.linkage.joint_angle(0);
        let torque = growth.state.linkage.stiffness[0] * growth.state.linkage.deviation[0];
        let first_stiffness = growth.state.pipes.stiffness[0];
        for pipes in 2..=50_u32 {
            growth.state.step = pipes;
            growth.thicken();
            growth.load();
            let linkage = &growth.state.linkage;
            let stiffness = f64::from(pipes * pipes) * first_stiffness;
            assert!((linkage.stiffness[0] / stiffness - 1.0).abs() < 1e-12);
            assert!((linkage.joint_angle(0) - angle).abs() < 1e-12);
            assert!((linkage.rest[0] - (angle - torque / stiffness)).abs() < 1e-12);
        }
    }
}
