//! A plant as flat arrays: what crosses to JavaScript, files and plots.

use alloc::vec::Vec;

use super::strength::weakest;
use crate::mechanics::Report;
use crate::params::Params;

/// The centre lines of all axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polylines {
    /// x, y, z of every point, m, axis after axis; shape `3 P`. The first point of an axis is where it is
    /// attached. x to the right, y up, z to the viewer.
    pub points: Vec<f64>,
    /// Radius at every point, m; shape `P`.
    pub radii: Vec<f64>,
    /// Axis a owns the points `offsets[a] .. offsets[a + 1]`; shape `A + 1`. k segments have k + 1 points.
    pub offsets: Vec<u32>,
}

/// One entry a segment, parents before children.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Segments {
    /// The bearing segment, -1 for the ground.
    pub parent: Vec<i32>,
    /// Index of the segment's distal point in [`Polylines`].
    pub point: Vec<u32>,
    /// The axis the segment belongs to.
    pub axis: Vec<u32>,
    /// Branching order of that axis: 0 for the main axis.
    pub order: Vec<u32>,
    /// Growth step in which the segment was born, from 1.
    pub birth: Vec<u32>,
    /// Length, m.
    pub length: Vec<f64>,
    /// Radius at the middle, m.
    pub radius: Vec<f64>,
    /// Mass of the wood, kg.
    pub mass: Vec<f64>,
    /// Orientation as a quaternion x, y, z, w that turns +x to the segment's direction; shape `4 n`.
    pub rotation: Vec<f64>,
    /// Bending moment at the base joint, N m: the external torque there, counter-clockwise.
    pub moment: Vec<f64>,
    /// Twisting moment at the base joint, N m; 0 in a vertical plane.
    pub twist_moment: Vec<f64>,
    /// Joint angle over the joint's length, 1/m, counter-clockwise. The moment is `EI (curvature - rest curvature)`.
    pub curvature: Vec<f64>,
    /// Rest angle over the joint's length, 1/m.
    pub rest_curvature: Vec<f64>,
    /// Largest fibre stress: the maximum over the pipes of `E r |mu - phi| / s` with each pipe's own outer
    /// radius and rest angle, Pa.
    pub stress: Vec<f64>,
}

/// A grown plant, at the end of one growth step.
#[derive(Clone, Debug, PartialEq)]
pub struct Plant {
    /// The centre lines.
    pub polylines: Polylines,
    /// The segments.
    pub segments: Segments,
    /// The complete params that made it.
    pub params: Params,
    /// What the solver says of it.
    pub report: Report,
}

impl Plant {
    /// Says in the report where the plant breaks first, and how far that is off.
    pub(crate) fn judge_strength(&mut self) {
        let weakest = weakest(&self.segments.stress, self.params.material.modulus_of_rupture);
        (self.report.breaks_first, self.report.safety_factor) = weakest.unzip();
    }

    /// The tip of axis `axis`: x, y, z in m.
    pub fn tip(&self, axis: usize) -> [f64; 3] {
        let end = self.polylines.offsets[axis + 1] as usize;
        let [.., x, y, z] = self.polylines.points[..3 * end] else { return [0.0; 3] };
        [x, y, z]
    }

    /// A 64-bit fingerprint (FNV-1a) of every array, to the last bit. Equal on every platform.
    pub fn fingerprint(&self) -> u64 {
        let Segments { parent, point, axis, order, birth, .. } = &self.segments;
        let Segments { length, radius, mass, rotation, moment, twist_moment, .. } = &self.segments;
        let Segments { curvature, rest_curvature, stress, .. } = &self.segments;
        let reals = [&self.polylines.points, &self.polylines.radii, length, radius, mass, rotation, moment];
        let more_reals = [twist_moment, curvature, rest_curvature, stress];
        let counts = [&self.polylines.offsets, point, axis, order, birth];
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let mut feed = |bytes: &[u8]| {
            for &byte in bytes {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        };
        for array in reals.into_iter().chain(more_reals) {
            array.iter().for_each(|number| feed(&number.to_le_bytes()));
        }
        for array in counts {
            array.iter().for_each(|number| feed(&number.to_le_bytes()));
        }
        parent.iter().for_each(|number| feed(&number.to_le_bytes()));
        hash
    }
}
