//! From the state of growth to the result arrays.

use alloc::vec;
use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::axis::STEM;
use super::pull::turned;
use super::state::Growth;
use super::wood::Wood;
use crate::angle::Degrees;
use crate::mechanics::{GROUND, Linkage, Report};
use crate::params::Thickening;
use crate::plant::{Plant, Polylines, Segments};
use crate::space::{Shape, log};
use crate::trigonometry::sin_cos;

/// The shape of the rods: in their plane or in space.
pub(super) enum Pose<'a> {
    Plane(&'a Linkage),
    Space { shape: &'a Shape, orientation: &'a [DQuat] },
}

/// The result arrays for this shape of the plant.
pub(super) fn assemble(growth: &Growth, pose: &Pose, report: Report) -> Plant {
    let mut angle = Vec::new();
    if let Pose::Plane(linkage) = pose {
        linkage.angles(&mut angle);
    }
    let rods = RodsOfAxes::new(growth);
    let end = match pose {
        Pose::Plane(linkage) => ends_in_plane(growth, linkage, &angle),
        Pose::Space { orientation, .. } => ends_in_space(growth, orientation),
    };
    let joints = match pose {
        Pose::Plane(linkage) => joints_in_plane(growth, linkage, &angle),
        Pose::Space { shape, orientation } => joints_in_space(growth, shape, orientation),
    };
    let stress = match pose {
        Pose::Plane(_) if !growth.foreseen_stress.is_empty() => growth.foreseen_stress.clone(),
        Pose::Plane(linkage) => stress(growth, linkage),
        Pose::Space { shape, .. } => growth.stress_in_space(shape),
    };
    let mut plant = Plant {
        polylines: polylines(growth, &end, &rods),
        segments: segments(growth, &joints, &stress, &rods),
        params: growth.params.clone(),
        report,
    };
    plant.judge_strength();
    plant
}

/// What there is to say of a rod and its base joint.
struct Joint {
    /// Orientation of the rod, a quaternion x, y, z, w.
    rotation: [f64; 4],
    moment: f64,
    twist_moment: f64,
    curvature: f64,
    rest_curvature: f64,
}

/// Which rods are the segments of which axis. The nodes of forks belong to the mechanics alone.
struct RodsOfAxes {
    /// The segments of all axes as rods, axis after axis.
    rods: Vec<u32>,
    /// Axis a owns `rods[offsets[a] .. offsets[a + 1]]`.
    offsets: Vec<usize>,
}

impl RodsOfAxes {
    fn new(growth: &Growth) -> Self {
        let mut offsets = vec![0];
        for axis in &growth.state.axes {
            offsets.push(offsets[offsets.len() - 1] + axis.segments as usize);
        }
        let mut next = offsets.clone();
        let mut rods = vec![0; offsets[offsets.len() - 1]];
        for (rod, wood) in segments_of(growth) {
            rods[next[wood.axis as usize]] = rod as u32;
            next[wood.axis as usize] += 1;
        }
        RodsOfAxes { rods, offsets }
    }

    fn of(&self, axis: usize) -> &[u32] {
        &self.rods[self.offsets[axis]..self.offsets[axis + 1]]
    }
}

/// The rods that are segments, with their wood.
pub(super) fn segments_of(growth: &Growth) -> impl Iterator<Item = (usize, &Wood)> {
    let length = &growth.state.linkage.length;
    growth.state.wood.iter().enumerate().filter(|(rod, _)| length[*rod] > 0.0)
}

/// Distal end of every rod, m.
fn ends_in_plane(growth: &Growth, linkage: &Linkage, angle: &[f64]) -> Vec<[f64; 3]> {
    let (base_sin, base_cos) = growth.params.axis.elevation.sin_cos();
    let mut end: Vec<[f64; 3]> = Vec::with_capacity(linkage.len());
    for (rod, &angle) in angle.iter().enumerate() {
        let [x, y, _] = match linkage.parent[rod] {
            GROUND => [0.0; 3],
            parent => end[parent as usize],
        };
        let (sin, cos) = sin_cos(angle);
        let length = linkage.length[rod];
        let dx = length * (cos * base_cos - sin * base_sin);
        let dy = length * (sin * base_cos + cos * base_sin);
        end.push([x + dx, y + dy, 0.0]);
    }
    end.iter_mut().for_each(|point| *point = turned(growth.params.axis.azimuth, *point));
    end
}

