//! Whether a plant is what its report says.

use bough::Plant;
use bough::mechanics::Status;
use bough::params::ArrangementPattern;

use super::statics::{CLEARLY, Statics};

/// Most rods whose Hessian is factorised densely.
const MOST_DENSE: usize = 24;

/// Panics if the plant breaks a promise.
pub fn check_plant(plant: &Plant) {
    check_shape(plant);
    if !is_stem(plant) {
        let pulled = !plant.params.loads.removed;
        check_equilibrium(plant, Statics::of(plant, pulled));
    }
}

/// As [`check_plant`], of a plant that is held: the hand's force acts even where all loads are taken off.
pub fn check_held(plant: &Plant) {
    check_shape(plant);
    assert_eq!(plant.params.loads.forces.len(), 1);
    if !is_stem(plant) {
        check_equilibrium(plant, Statics::of(plant, true));
    }
}

/// As [`check_plant`], but for its statics.
pub fn check_shape(plant: &Plant) {
    check_structure(plant);
    check_numbers(plant);
    check_report(plant);
}

/// Arrays of the right lengths, indices that lead somewhere, parents before children.
fn check_structure(plant: &Plant) {
    let (lines, segments) = (&plant.polylines, &plant.segments);
    let (points, axes, count) = (lines.radii.len(), lines.offsets.len() - 1, segments.parent.len());
    assert_eq!(lines.points.len(), 3 * points);
    assert_eq!(points, count + axes, "k segments have k + 1 points");
    assert_eq!((lines.offsets[0], lines.offsets[axes] as usize), (0, points));
    assert!(lines.offsets.windows(2).all(|pair| pair[0] < pair[1]));
    let lengths = [&segments.length, &segments.radius, &segments.mass, &segments.moment, &segments.stress];
    let more = [&segments.twist_moment, &segments.curvature, &segments.rest_curvature];
    assert!(lengths.into_iter().chain(more).all(|array| array.len() == count));
    assert_eq!(segments.rotation.len(), 4 * count);
    let mut seen = vec![false; points];
    for segment in 0..count {
        assert!((-1..segment as i32).contains(&segments.parent[segment]));
        let (axis, point) = (segments.axis[segment] as usize, segments.point[segment]);
        assert!((lines.offsets[axis] + 1..lines.offsets[axis + 1]).contains(&point));
        assert!(!core::mem::replace(&mut seen[point as usize], true), "two segments end in one point");
        let from = 3 * (point as usize - 1);
        let bearer = usize::try_from(segments.parent[segment]).ok();
        if let Some(bearer) = bearer.filter(|&bearer| segments.axis[bearer] as usize != axis) {
            let attached = 3 * segments.point[bearer] as usize;
            assert_eq!(lines.points[from..from + 3], lines.points[attached..attached + 3]);
            assert!(segments.birth[bearer] <= segments.birth[segment]);
        }
        check_direction(plant, segment, from);
    }
}

/// A segment is as long as it says, and points where its rotation turns +x to.
fn check_direction(plant: &Plant, segment: usize, from: usize) {
    let (points, segments) = (&plant.polylines.points, &plant.segments);
    let [qx, qy, qz, qw] = segments.rotation[4 * segment..4 * segment + 4] else { unreachable!() };
    let direction = [1.0 - 2.0 * (qy * qy + qz * qz), 2.0 * (qx * qy + qz * qw), 2.0 * (qx * qz - qy * qw)];
    let to = 3 * segments.point[segment] as usize;
    let length = segments.length[segment];
    let winding: f64 =
        segments.curvature.iter().zip(&segments.length).map(|(bend, length)| (bend * length).abs()).sum();
    for axis in 0..3 {
        let way = points[to + axis] - points[from + axis];
        // A dozen roundings, and those of the places' own digits; of an axis that winds up, those of its many turns.
        let allowed =
            1e-14 * (1.0 + winding) * (length + points[to + axis].abs() + points[from + axis].abs());
        assert!((way - length * direction[axis]).abs() <= allowed, "segment {segment}, axis {axis}");
    }
}

/// All that is drawn is finite whatever happened; all else is, too, unless the report says otherwise.
fn check_numbers(plant: &Plant) {
    let (lines, segments) = (&plant.polylines, &plant.segments);
    for array in [&lines.points, &lines.radii, &segments.rotation, &segments.length, &segments.mass] {
        assert!(array.iter().all(|number| number.is_finite()), "{:?}", plant.report);
    }
    assert!(lines.radii.iter().chain(&segments.mass).all(|&number| number >= 0.0));
    assert!(segments.length.iter().all(|&length| length > 0.0));
    if plant.report.status == Status::Converged {
        let bending = [&segments.moment, &segments.curvature, &segments.rest_curvature, &segments.stress];
        assert!(bending.into_iter().flatten().all(|number| number.is_finite()), "{:?}", plant.report);
        assert!(plant.report.residual.is_finite(), "{plant:?}");
        assert!(plant.report.gravity_number.is_finite(), "{plant:?}");
    }
}

fn check_report(plant: &Plant) {
    let report = &plant.report;
    assert!(!report.residual.is_nan() && report.residual >= 0.0, "{report:?}");
    if report.status != Status::Budget {
        assert_eq!(report.stable.is_some(), report.status == Status::Converged, "{plant:?}");
    }
    assert!(report.unstable_since.is_none_or(|step| (1..=report.steps).contains(&step)), "{report:?}");
    assert!(
        plant.segments.birth.iter().all(|birth| (1..=report.steps.max(1)).contains(birth)) || is_stem(plant)
    );
    assert!(report.stepping_error.is_none_or(|error| error >= 0.0), "{report:?}");
}

/// The segments of a stem are born with the axes that it bears.
fn is_stem(plant: &Plant) -> bool {
    plant.params.arrangement.pattern == ArrangementPattern::Stem
}

fn check_equilibrium(plant: &Plant, statics: Statics) {
    let report = &plant.report;
    if report.status == Status::NonFinite {
        return;
    }
    statics.check_springs();
    if report.stable.is_none() {
        return;
    }
    let (left, torque, rounding) = (statics.residual(), statics.largest_torque(), statics.rounding());
    let tolerance = plant.params.solver.tolerance;
    assert!(left <= tolerance * torque + rounding, "{left} of {torque} is left over: {plant:?}");
    assert!(left <= report.residual * torque + rounding, "{left} of {torque} is left over: {plant:?}");
    if statics.rods() > MOST_DENSE {
        return;
    }
    if let Some(pivot) = statics.smallest_pivot() {
        match report.stable {
            Some(true) => assert!(pivot > -CLEARLY, "not stable, pivot {pivot}: {plant:?}"),
            _ => assert!(pivot < CLEARLY, "stable after all, pivot {pivot}: {plant:?}"),
        }
    }
    if report.stable == Some(true) {
        // One rod after another alone, all beyond a joint together, and all alternating.
        for chosen in 0..statics.rods() {
            for size in [1e-4, -1e-4] {
                let turns: [&dyn Fn(usize) -> f64; 3] = [
                    &|rod| if rod == chosen { size } else { 0.0 },
                    &|rod| if rod >= chosen { size } else { 0.0 },
                    &|rod| if (rod / (chosen + 1)) % 2 == 0 { size } else { -size },
                ];
                for turn in turns {
                    let (rise, allowed) = statics.rise(turn);
                    assert!(rise >= -allowed, "energy falls by {rise} ({allowed}): {plant:?}");
                }
            }
        }
    }
}
