//! From the state of growth to the result arrays.

use alloc::vec;
use alloc::vec::Vec;

use super::state::Growth;
use super::wood::Wood;
use crate::angle::Degrees;
use crate::mechanics::{GROUND, Linkage, Report};
use crate::params::Thickening;
use crate::plant::{Plant, Polylines, Segments};
use crate::trigonometry::sin_cos;

/// The result arrays for this shape of the plant.
pub(super) fn assemble(growth: &Growth, linkage: &Linkage, report: Report) -> Plant {
    let mut angle = Vec::new();
    linkage.angles(&mut angle);
    let rods = RodsOfAxes::new(growth);
    Plant {
        polylines: polylines(growth, linkage, &angle, &rods),
        segments: segments(growth, linkage, &angle, &rods),
        params: growth.params.clone(),
        report,
    }
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

fn polylines(growth: &Growth, linkage: &Linkage, angle: &[f64], rods: &RodsOfAxes) -> Polylines {
    let (base_sin, base_cos) = growth.params.axis.elevation.sin_cos();
    let mut end = Vec::with_capacity(linkage.len());
    for (rod, &angle) in angle.iter().enumerate() {
        let [x, y] = match linkage.parent[rod] {
            GROUND => [0.0, 0.0],
            parent => end[parent as usize],
        };
        let (sin, cos) = sin_cos(angle);
        let length = linkage.length[rod];
        let dx = length * (cos * base_cos - sin * base_sin);
        let dy = length * (sin * base_cos + cos * base_sin);
        end.push([x + dx, y + dy]);
    }
    let mut polylines = Polylines { offsets: vec![0], ..Polylines::default() };
    for (index, axis) in growth.state.axes.iter().enumerate() {
        let attached = if axis.attached == GROUND { [0.0, 0.0] } else { end[axis.attached as usize] };
        let ends = rods.of(index).iter().map(|&rod| end[rod as usize]);
        polylines.points.extend(core::iter::once(attached).chain(ends).flat_map(|[x, y]| [x, y, 0.0]));
        polylines.radii.extend(radii(growth, index, rods.of(index)));
        polylines.offsets.push(polylines.radii.len() as u32);
    }
    polylines
}

/// Radius at every point of an axis. Pipes end inside a segment's joint: there the limb takes the mean of both
/// sides.
fn radii<'a>(growth: &'a Growth, axis: usize, rods: &'a [u32]) -> impl Iterator<Item = f64> + 'a {
    let state = &growth.state.axes[axis];
    let born = &growth.plan.generations[state.generation as usize].radius_at;
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

fn segments(growth: &Growth, linkage: &Linkage, angle: &[f64], rods: &RodsOfAxes) -> Segments {
    let (base_sin, base_cos) = Degrees(0.5 * growth.params.axis.elevation.0).sin_cos();
    let foreseen = (!growth.foreseen_stress.is_empty()).then(|| growth.foreseen_stress.clone());
    let stress = foreseen.unwrap_or_else(|| stress(growth, linkage));
    let mut segment_of_rod = vec![-1; linkage.len()];
    let mut grown = vec![0; growth.state.axes.len()];
    let mut segments = Segments::default();
    for (rod, wood) in segments_of(growth) {
        let axis = wood.axis as usize;
        // A child's bearer is the node; what bears the node is the parent's last segment.
        let bearer = if grown[axis] == 0 { growth.state.axes[axis].attached } else { linkage.parent[rod] };
        let parent = if bearer == GROUND { -1 } else { segment_of_rod[bearer as usize] };
        segment_of_rod[rod] = segments.parent.len() as i32;
        grown[axis] += 1;
        segments.parent.push(parent);
        segments.point.push((rods.offsets[axis] + axis + grown[axis]) as u32);
        segments.axis.push(wood.axis);
        segments.order.push(growth.state.axes[axis].generation);
        segments.birth.push(wood.birth);
        segments.length.push(linkage.length[rod]);
        segments.radius.push(growth.section(rod).radius());
        segments.mass.push(growth.mass(rod));
        let (sin, cos) = sin_cos(0.5 * angle[rod]);
        let rotation = [0.0, 0.0, sin * base_cos + cos * base_sin, cos * base_cos - sin * base_sin];
        segments.rotation.extend(rotation);
        segments.moment.push(linkage.stiffness[rod] * linkage.deviation[rod]);
        segments.twist_moment.push(0.0);
        let bend = linkage.rest[rod] - wood.branching_turn;
        segments.curvature.push((bend + linkage.deviation[rod]) / wood.joint_length);
        segments.rest_curvature.push(bend / wood.joint_length);
        segments.stress.push(stress[rod]);
    }
    segments
}

/// Largest fibre stress at every rod's base joint: over its pipes, `E r |mu - phi| / s`, each pipe with its own
/// outer radius and the rest angle it was laid with.
pub(super) fn stress(growth: &Growth, linkage: &Linkage) -> Vec<f64> {
    let wood = &growth.state.wood;
    let modulus = growth.params.material.youngs_modulus;
    let strain =
        |rod: usize, radius: f64, deviation: f64| modulus * radius * deviation.abs() / wood[rod].joint_length;
    let remembered = growth.params.growth.thickening == Thickening::Pipes && growth.is_exact();
    if !remembered {
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
