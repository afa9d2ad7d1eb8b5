//! How far one axis has come.

/// One axis as far as it has grown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// How many forks lie below it.
    pub(super) generation: u32,
    /// Birth radius at its base, m.
    pub(super) base_radius: f64,
    /// The segment whose distal end it is attached to, or [`GROUND`].
    pub(super) attached: u32,
    /// The rod that bears its next segment: the node of its fork, later its own last segment.
    pub(super) bearer: u32,
    /// Its branching angle, radians.
    pub(super) branching_turn: f64,
    /// How many segments it has.
    pub(super) segments: u32,
    /// Whether it has ended in a fork.
    pub(super) forked: bool,
}
