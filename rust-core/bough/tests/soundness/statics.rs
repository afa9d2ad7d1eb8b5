//! The statics of a plant once more, from its result arrays alone and by other ways than the core's: torques summed pair by
//! pair, stiffnesses from radii and lengths, stability by a dense factorisation. O(n^3), for small plants.

use std::f64::consts::PI;

use bough::Plant;
use bough::params::{Discretization, Thickening};

use super::forces::forces;

/// One rod: a segment, or the massless node of a fork.
struct Rod {
    bearer: Option<usize>,
    /// From its base to its distal end, m.
    arm: [f64; 2],
    base: [f64; 2],
    stiffness: f64,
    /// Deviation of its base joint, radians.
    deviation: f64,
    /// Bound of the angles that its base joint's deviation was subtracted from, radians.
    angles: f64,
    /// Force at its distal end, N.
    force: [f64; 2],
    /// What the plant says of its base joint; none for a node.
    moment: Option<f64>,
}

/// The rods of a plant that stands alone.
pub struct Statics {
    rods: Vec<Rod>,
    /// External torque about each base joint, N m, counter-clockwise.
    torque: Vec<f64>,
    /// Sum of all forces beyond each base joint.
    beyond: Vec<[f64; 2]>,
    /// Size of all forces that others may cancel, N.
    pull: f64,
    /// Torque that rounding of places and sums can make at any joint, N m.
    rounding: f64,
}

fn second_moment(radius: f64) -> f64 {
    let square = radius * radius;
    0.25 * PI * square * square
}

impl Statics {
    /// Of a plant on whose segments forces pull, or do not.
    pub fn of(plant: &Plant, pulled: bool) -> Self {
        let (forces, pull) = forces(plant, pulled);
        let rods = rods(plant, forces);
        let rods_count = rods.len();
        let is_beyond = |mut rod: usize, joint: usize| loop {
            if rod == joint {
                return true;
            }
            match rods[rod].bearer {
                Some(bearer) => rod = bearer,
                None => return false,
            }
        };
        let mut torque = vec![0.0; rods_count];
        let mut beyond = vec![[0.0; 2]; rods_count];
        let mut reach = 0.0_f64;
        for (joint, at) in rods.iter().enumerate() {
            for (_, rod) in rods.iter().enumerate().filter(|(index, _)| is_beyond(*index, joint)) {
                let [fx, fy] = rod.force;
                let [dx, dy] = [0, 1].map(|axis| rod.base[axis] + rod.arm[axis] - at.base[axis]);
                torque[joint] += dx * fy - dy * fx;
                beyond[joint][0] += fx;
                beyond[joint][1] += fy;
            }
            reach += at.arm[0].abs() + at.arm[1].abs();
        }
        let angles = rods.iter().map(|rod| rod.angles).fold(1.0, f64::max);
        let rounding = 8.0 * f64::EPSILON * rods_count as f64 * angles * reach * pull;
        Statics { rods, torque, beyond, pull, rounding }
    }

    /// Largest external torque, N m.
    pub fn largest_torque(&self) -> f64 {
        self.torque.iter().fold(0.0, |largest, torque| largest.max(torque.abs()))
    }

    /// Largest torque left over at any segment's joint, N m.
    pub fn residual(&self) -> f64 {
        let left = |(rod, torque): (&Rod, &f64)| rod.moment.map_or(0.0, |moment| (moment - torque).abs());
        self.rods.iter().zip(&self.torque).map(left).fold(0.0, f64::max)
    }

    /// Residual that the rounding of stored angles, here and there, can leave: the core lets eight roundings pass of each of the
    /// three angles whose difference a deviation is.
    pub fn rounding(&self) -> f64 {
        let of_joint = |rod: &Rod| rod.stiffness * rod.angles;
        let largest = self.rods.iter().map(of_joint).fold(0.0, f64::max);
        self.rounding + 24.0 * f64::EPSILON * largest
    }

    /// Every joint's moment is its stiffness times its deviation (equation 33).
    pub fn check_springs(&self) {
        for (index, rod) in self.rods.iter().enumerate() {
            let Some(moment) = rod.moment else { continue };
            let expected = rod.stiffness * rod.deviation;
            // A dozen roundings of each factor, and those of the angles whose difference the deviation is.
            let allowed = 1e-13 * expected.abs() + 4.0 * f64::EPSILON * rod.stiffness * rod.angles;
            assert!((moment - expected).abs() <= allowed, "rod {index}: {moment} is not {expected}");
        }
    }

    /// The smallest pivot of the energy's Hessian, scaled so that its diagonal's own terms add up to 1, by a dense Cholesky
    /// factorisation that ends at the first pivot which is not clearly positive. None where rounding decides: of a twig
    /// that is so thin that one rounding of its direction weighs more than its stiffness.
    pub fn smallest_pivot(&self) -> Option<f64> {
        let count = self.rods.len();
        let mut hessian = vec![vec![0.0; count]; count];
        let mut size = vec![0.0; count];
        for (index, rod) in self.rods.iter().enumerate() {
            let geometric = self.beyond[index][0] * rod.arm[0] + self.beyond[index][1] * rod.arm[1];
            hessian[index][index] += rod.stiffness + geometric;
            size[index] += rod.stiffness + geometric.abs();
            if let Some(bearer) = rod.bearer {
                hessian[bearer][bearer] += rod.stiffness;
                size[bearer] += rod.stiffness;
                hessian[index][bearer] -= rod.stiffness;
                hessian[bearer][index] -= rod.stiffness;
            }
        }
        for (index, rod) in self.rods.iter().enumerate() {
            let arm = rod.arm[0].abs() + rod.arm[1].abs();
            if 16.0 * f64::EPSILON * self.pull * arm * rod.angles.max(1.0) > CLEARLY * size[index] {
                return None;
            }
        }
        for row in 0..count {
            for column in 0..count {
                hessian[row][column] /= size[row].sqrt() * size[column].sqrt();
            }
        }
        let mut smallest = f64::INFINITY;
        for pivot in 0..count {
            let diagonal = hessian[pivot][pivot];
            smallest = smallest.min(diagonal);
            if diagonal <= CLEARLY {
                break;
            }
            let eliminated = hessian[pivot].clone();
            for row in &mut hessian[pivot + 1..] {
                let factor = row[pivot] / diagonal;
                row.iter_mut().zip(&eliminated).for_each(|(entry, above)| *entry -= factor * above);
            }
        }
        Some(smallest)
    }

