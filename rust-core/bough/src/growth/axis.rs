//! How far one axis has come.

use glam::DQuat;

use crate::angle::Degrees;

/// In place of a generation: the axis is the flexible stem.
pub(super) const STEM: u32 = u32::MAX;

/// One axis as far as it has grown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// How many forks lie below it, or [`STEM`].
    pub(super) generation: u32,
    /// Birth radius at its base, m.
    pub(super) base_radius: f64,
    /// The segment whose distal end it is attached to, or [`GROUND`].
    pub(super) attached: u32,
    /// The rod that bears its next segment: the node of its fork, later its own last segment.
    pub(super) bearer: u32,
    /// Its branching angle, radians.
    pub(super) branching_turn: f64,
    /// In space: the direction in which it leaves its bearer, or the ground.
    pub(super) branching: DQuat,
    /// In space: the azimuth of the vertical plane in which it seeks its direction.
    pub(super) azimuth: Degrees,
    /// How many segments it has.
    pub(super) segments: u32,
    /// Whether it has ended in a fork.
    pub(super) forked: bool,
}

impl Axis {
    /// Whether it ends in a tip of its own: not in a fork, and not as a stem does, at its youngest axis.
    pub(super) fn is_tip(&self) -> bool {
        !self.forked && self.segments > 0 && self.generation != STEM
    }
}
