//! Torques, energy and Hessian of rods in space, and the Hessian's elimination from the leaves to the root.
//!
//! Unknown is each rod's absolute turn `omega`, a rotation vector in the world's frame: `R -> exp(omega) R`. Of a joint
//! between a bearer `p` and a rod, with `rho = omega - omega_p`, the energy is to second order
//! `M rho - 1/2 M (omega_p x rho) + 1/2 rho A rho`: `M` is the moment, `A` the spring's Hessian, and the middle term the
//! commutator of the two rotations, without which floppy trees do not converge. A load `F` beyond the rod's end adds
//! `-T omega + 1/2 omega G omega` with `T = l d x F` and `G = l ((F d) 1 - sym(F d))`.
//!
//! As in the plane a rod couples with its bearer only, so 3 x 3 blocks eliminated from the tips down make no fill-in, and
//! the signs of their leading minors count the Hessian's negative eigenvalues (Sylvester).

use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::element::{Elements, LANES, Symmetric, put, vector};
use super::joints::Joints;
use super::rotation::normalized;
use super::shape::{Rods, Shape};
use crate::mechanics::GROUND;

/// Of one rod: on the way down to it what those beyond pass on, afterwards its rows of the solution.
#[derive(Clone, Copy, Debug)]
struct Block {
    /// Stiffness of what is beyond, later the first six numbers of the gain.
    beyond: Symmetric,
    /// What their steps leave to be done, later the last three numbers of the gain.
    carried: DVec3,
    /// Later the rod's own step.
    step: DVec3,
}

/// What share of the loads' arms a sum of their torques may be, and a component of a direction, for no other reason than rounding:
/// far more than the round-off of such sums, far less than anybody means.
const ROUNDING: f64 = 1e-12;
const EMPTY: Block = Block { beyond: [0.0; 6], carried: DVec3::ZERO, step: DVec3::ZERO };

/// Torques at one state, and the elimination of the Hessian there. Buffers are kept between uses.
#[derive(Clone, Debug, Default)]
pub struct Balance {
    /// Orientation of each rod.
    pub orientation: Vec<DQuat>,
    block: Vec<Block>,
    /// What is passed along the tree: torques of the loads down to the bearers, turns of a step up from them.
    passed: Vec<DVec3>,
    /// One over the pivot of each rod, if it is kept for more solutions than one.
    pivot: Vec<Symmetric>,
    pub(super) keeps_pivots: bool,
    elements: Elements,
    joints: Joints,
    /// Energy of springs and loads, J.
    pub energy: f64,
    /// Sum of the sizes of the energy's terms: its rounding is a small multiple of this.
    pub energy_size: f64,
    /// Largest external torque about a base joint, N m.
    pub largest_torque: f64,
    /// Largest torque left over at a joint, N m; NaN when any is.
    pub largest_residual: f64,
    /// Sum of the loads' arms, each a rod long, N m.
    reach: f64,
    /// What rounding alone can leave over: of the springs' and of the loads' torques, N m.
    pub round_off: f64,
    /// How many of the Hessian's eigenvalues are not positive; 0 means stable. Of rods in a plane, for turns in that plane.
    pub unstable: u32,
    /// Of rods in a plane, the same for turns out of it.
    pub unstable_sideways: u32,
}

/// What is added to the Hessian's diagonal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damping {
    /// So many times the size of the loads' and springs' own torques.
    pub shift: f64,
    /// From 0 to 1: how much of what makes the loads and the commutators indefinite is taken away. With 1 only springs turned very
    /// far can leave a direction in which the energy falls.
    pub caution: f64,
}

/// `S v`.
#[inline]
fn times(s: &Symmetric, v: DVec3) -> DVec3 {
    DVec3::new(
        s[0] * v.x + s[3] * v.y + s[4] * v.z,
        s[3] * v.x + s[1] * v.y + s[5] * v.z,
        s[4] * v.x + s[5] * v.y + s[2] * v.z,
    )
}

impl Balance {
    /// Orientations at a state, from the ground up. O(n).
    pub fn orient(&mut self, rods: Rods, shape: &Shape) {
        shape.orient(rods, &mut self.joints, &mut self.orientation);
    }

