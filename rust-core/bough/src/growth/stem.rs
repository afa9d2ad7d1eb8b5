//! Copies of a plant around a straight, rigid stem (figures 13d and 17d): each in its own vertical plane, lower
//! ones older. Nothing is computed anew: the copies are ages of one plant.

use alloc::vec;

use super::pull::turned;
use crate::angle::Degrees;
use crate::params::{ArrangementPattern, Params, copies_differ};
use crate::plant::{Plant, Polylines, Segments};

/// Where and which way a copy stands.
pub(super) struct Place {
    height: f64,
    azimuth: Degrees,
    /// The stem's segment that bears it.
    bearer: u32,
}

/// Where a copy stands, the oldest first.
pub(super) fn place(params: &Params, copy: usize) -> Place {
    let turned = Degrees(copy as f64 * params.arrangement.divergence.0 % 360.0);
    Place {
        height: params.arrangement.trunk + (copy + 1) as f64 * params.arrangement.spacing,
        // Copies that differ have been grown in their own planes.
        azimuth: if copies_differ(params) { Degrees(0.0) } else { turned },
        bearer: copy as u32,
    }
}

/// The params of one of the copies that differ: alone, and in its own vertical plane.
pub(super) fn alone(params: &Params, copy: usize) -> Params {
    let mut alone = params.clone();
    alone.arrangement.pattern = ArrangementPattern::Single;
    alone.axis.azimuth.0 = (params.axis.azimuth.0 + copy as f64 * params.arrangement.divergence.0) % 360.0;
    // Around a stem it is given in each axis's own plane.
    alone.loads.tip_force = turned(alone.axis.azimuth, params.loads.tip_force);
    alone
}

impl Place {
    /// A point in space as seen in the copy's own plane.
    pub(super) fn inward(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.azimuth.sin_cos();
        [x * cos - z * sin, y - self.height, x * sin + z * cos]
    }

    /// A vector in the copy's own plane as seen in space.
    pub(super) fn outward(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.azimuth.sin_cos();
        [x * cos + z * sin, y, z * cos - x * sin]
    }
}

/// The stem and its copies as one plant; `copies` from the oldest, lowest one up. The stem is axis 0.
pub(super) fn around(params: &Params, copies: &[Plant]) -> Plant {
    let mut plant = stem(params, copies);
    for (index, copy) in copies.iter().enumerate() {
        let place = place(params, index);
        add(&mut plant, copy, &place);
    }
    plant.judge_strength();
    plant
}

/// The stem alone: one segment up to each copy, as thick as the pipes of all copies above it together.
fn stem(params: &Params, copies: &[Plant]) -> Plant {
    let spacing = params.arrangement.spacing;
    let base_area = |copy: &Plant| copy.segments.radius.first().map_or(0.0, |radius| radius * radius);
    let mut above: f64 = copies.iter().map(base_area).sum();
    let mut polylines = Polylines { points: vec![0.0; 3], radii: vec![libm::sqrt(above)], offsets: vec![0] };
    let mut segments = Segments::default();
    let up = core::f64::consts::FRAC_1_SQRT_2;
    for (index, copy) in copies.iter().enumerate() {
        let radius = libm::sqrt(above);
        above = (above - base_area(copy)).max(base_area(copy));
        let length = if index == 0 { params.arrangement.trunk + spacing } else { spacing };
        polylines.points.extend([0.0, place(params, index).height, 0.0]);
        polylines.radii.push(libm::sqrt(above));
        segments.parent.push(index as i32 - 1);
        segments.point.push(index as u32 + 1);
        segments.axis.push(0);
        segments.order.push(0);
        segments.birth.push(1 + index as u32 * params.arrangement.interval);
        segments.length.push(length);
        segments.radius.push(radius);
        segments.mass.push(params.material.density * core::f64::consts::PI * radius * radius * length);
        segments.rotation.extend([0.0, 0.0, up, up]);
        let bending = [&mut segments.moment, &mut segments.twist_moment, &mut segments.stress];
        let bent = [&mut segments.curvature, &mut segments.rest_curvature];
        bending.into_iter().chain(bent).for_each(|array| array.push(0.0));
    }
    polylines.offsets.push(polylines.radii.len() as u32);
    // The oldest copy took all the steps that the others took.
    let mut report = copies.first().map(|oldest| oldest.report).unwrap_or_default();
    for copy in copies {
        report.status = report.status.max(copy.report.status);
        report.residual = f64::max(report.residual, copy.report.residual);
        report.stable = report.stable.zip(copy.report.stable).map(|(all, this)| all && this);
    }
    Plant { polylines, segments, params: params.clone(), report }
}

/// Adds one copy, turned about the vertical and lifted to its place.
fn add(plant: &mut Plant, copy: &Plant, place: &Place) {
    let (half_sin, half_cos) = Degrees(0.5 * place.azimuth.0).sin_cos();
    let axes = plant.polylines.offsets.len() as u32 - 1;
    let points = plant.polylines.radii.len() as u32;
    let bearers = plant.segments.parent.len() as i32;

    let polylines = &mut plant.polylines;
    for point in copy.polylines.points.chunks_exact(3) {
        let [x, y, z] = place.outward([point[0], point[1], point[2]]);
        polylines.points.extend([x, y + place.height, z]);
    }
    polylines.radii.extend(&copy.polylines.radii);
    polylines.offsets.extend(copy.polylines.offsets.iter().skip(1).map(|offset| offset + points));

    let (to, from) = (&mut plant.segments, &copy.segments);
    let bearer = |parent: &i32| if *parent < 0 { place.bearer as i32 } else { parent + bearers };
    to.parent.extend(from.parent.iter().map(bearer));
    to.point.extend(from.point.iter().map(|point| point + points));
    to.axis.extend(from.axis.iter().map(|axis| axis + axes));
    to.order.extend(from.order.iter().map(|order| order + 1));
    let start = place.bearer * plant.params.arrangement.interval;
    to.birth.extend(from.birth.iter().map(|birth| birth + start));
    for turn in from.rotation.chunks_exact(4) {
        let [x, y, z, w] = [turn[0], turn[1], turn[2], turn[3]];
        // The quaternion of the turn about y, times this one.
        to.rotation.extend([
            half_cos * x + half_sin * z,
            half_cos * y + half_sin * w,
            half_cos * z - half_sin * x,
            half_cos * w - half_sin * y,
        ]);
    }
    to.length.extend(&from.length);
    to.radius.extend(&from.radius);
    to.mass.extend(&from.mass);
    to.moment.extend(&from.moment);
    to.twist_moment.extend(&from.twist_moment);
    to.curvature.extend(&from.curvature);
    to.rest_curvature.extend(&from.rest_curvature);
    to.stress.extend(&from.stress);
}
