//! Joints side by side: how they are turned, and how they turn on.

use glam::{DQuat, DVec3};

use super::element::{LANES, Lanes, put, quaternion, vector};
use super::rotation::{self, composed, exp};

/// Joints side by side, by lanes as [`super::element::Elements`].
#[derive(Clone, Debug, Default)]
pub(super) struct Joints {
    /// Deviation of the joint.
    pub(super) deviation: [Lanes; 3],
    /// The same as a unit quaternion.
    pub(super) rotation: [Lanes; 4],
    /// Orientation of the rod before it turns.
    pub(super) orientation: [Lanes; 4],
    /// Turn of the bearer.
    pub(super) below: [Lanes; 3],
    /// By how much more the rod turns.
    pub(super) step: [Lanes; 3],
}

impl Joints {
    /// One joint's.
    #[inline(always)]
    pub(super) fn rotation(&self, lane: usize) -> DQuat {
        quaternion(&self.rotation, lane)
    }

    /// The rotations of the deviations.
    pub(super) fn rotate(&mut self) {
        let mut square = [0.0; LANES];
        rotate_small(&self.deviation, &mut self.rotation, &mut square);
        for (lane, square) in square.into_iter().enumerate() {
            // Written so that NaN goes the long way.
            if !rotation::is_small(square) {
                put(&mut self.rotation, lane, exp(vector(&self.deviation, lane)).to_array());
            }
        }
    }

    /// The deviations after the turn, and their rotations.
    pub(super) fn turn(&mut self) {
        let mut own = [[0.0; LANES]; 3];
        let mut square = [0.0; LANES];
        self.turn_small(&mut own, &mut square);
        let before = self.deviation;
        self.deviation = own;
        for (lane, square) in square.into_iter().enumerate() {
            if !rotation::is_small(square) {
                let turned = composed(vector(&before, lane), self.joint(lane));
                put(&mut self.deviation, lane, turned.to_array());
            }
        }
        self.rotate();
    }

    /// What the joint itself turns by, in the rod's frame: `exp(-below) exp(below + step)`, to third order.
    #[inline(always)]
    fn joint(&self, lane: usize) -> DVec3 {
        let (below, step) = (vector(&self.below, lane), vector(&self.step, lane));
        let once = below.cross(step);
        let joint = step - 0.5 * once + below.cross(once) * (1.0 / 6.0);
        quaternion(&self.orientation, lane).conjugate() * joint
    }

    #[inline(never)]
    fn turn_small(&self, deviation: &mut [Lanes; 3], square: &mut Lanes) {
        for (lane, square) in square.iter_mut().enumerate() {
            let first = vector(&self.deviation, lane);
            put(deviation, lane, rotation::composed_small(first, self.joint(lane)).to_array());
            *square = first.length_squared();
        }
    }
}

#[inline(never)]
fn rotate_small(deviation: &[Lanes; 3], rotation: &mut [Lanes; 4], square: &mut Lanes) {
    for (lane, square) in square.iter_mut().enumerate() {
        let deviation = vector(deviation, lane);
        put(rotation, lane, rotation::exp_small(deviation).to_array());
        *square = deviation.length_squared();
    }
}
