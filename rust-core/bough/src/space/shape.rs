//! The state of a tree of rods in space: what is at rest where, and what is bent and twisted.

use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::element::{LANES, Spring, put, vector};
use super::joints::Joints;
use super::rotation::{exp, log, normalized};
use crate::mechanics::{GROUND, Linkage};

/// The rods and their springs: those of a [`Linkage`], whose stiffness is that against bending; all joints are stiffer
/// against twisting by one ratio.
#[derive(Clone, Copy, Debug)]
pub struct Rods<'a> {
    /// The rod that bears each rod, or [`GROUND`].
    pub parent: &'a [u32],
    /// Length of each rod, m; 0 at a fork.
    pub length: &'a [f64],
    /// Spring constant of each base joint against bending, N m: `EI / s`.
    pub stiffness: &'a [f64],
    /// That against twisting over it: `GJ / EI`, which is `2 G / E` for round sections.
    pub twist_ratio: f64,
    /// Normal of the vertical plane in which rods and forces lie, if they do. What lies in a plane is kept in it: whether it
    /// would fall over sideways is told, not followed.
    pub plane: Option<DVec3>,
}

impl<'a> Rods<'a> {
    /// The rods of a linkage.
    pub fn new(linkage: &'a Linkage, twist_ratio: f64) -> Self {
        let Linkage { parent, length, stiffness, .. } = linkage;
        Rods { parent, length, stiffness, twist_ratio, plane: None }
    }

    /// How many rods there are.
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there is no rod.
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }
}

/// What the joints remember, and how far they are from it.
///
/// The orientation of a rod turns +x to its direction. It is that of its bearer (none on the ground: then the world's)
/// times the rest rotation times the deviation's: `R = R_parent Phi exp(theta)`. As in the plane, the deviation is what is
/// stored, so that small torques of stiff, finely cut rods keep their digits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Rest rotation `Phi` of each base joint.
    pub rest: Vec<DQuat>,
    /// Rotation vector `theta` of each base joint from its rest rotation, radians, in the rod's own frame: about its own
    /// direction it is twist, across it bending.
    pub deviation: Vec<[f64; 3]>,
    /// Direction of the wood at each base joint, about which it twists, in the rod's own frame: a unit vector.
    pub axis: Vec<[f64; 3]>,
}

impl Shape {
    /// Adds a rod at rest: it leaves its bearer in a direction of its own (`branching`, none inside an axis), and its wood bends
    /// from there to the rod's (`bend`). The wood at the joint points half-way: pointing along the rod it would twist about
    /// the wrong direction, an error of first order in the length of the segments.
    pub fn push(&mut self, branching: DQuat, bend: DQuat) {
        self.rest.push(branching * bend);
        self.deviation.push([0.0; 3]);
        self.axis.push((exp(log(bend) * -0.5) * DVec3::X).to_array());
    }

    /// Takes a share of each joint's deviation into its rest rotation. The joint does not move: `joint` is told its rotation.
    pub fn yield_to(&mut self, share: impl Fn(usize) -> f64, mut joint: impl FnMut(DQuat)) {
        let (mut whole, mut half) = (Joints::default(), Joints::default());
        for (first, deviations) in (0..).step_by(LANES).zip(self.deviation.chunks_mut(LANES)) {
            for (lane, deviation) in deviations.iter().enumerate() {
                put(&mut whole.deviation, lane, *deviation);
                put(&mut half.deviation, lane, deviation.map(|part| part * (0.5 * share(first + lane))));
            }
            whole.rotate();
            half.rotate();
            for (lane, deviation) in deviations.iter_mut().enumerate() {
                let (rest, axis) = (&mut self.rest[first + lane], &mut self.axis[first + lane]);
                joint(*rest * whole.rotation(lane));
                // Not even a rounding: what has no memory is the same, however often it thickens.
                if *deviation != [0.0; 3] {
                    let taken = half.rotation(lane);
                    *rest = normalized(*rest * (taken * taken));
                    *axis = (taken.conjugate() * DVec3::from_array(*axis)).to_array();
                    let left = DVec3::from_array(*deviation) - 2.0 * vector(&half.deviation, lane);
                    *deviation = left.to_array();
                }
            }
        }
    }

    /// Present rotation of a base joint.
    pub fn joint(&self, rod: usize) -> DQuat {
        self.rest[rod] * exp(DVec3::from_array(self.deviation[rod]))
    }

    /// Moment that a base joint's spring holds, N m: its size across the wood, which bends, and along it, which twists.
    pub fn moment(&self, rods: Rods, rod: usize) -> [f64; 2] {
        let deviation = DVec3::from_array(self.deviation[rod]);
        let axis = DVec3::from_array(self.axis[rod]);
        self.across(rod, Spring::new(rods.stiffness[rod], rods.twist_ratio, deviation, axis).moment)
    }

    /// The size of a vector in a rod's own frame across the wood of its joint, and along it.
    pub fn across(&self, rod: usize, vector: DVec3) -> [f64; 2] {
        let axis = DVec3::from_array(self.axis[rod]);
        let along = vector.dot(axis);
        [(vector - along * axis).length(), along]
    }

    /// Writes the orientation of every rod.
    pub fn orientations(&self, rods: Rods, orientation: &mut Vec<DQuat>) {
        self.orient(rods, &mut Joints::default(), orientation);
    }

    pub(super) fn orient(&self, rods: Rods, joints: &mut Joints, orientation: &mut Vec<DQuat>) {
        orientation.clear();
        for (first, deviations) in (0..).step_by(LANES).zip(self.deviation.chunks(LANES)) {
            for (lane, deviation) in deviations.iter().enumerate() {
                put(&mut joints.deviation, lane, *deviation);
            }
            joints.rotate();
            for lane in 0..deviations.len() {
                let joint = self.rest[first + lane] * joints.rotation(lane);
                let parent = rods.parent[first + lane];
                orientation.push(normalized(match parent {
                    GROUND => joint,
                    parent => orientation[parent as usize] * joint,
                }));
            }
        }
    }
}

/// Sums the forces at the distal ends of the rods, given here, over everything beyond each rod. O(n).
pub fn gather(parent: &[u32], force: &mut [DVec3]) {
    for rod in (0..parent.len()).rev() {
        if parent[rod] != GROUND {
            let sum = force[rod];
            force[parent[rod] as usize] += sum;
        }
    }
}