    /// Torques, energy and the eliminated Hessian at the state last oriented. `force` is the sum of all forces at the distal end of
    /// each rod and beyond. O(n).
    pub fn weigh(&mut self, rods: Rods, shape: &Shape, force: &[DVec3], damping: Damping) {
        self.block.clear();
        self.pass_down(rods, shape, force, damping, true);
    }

    /// Torques and energy alone, as [`Balance::weigh`]; the Hessian stays the one eliminated last. O(n).
    pub fn look(&mut self, rods: Rods, shape: &Shape, force: &[DVec3]) {
        self.pass_down(rods, shape, force, Damping::default(), false);
    }

    fn pass_down(&mut self, rods: Rods, shape: &Shape, force: &[DVec3], damping: Damping, eliminates: bool) {
        let count = rods.len();
        self.block.resize(count, EMPTY);
        self.passed.clear();
        self.passed.resize(count, DVec3::ZERO);
        self.pivot.resize(if self.keeps_pivots { count } else { 0 }, [0.0; 6]);
        let (mut energy, mut size) = (0.0, 0.0);
        let (mut most_torque, mut most_residual, mut most_bent, mut loads) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0);
        let (mut unstable, mut unstable_sideways) = (0, 0);
        let (parent, stiffness) = (&rods.parent[..count], &rods.stiffness[..count]);
        let (orientation, block) = (&self.orientation[..count], &mut self.block[..count]);
        let passed = &mut self.passed[..count];
        let elements = &mut self.elements;
        for rod in (0..count).rev() {
            let lane = rod % LANES;
            if lane == LANES - 1 || rod == count - 1 {
                elements.compute(rods, shape, orientation, force, rod - lane, damping);
            }
            let moment = vector(&elements.moment, lane);
            let (stored, lifted) = (elements.stored[lane], elements.lifted[lane]);
            energy += stored + lifted;
            size += stored + lifted.abs();
            loads += elements.reach[lane];
            let torque = passed[rod] + vector(&elements.torque, lane);
            if parent[rod] != GROUND {
                passed[parent[rod] as usize] += torque;
            }
            let residual = moment - torque;
            let (torque_square, residual_square) = (torque.length_squared(), residual.length_squared());
            most_torque = if torque_square > most_torque { torque_square } else { most_torque };
            // Written so that NaN stays.
            most_residual = if residual_square <= most_residual { most_residual } else { residual_square };
            let moment_square = moment.length_squared();
            most_bent = if moment_square > most_bent { moment_square } else { most_bent };
            if !eliminates {
                continue;
            }
            let Block { mut beyond, carried, .. } = block[rod];
            for (beyond, load) in beyond.iter_mut().zip(&elements.load) {
                *beyond += load[lane];
            }
            let [xx, yy, zz, xy, xz, yz]: Symmetric =
                core::array::from_fn(|i| elements.spring[i][lane] + beyond[i]);
            // The adjugate: one division instead of three that wait for each other.
            let (c00, c01, c02) = (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy);
            let (c11, c12, c22) = (xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy);
            let mut determinant = xx * c00 + xy * c01 + xz * c02;
            if determinant == 0.0 {
                // One rounding to the bad side: it counts as not positive.
                determinant = -f64::EPSILON
                    * f64::max(stiffness[rod] * stiffness[rod] * stiffness[rod], f64::MIN_POSITIVE);
            }
            // Signs of xx, xx yy - xy^2 and the determinant are those of the pivots' products.
            let (first, second, third) = (xx > 0.0, c22 > 0.0, determinant > 0.0);
            let own_unstable = u32::from(!first) + u32::from(first != second) + u32::from(second != third);
            match rods.plane {
                None => unstable += own_unstable,
                Some(normal) => {
                    // Turns in the plane and out of it do not couple.
                    let pivot = normal.dot(times(&[xx, yy, zz, xy, xz, yz], normal));
                    let in_plane = u32::from(pivot.is_nan() || pivot <= 0.0);
                    unstable += in_plane;
                    unstable_sideways += own_unstable.saturating_sub(in_plane);
                }
            }
            let inverse = 1.0 / determinant;
            let inverted = [c00, c11, c22, c01, c02, c12].map(|minor| minor * inverse);
            let step = times(&inverted, carried - residual);
            if self.keeps_pivots {
                self.pivot[rod] = inverted;
            }
            // B = S - [M]/2, column by column, and the gain P^-1 B.
            let half = (0.5 * (1.0 - damping.caution)) * moment;
            let coupling = [
                DVec3::new(beyond[0], beyond[3] - half.z, beyond[4] + half.y),
                DVec3::new(beyond[3] + half.z, beyond[1], beyond[5] - half.x),
                DVec3::new(beyond[4] - half.y, beyond[5] + half.x, beyond[2]),
            ];
            let gain = coupling.map(|column| times(&inverted, column));
            if parent[rod] != GROUND {
                let below = &mut block[parent[rod] as usize];
                below.beyond[0] += beyond[0] - coupling[0].dot(gain[0]);
                below.beyond[1] += beyond[1] - coupling[1].dot(gain[1]);
                below.beyond[2] += beyond[2] - coupling[2].dot(gain[2]);
                below.beyond[3] += beyond[3] - coupling[0].dot(gain[1]);
                below.beyond[4] += beyond[4] - coupling[0].dot(gain[2]);
                below.beyond[5] += beyond[5] - coupling[1].dot(gain[2]);
                let passed = DVec3::new(coupling[0].dot(step), coupling[1].dot(step), coupling[2].dot(step));
                below.carried += carried - passed;
            }
            block[rod] = Block {
                beyond: [gain[0].x, gain[0].y, gain[0].z, gain[1].x, gain[1].y, gain[1].z],
                carried: gain[2],
                step,
            };
        }
        self.energy = energy;
        self.energy_size = size;
        self.largest_torque = libm::sqrt(most_torque);
        self.largest_residual = libm::sqrt(most_residual);
        self.reach = loads;
        self.round_off = 8.0 * f64::EPSILON * (libm::sqrt(most_bent) + loads);
        if eliminates {
            self.unstable = unstable;
            self.unstable_sideways = unstable_sideways;
        }
    }

    /// Newton's step from the state last weighed, `scale` times: adds it to the deviations, turns the orientations along,
    /// and returns the largest turn of any rod, radians. A rod that would turn by more than `limit` turns by that much, and those
    /// that it bears step as fits that. O(n).
    pub fn advance(&mut self, rods: Rods, shape: &mut Shape, scale: f64, limit: f64) -> f64 {
        let count = rods.len();
        self.passed.resize(count, DVec3::ZERO);
        let (parent, rest) = (&rods.parent[..count], &shape.rest[..count]);
        let (block, turn) = (&self.block[..count], &mut self.passed[..count]);
        let (orientation, deviation) = (&mut self.orientation[..count], &mut shape.deviation[..count]);
        let joints = &mut self.joints;
        let mut largest = 0.0_f64;
        for first in (0..count).step_by(LANES) {
            let here = first..count.min(first + LANES);
            for (lane, rod) in here.clone().enumerate() {
                let below = if parent[rod] == GROUND { DVec3::ZERO } else { turn[parent[rod] as usize] };
                let step = scale * block[rod].step - block[rod].gain(below);
                let mut step = rods.plane.map_or(step, |normal| normal * normal.dot(step));
                let mut own = below + step;
                let mut square = own.length_squared();
                if square > limit * limit {
                    own *= limit / libm::sqrt(square);
                    step = own - below;
                    square = limit * limit;
                }
                turn[rod] = own;
                // Written so that NaN stays.
                largest = if square <= largest { largest } else { square };
                put(&mut joints.deviation, lane, deviation[rod]);
                put(&mut joints.orientation, lane, orientation[rod].to_array());
                put(&mut joints.below, lane, below.to_array());
                put(&mut joints.step, lane, step.to_array());
            }
            joints.turn();
            for (lane, rod) in here.enumerate() {
                deviation[rod] = vector(&joints.deviation, lane).to_array();
                let turned = rest[rod] * joints.rotation(lane);
                orientation[rod] = normalized(match parent[rod] {
                    GROUND => turned,
                    bearer => orientation[bearer as usize] * turned,
                });
            }
        }
        libm::sqrt(largest)
    }

    /// With pivots kept: how the rods along a path from the ground to a rod's end step for forces on that end, a
    /// column each: from the state last weighed. O(path).
    pub(super) fn steps_for_forces(&self, rods: Rods, path: &[usize]) -> Vec<[DVec3; 3]> {
        let mut columns = alloc::vec![[DVec3::ZERO; 3]; path.len()];
        let (mut arm, mut carried) = (DVec3::ZERO, [DVec3::ZERO; 3]);
        for (place, &rod) in path.iter().enumerate().rev() {
            arm += self.orientation[rod] * DVec3::X * rods.length[rod];
            for (axis, carried) in carried.iter_mut().enumerate() {
                let torque = *carried + arm.cross(DVec3::AXES[axis]);
                let step = times(&self.pivot[rod], torque);
                columns[place][axis] = step;
                // B^T P^-1 r, with B = P gain.
                *carried -= self.block[rod].gain_transposed(torque);
            }
        }
        columns
    }

    /// How far the end of a path moves when its rods step so. O(path).
    pub(super) fn moved(&self, rods: Rods, path: &[usize], step: impl Fn(usize) -> DVec3) -> DVec3 {
        let mut turn = DVec3::ZERO;
        path.iter().enumerate().fold(DVec3::ZERO, |moved, (place, &rod)| {
            turn += step(place) - self.block[rod].gain(turn);
            moved + turn.cross(self.orientation[rod] * DVec3::X * rods.length[rod])
        })
    }

    /// Newton's own step of a rod, before its bearer's turn.
    pub(super) fn step_mut(&mut self, rod: usize) -> &mut DVec3 {
        &mut self.block[rod].step
    }

    /// Largest torque left over, relative to the largest external torque; 0 where no load bends anything, as an upright stem's.
    pub fn relative_residual(&self) -> f64 {
        let is_rounding = self.largest_residual <= self.round_off && self.is_unbent();
        if is_rounding { 0.0 } else { self.largest_residual / self.largest_torque }
    }

    /// Whether a rod with all that it bears falls counter-clockwise about its own third axis, that of bending in its vertical
    /// plane: as the loads turn it, where that is more than rounding; else down, and from where it is upright or hangs to the
    /// side of its azimuth. At the state last weighed.
    pub fn falls_left(&self, rods: Rods, force: &[DVec3], rod: usize) -> bool {
        let [along, left, about] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| self.orientation[rod] * axis);
        let torque = (self.passed[rod] + (rods.length[rod] * along).cross(force[rod])).dot(about);
        if torque.abs() > ROUNDING * self.reach {
            torque > 0.0
        } else if left.y.abs() > ROUNDING {
            left.y < 0.0
        } else {
            along.y < 0.0
        }
    }

    /// Whether the loads bend nothing: no torque exceeds a millionth of the loads' arms.
    pub fn is_unbent(&self) -> bool {
        self.largest_torque <= 1e-6 * self.reach
    }
}

impl Block {
    /// The transposed of [`Block::gain`].
    fn gain_transposed(&self, torque: DVec3) -> DVec3 {
        let [ax, ay, az, bx, by, bz] = self.beyond;
        let columns = [DVec3::new(ax, ay, az), DVec3::new(bx, by, bz), self.carried];
        DVec3::from_array(columns.map(|column| column.dot(torque)))
    }

    /// Of the solution: by how much less a joint steps for its bearer's turn.
    #[inline]
    fn gain(&self, turn: DVec3) -> DVec3 {
        let [ax, ay, az, bx, by, bz] = self.beyond;
        DVec3::new(
            ax * turn.x + bx * turn.y + self.carried.x * turn.z,
            ay * turn.x + by * turn.y + self.carried.y * turn.z,
            az * turn.x + bz * turn.y + self.carried.z * turn.z,
        )
    }
}
