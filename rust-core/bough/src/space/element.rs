//! A rod alone with its base joint and its load: what it adds to torques, energy and Hessian. Several stand side by side, because
//! they do not wait for each other: compilers make vector code of the loops over lanes, for wasm and natively alike.
//!
//! The spring's energy is `1/2 kappa (|theta|^2 + (gamma - 1) sigma^2)`, `sigma` the deviation's component along the wood
//! of the joint, `gamma = GJ / EI`. All of its moment and Hessian is written with vectors in the world's frame, so that no matrix is
//! turned.

use glam::{DMat3, DQuat, DVec3};

use super::balance::Damping;
use super::rotation::{Curving, is_small};
use super::shape::{Rods, Shape};

/// How many elements stand side by side.
pub(super) const LANES: usize = 8;
pub(super) type Lanes = [f64; LANES];
/// A symmetric 3 x 3 matrix: xx, yy, zz, xy, xz, yz.
pub(super) type Symmetric = [f64; 6];

/// What the spring of one joint does.
pub(super) struct Spring {
    pub(super) moment: DVec3,
    pub(super) hessian: Symmetric,
    pub(super) energy: f64,
}

impl Spring {
    /// `along` is the direction of the wood at the joint, in the same frame as the deviation.
    pub(super) fn new(stiffness: f64, twist_ratio: f64, deviation: DVec3, along: DVec3) -> Self {
        let curving = Curving::at(deviation.length_squared());
        Self::curved(stiffness, twist_ratio, deviation, along, curving)
    }

    #[inline(always)]
    fn curved(stiffness: f64, twist_ratio: f64, deviation: DVec3, along: DVec3, curving: Curving) -> Self {
        let square = deviation.length_squared();
        let Curving { first: c, second: d } = curving;
        let twist = deviation.dot(along);
        let more = twist_ratio - 1.0;
        let across = along.cross(deviation);
        let straight = 1.0 - c * square;
        let axis = along * straight + across * 0.5 + deviation * (c * twist);
        let moment = (deviation + axis * (more * twist)) * stiffness;
        let pull = more * twist;
        let identity = straight + pull * twist * (c - 0.25 - c * c * square);
        let both = c + pull * twist * (2.0 * c * c + d);
        let mixed = 0.5 * pull * (0.25 - c - square * (c * c + d));
        let skewed = 0.5 * pull * c;
        // With `s = mixed along + skewed across` the last two terms are `theta s + s theta`.
        let side = along * mixed + across * skewed;
        let (both, more_axis) = (deviation * both, axis * more);
        let hessian = [
            identity + both.x * deviation.x + more_axis.x * axis.x + 2.0 * deviation.x * side.x,
            identity + both.y * deviation.y + more_axis.y * axis.y + 2.0 * deviation.y * side.y,
            identity + both.z * deviation.z + more_axis.z * axis.z + 2.0 * deviation.z * side.z,
            both.x * deviation.y + more_axis.x * axis.y + deviation.x * side.y + side.x * deviation.y,
            both.x * deviation.z + more_axis.x * axis.z + deviation.x * side.z + side.x * deviation.z,
            both.y * deviation.z + more_axis.y * axis.z + deviation.y * side.z + side.y * deviation.z,
        ];
        let energy = 0.5 * stiffness * (square + more * twist * twist);
        Spring { moment, hessian: hessian.map(|entry| stiffness * entry), energy }
    }
}

/// Elements side by side.
#[derive(Clone, Debug, Default)]
pub(super) struct Elements {
    orientation: [Lanes; 4],
    deviation: [Lanes; 3],
    wood: [Lanes; 3],
    length: Lanes,
    stiffness: Lanes,
    force: [Lanes; 3],
    curving: [Lanes; 2],
    /// Moment of the spring.
    pub(super) moment: [Lanes; 3],
    /// Torque of the load.
    pub(super) torque: [Lanes; 3],
    /// Hessian of the spring.
    pub(super) spring: [Lanes; 6],
    /// Hessian of the load, damped.
    pub(super) load: [Lanes; 6],
    /// Energy of the spring, J.
    pub(super) stored: Lanes,
    /// Energy of the load, J.
    pub(super) lifted: Lanes,
    /// Bound of the load's torque: its size times its arm, N m.
    pub(super) reach: Lanes,
}