fn ends_in_space(growth: &Growth, orientation: &[DQuat]) -> Vec<[f64; 3]> {
    let linkage = &growth.state.linkage;
    let mut end: Vec<[f64; 3]> = Vec::with_capacity(linkage.len());
    for (rod, orientation) in orientation.iter().enumerate() {
        let foot = match linkage.parent[rod] {
            GROUND => DVec3::ZERO,
            parent => DVec3::from_array(end[parent as usize]),
        };
        end.push((foot + *orientation * DVec3::X * linkage.length[rod]).to_array());
    }
    end
}

fn joints_in_plane(growth: &Growth, linkage: &Linkage, angle: &[f64]) -> Vec<Joint> {
    let (base_sin, base_cos) = Degrees(0.5 * growth.params.axis.elevation.0).sin_cos();
    let azimuth = growth.params.axis.azimuth;
    let (turn_sin, turn_cos) = Degrees(0.5 * azimuth.0).sin_cos();
    let joint = |(rod, wood): (usize, &Wood)| {
        let (sin, cos) = sin_cos(0.5 * angle[rod]);
        let [z, w] = [sin * base_cos + cos * base_sin, cos * base_cos - sin * base_sin];
        let bend = linkage.rest[rod] - wood.branching_turn;
        Joint {
            rotation: match azimuth.0 {
                0.0 => [0.0, 0.0, z, w],
                _ => [turn_sin * z, turn_sin * w, turn_cos * z, turn_cos * w],
            },
            moment: linkage.stiffness[rod] * linkage.deviation[rod],
            twist_moment: 0.0,
            curvature: (bend + linkage.deviation[rod]) / wood.joint_length,
            rest_curvature: bend / wood.joint_length,
        }
    };
    growth.state.wood.iter().enumerate().map(joint).collect()
}

fn joints_in_space(growth: &Growth, shape: &Shape, orientation: &[DQuat]) -> Vec<Joint> {
    let rods = growth.rods_in_space();
    let mut is_first = vec![true; growth.state.axes.len()];
    let joint = |(rod, wood): (usize, &Wood)| {
        let axis = wood.axis as usize;
        // The node that ends an axis is its last rod, never its first.
        let branching = if is_first[axis] { growth.state.axes[axis].branching } else { DQuat::IDENTITY };
        is_first[axis] = false;
        let bend =
            |joint: DQuat| shape.across(rod, log(branching.conjugate() * joint))[0] / wood.joint_length;
        let [moment, twist_moment] = shape.moment(rods, rod);
        Joint {
            rotation: orientation[rod].to_array(),
            moment,
            twist_moment,
            curvature: bend(shape.joint(rod)),
            rest_curvature: bend(shape.rest[rod]),
        }
    };
    growth.state.wood.iter().enumerate().map(joint).collect()
}

fn polylines(growth: &Growth, end: &[[f64; 3]], rods: &RodsOfAxes) -> Polylines {
    let mut polylines = Polylines { offsets: vec![0], ..Polylines::default() };
    for (index, axis) in growth.state.axes.iter().enumerate() {
        let attached = if axis.attached == GROUND { [0.0; 3] } else { end[axis.attached as usize] };
        let ends = rods.of(index).iter().map(|&rod| end[rod as usize]);
        polylines.points.extend(core::iter::once(attached).chain(ends).flatten());
        polylines.radii.extend(radii(growth, index, rods.of(index)));
        polylines.offsets.push(polylines.radii.len() as u32);
    }
    polylines
}

/// Radius at every point of an axis. Pipes end inside a segment's joint: there the limb takes the mean of both
/// sides.
fn radii<'a>(growth: &'a Growth, axis: usize, rods: &'a [u32]) -> impl Iterator<Item = f64> + 'a {
    let state = &growth.state.axes[axis];
    let born = &growth.plan.of(state.generation).radius_at;
    let pipes = growth.params.growth.thickening == Thickening::Pipes;
    let radius = |index: usize| rods.get(index).map(|&rod| growth.section(rod as usize).radius());
    (0..=rods.len()).map(move |point| {
        if !pipes {
            return state.base_radius * born[point];
        }
        let below = point.checked_sub(1).and_then(radius);
        let above = radius(point);
        let (below, above) = (below.or(above), above.or(below));
        0.5 * (below.unwrap_or_default() + above.unwrap_or_default())
    })
}