    /// By how much the energy rises when every rod turns by `turn` of it, radians; and by how much less than nothing that may
    /// be at an equilibrium: what is left over of the torques, terms of third order, and rounding.
    pub fn rise(&self, turn: impl Fn(usize) -> f64) -> (f64, f64) {
        let (mut rise, mut allowed) = (0.0, 0.0);
        for (index, rod) in self.rods.iter().enumerate() {
            let own = turn(index);
            let change = own - rod.bearer.map_or(0.0, &turn);
            let moment = rod.moment.unwrap_or(self.torque[index]);
            rise += change * (moment + 0.5 * rod.stiffness * change);
            let ([x, y], [dx, dy]) = (self.beyond[index], rod.arm);
            let (sin, half) = (own.sin(), (0.5 * own).sin());
            let shorter = -2.0 * half * half;
            rise -= x * (dx * shorter - dy * sin) + y * (dx * sin + dy * shorter);
            allowed += (moment - self.torque[index]).abs() * change.abs();
            let load = (x.abs() + y.abs()) * (dx.abs() + dy.abs());
            allowed += load * own.abs() * own * own + 32.0 * f64::EPSILON * load * own.abs();
            allowed += f64::EPSILON * (moment * change).abs() + self.rounding * change.abs();
        }
        (rise, allowed)
    }

    pub fn rods(&self) -> usize {
        self.rods.len()
    }
}

/// What a scaled pivot must exceed to count as positive beyond any rounding.
pub const CLEARLY: f64 = 1e-6;

fn rods(plant: &Plant, force: Vec<[f64; 3]>) -> Vec<Rod> {
    let (params, segments) = (&plant.params, &plant.segments);
    let paper = params.solver.discretization == Discretization::Paper;
    let modulus = params.material.youngs_modulus;
    let count = segments.parent.len();
    let pipes: Vec<f64> = (0..count)
        .map(|segment| match params.growth.thickening {
            Thickening::None => 1.0,
            Thickening::Pipes => f64::from(plant.report.steps + 1 - segments.birth[segment]),
        })
        .collect();
    let at = |point: usize| [plant.polylines.points[3 * point], plant.polylines.points[3 * point + 1]];
    let bearer = |segment: usize| usize::try_from(segments.parent[segment]).ok();
    let end = |segment: usize| at(segments.point[segment] as usize);
    let rigidity = |radius: f64| modulus * second_moment(radius);

    let mut rods: Vec<Rod> = Vec::new();
    let mut rod_of = vec![0; count];
    let mut node_of: Vec<Option<usize>> = vec![None; count];
    for segment in 0..count {
        let length = segments.length[segment];
        let parent = bearer(segment);
        let is_first = parent.is_none_or(|parent| segments.axis[parent] != segments.axis[segment]);
        let mut rod_below = parent.map(|parent| rod_of[parent]);
        if let (true, false, Some(parent)) = (is_first, paper, parent) {
            // To second order the parent's last half is a spring of its own, up to the node where the children begin.
            let node = *node_of[parent].get_or_insert_with(|| {
                rods.push(Rod {
                    bearer: rod_below,
                    arm: [0.0; 2],
                    base: end(parent),
                    stiffness: 2.0 * rigidity(segments.radius[parent]) / segments.length[parent],
                    deviation: 0.0,
                    angles: PI,
                    force: [0.0; 2],
                    moment: None,
                });
                rods.len() - 1
            });
            rod_below = Some(node);
        }
        let birth_radius = |segment: usize| segments.radius[segment] / pipes[segment].sqrt();
        let (joint_length, stiffness) = match parent {
            _ if paper => (length, rigidity(segments.radius[segment]) / length),
            Some(parent) if !is_first => {
                let below = segments.length[parent];
                let first =
                    2.0 / (below / rigidity(birth_radius(parent)) + length / rigidity(birth_radius(segment)));
                (0.5 * (below + length), pipes[segment] * pipes[segment] * first)
            }
            _ => (0.5 * length, 2.0 * rigidity(segments.radius[segment]) / length),
        };
        let base = parent.map_or([0.0; 2], end);
        let tip = end(segment);
        let (curvature, rest) = (segments.curvature[segment], segments.rest_curvature[segment]);
        // A fork turns by at most half a turn, and all angles are sums of those below.
        let own = (curvature.abs() + rest.abs()) * joint_length + if is_first { PI } else { 0.0 };
        let below = rod_below.map_or(0.0, |rod| rods[rod].angles);
        rod_of[segment] = rods.len();
        rods.push(Rod {
            bearer: rod_below,
            arm: [tip[0] - base[0], tip[1] - base[1]],
            base,
            stiffness,
            deviation: (curvature - rest) * joint_length,
            angles: below + own,
            force: [force[segment][0], force[segment][1]],
            moment: Some(segments.moment[segment]),
        });
    }
    rods
}
