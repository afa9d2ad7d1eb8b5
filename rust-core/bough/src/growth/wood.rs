//! What is known of one rod beside its mechanics.

/// The wood of one rod, and of the joint at its base.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wood {
    /// Radius of the first pipe, m. The node of a fork has the pipes of the parent's last segment.
    pub(super) birth_radius: f64,
    pub(super) axis: u32,
    /// Growth step of birth, from 1.
    pub(super) birth: u32,
    /// Length that the base joint's spring stands for, m.
    pub(super) joint_length: f64,
    /// The part of the rest angle that is the branching angle, radians; 0 inside an axis.
    pub(super) branching_turn: f64,
}