/// The vector in one lane.
#[inline(always)]
pub(super) fn vector(lanes: &[Lanes; 3], lane: usize) -> DVec3 {
    DVec3::new(lanes[0][lane], lanes[1][lane], lanes[2][lane])
}

/// The quaternion in one lane.
#[inline(always)]
pub(super) fn quaternion(lanes: &[Lanes; 4], lane: usize) -> DQuat {
    DQuat::from_xyzw(lanes[0][lane], lanes[1][lane], lanes[2][lane], lanes[3][lane])
}

#[inline(always)]
pub(super) fn put<const N: usize>(lanes: &mut [Lanes; N], lane: usize, numbers: [f64; N]) {
    for (lanes, number) in lanes.iter_mut().zip(numbers) {
        lanes[lane] = number;
    }
}

impl Elements {
    /// The elements of up to [`LANES`] rods from this one on, in this state.
    pub(super) fn compute(
        &mut self,
        rods: Rods,
        shape: &Shape,
        orientation: &[DQuat],
        force: &[DVec3],
        first: usize,
        damping: Damping,
    ) {
        let here = first..orientation.len().min(first + LANES);
        let count = here.len();
        let (orientation, force) = (&orientation[here.clone()], &force[here.clone()]);
        let (deviation, wood) = (&shape.deviation[here.clone()], &shape.axis[here.clone()]);
        for lane in 0..count {
            put(&mut self.orientation, lane, orientation[lane].to_array());
            put(&mut self.deviation, lane, deviation[lane]);
            put(&mut self.wood, lane, wood[lane]);
            put(&mut self.force, lane, force[lane].to_array());
        }
        self.length[..count].copy_from_slice(&rods.length[here.clone()]);
        self.stiffness[..count].copy_from_slice(&rods.stiffness[here]);
        self.curve();
        self.compute_all(rods.twist_ratio, damping);
    }

    fn curve(&mut self) {
        let mut square = [0.0; LANES];
        for (lane, square) in square.iter_mut().enumerate() {
            *square = vector(&self.deviation, lane).length_squared();
            let Curving { first, second } = Curving::small(*square);
            put(&mut self.curving, lane, [first, second]);
        }
        for (lane, square) in square.into_iter().enumerate() {
            if !is_small(square) {
                let Curving { first, second } = Curving::at(square);
                put(&mut self.curving, lane, [first, second]);
            }
        }
    }

    #[inline(never)]
    fn compute_all(&mut self, twist_ratio: f64, Damping { shift, caution }: Damping) {
        for lane in 0..LANES {
            let turned = DMat3::from_quat(quaternion(&self.orientation, lane));
            let bent = turned * vector(&self.deviation, lane);
            let wood = turned * vector(&self.wood, lane);
            let curving = Curving { first: self.curving[0][lane], second: self.curving[1][lane] };
            let Spring { moment, hessian, energy } =
                Spring::curved(self.stiffness[lane], twist_ratio, bent, wood, curving);
            let (arm, pull) = (self.length[lane] * turned.x_axis, vector(&self.force, lane));
            let own = arm.dot(pull);
            // The sum of the sizes of a vector's components bounds its length, and needs no root.
            let reach = self.length[lane] * pull.abs().element_sum();
            let shifted = own + 0.5 * caution * (reach - own) + shift * (reach + moment.abs().element_sum());
            put(&mut self.moment, lane, moment.to_array());
            put(&mut self.torque, lane, arm.cross(pull).to_array());
            put(&mut self.spring, lane, hessian);
            let load = [
                shifted - arm.x * pull.x,
                shifted - arm.y * pull.y,
                shifted - arm.z * pull.z,
                -0.5 * (arm.x * pull.y + arm.y * pull.x),
                -0.5 * (arm.x * pull.z + arm.z * pull.x),
                -0.5 * (arm.y * pull.z + arm.z * pull.y),
            ];
            put(&mut self.load, lane, load);
            self.stored[lane] = energy;
            self.lifted[lane] = -own;
            self.reach[lane] = reach;
        }
    }
}