fn segments(growth: &Growth, joints: &[Joint], stress: &[f64], rods: &RodsOfAxes) -> Segments {
    let linkage = &growth.state.linkage;
    // A fork's node counts as the segment that it ends.
    let mut segment_of_rod = vec![-1; linkage.len()];
    let mut grown = vec![0; growth.state.axes.len()];
    let mut segments = Segments::default();
    for (rod, wood) in growth.state.wood.iter().enumerate() {
        let bearer = linkage.parent[rod];
        let parent = if bearer == GROUND { -1 } else { segment_of_rod[bearer as usize] };
        if linkage.length[rod] == 0.0 {
            segment_of_rod[rod] = parent;
            continue;
        }
        let axis = wood.axis as usize;
        segment_of_rod[rod] = segments.parent.len() as i32;
        grown[axis] += 1;
        segments.parent.push(parent);
        segments.point.push((rods.offsets[axis] + axis + grown[axis]) as u32);
        segments.axis.push(wood.axis);
        segments.order.push(growth.order(axis));
        segments.birth.push(wood.birth);
        segments.length.push(linkage.length[rod]);
        segments.radius.push(growth.section(rod).radius());
        segments.mass.push(growth.mass(rod));
        let joint = &joints[rod];
        segments.rotation.extend(joint.rotation);
        segments.moment.push(joint.moment);
        segments.twist_moment.push(joint.twist_moment);
        segments.curvature.push(joint.curvature);
        segments.rest_curvature.push(joint.rest_curvature);
        segments.stress.push(stress[rod]);
    }
    segments
}

impl Growth {
    /// Branching order of an axis: a flexible stem has 0, and its axes one more than their generation.
    fn order(&self, axis: usize) -> u32 {
        match self.state.axes[axis].generation {
            STEM => 0,
            generation => generation + u32::from(self.plan.stem.is_some()),
        }
    }

    /// Whether the rest angles of all pipes are on record.
    pub(super) fn remembers_pipes(&self) -> bool {
        self.params.growth.thickening == Thickening::Pipes && self.is_exact()
    }
}

/// Largest fibre stress at every rod's base joint: over its pipes, `E r |mu - phi| / s`, each pipe with its own
/// outer radius and the rest angle it was laid with.
pub(super) fn stress(growth: &Growth, linkage: &Linkage) -> Vec<f64> {
    let wood = &growth.state.wood;
    let modulus = growth.params.material.youngs_modulus;
    let strain =
        |rod: usize, radius: f64, deviation: f64| modulus * radius * deviation.abs() / wood[rod].joint_length;
    if !growth.remembers_pipes() {
        let whole = |rod: usize| strain(rod, growth.section(rod).radius(), linkage.deviation[rod]);
        return (0..wood.len()).map(whole).collect();
    }
    // The p-th pipe's radius is the first one's times the root of p, so what counts is the largest p (mu - phi)^2.
    let mut largest = vec![0.0_f64; wood.len()];
    let angle: Vec<f64> = (0..wood.len()).map(|rod| linkage.joint_angle(rod)).collect();
    let mut laid = &growth.laid[..];
    for step in 1..=growth.state.step {
        let rods = wood.partition_point(|wood| wood.birth <= step);
        let Some((rest, later)) = laid.split_at_checked(rods) else { break };
        laid = later;
        let (since, angle) = (&growth.state.pipes.since[..rods], &angle[..rods]);
        let (largest, step) = (&mut largest[..rods], f64::from(step));
        for rod in 0..rods {
            let deviation = angle[rod] - rest[rod];
            let strained = (step - since[rod]) * deviation * deviation;
            largest[rod] = if strained > largest[rod] { strained } else { largest[rod] };
        }
    }
    let of_pipes = |(rod, largest): (usize, f64)| strain(rod, wood[rod].birth_radius, libm::sqrt(largest));
    largest.into_iter().enumerate().map(of_pipes).collect()
}
