//! The state of a tree of rods: what is stiff, what is bent, and where every rod points.

use alloc::vec::Vec;

use super::levels::Levels;

/// Parent of a rod that stands on the ground.
pub const GROUND: u32 = u32::MAX;

/// A tree of rigid rods, each joined to the one that bears it by a rotational spring. Parents come before
/// children (the paper numbers from the tip; this is the other way round, as a tree needs).
///
/// Angles are in radians, counter-clockwise, in the frame of the base direction: a straight, unloaded axis
/// has all angles 0, whatever its elevation, so that no digits are spent on the elevation.
///
/// The stored state is each joint's deviation, never the absolute angle: absolute angles cannot resolve the
/// small deviations of stiff, finely cut rods.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Linkage {
    /// The rod that bears each rod, or [`GROUND`].
    pub parent: Vec<u32>,
    /// Length of each rod, m. A fork is a rod of length 0.
    pub length: Vec<f64>,
    /// Spring constant `kappa` of each rod's base joint, N m (equations 30 and 39).
    pub stiffness: Vec<f64>,
    /// Rest angle `phi` of each base joint against the bearing rod (equation 40).
    pub rest: Vec<f64>,
    /// Deviation `theta = mu - phi` of each base joint from its rest angle (equation 33).
    pub deviation: Vec<f64>,
    /// Whether what stands in unstable balance falls counter-clockwise where its loads turn it to neither side.
    pub falls_left: bool,
    /// How many of the first rods stand each on the one before.
    unbranched: usize,
    pub(super) levels: Levels,
}

impl Linkage {
    /// How many rods there are.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there is no rod.
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// Takes all rods away; their room is kept.
    pub(super) fn clear(&mut self) {
        self.parent.clear();
        for array in [&mut self.length, &mut self.stiffness, &mut self.rest, &mut self.deviation] {
            array.clear();
        }
        self.unbranched = 0;
        self.levels.clear();
    }

    /// Adds a rod at rest. `parent` is an earlier rod or [`GROUND`].
    pub fn push(&mut self, parent: u32, length: f64, stiffness: f64, rest: f64) {
        debug_assert!(parent == GROUND || (parent as usize) < self.len());
        let on_the_last = if self.is_empty() { parent == GROUND } else { parent as usize + 1 == self.len() };
        self.unbranched += usize::from(on_the_last && self.is_chain());
        self.levels.push(self.len(), parent);
        self.parent.push(parent);
        self.length.push(length);
        self.stiffness.push(stiffness);
        self.rest.push(rest);
        self.deviation.push(0.0);
    }

    /// Whether every rod stands on the one before.
    pub fn is_chain(&self) -> bool {
        self.unbranched == self.len()
    }

    /// Whether the rods are numbered level by level, and the levels are wide.
    pub(super) fn has_wide_levels(&self) -> bool {
        self.levels.are_wide(self.len())
    }

    /// Current angle `mu` of a base joint.
    pub fn joint_angle(&self, rod: usize) -> f64 {
        self.rest[rod] + self.deviation[rod]
    }

    /// Writes the angle `psi` of every rod into `angle`, in the frame of the base direction.
    pub fn angles(&self, angle: &mut Vec<f64>) {
        angle.resize(self.len(), 0.0);
        if self.is_chain() {
            let mut sum = 0.0;
            let joints = self.rest.iter().zip(&self.deviation);
            for (angle, (rest, deviation)) in angle.iter_mut().zip(joints) {
                sum += rest + deviation;
                *angle = sum;
            }
            return;
        }
        if self.has_wide_levels() {
            let joints = self.rest.iter().zip(&self.deviation);
            for (angle, (rest, deviation)) in angle.iter_mut().zip(joints) {
                *angle = rest + deviation;
            }
            self.levels.spread(&self.parent, angle);
            return;
        }
        let mut last = 0.0;
        let joints = self.rest.iter().zip(&self.deviation);
        for (rod, (parent, (rest, deviation))) in self.parent.iter().zip(joints).enumerate() {
            // Along an axis the angle below is the last one, and stays in a register.
            let below = match *parent {
                GROUND => 0.0,
                parent if parent as usize + 1 == rod => last,
                parent => angle[parent as usize],
            };
            last = below + (rest + deviation);
            angle[rod] = last;
        }
    }
}
