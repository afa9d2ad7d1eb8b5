//! The forces on a plant once more, from its result arrays alone.

use bough::Plant;
use bough::growth::{AIR, wind, wind_force};
use bough::params::{ArrangementPattern, Discretization};

/// Force at the distal end of every segment, x, y, z in N, and the size of all forces that these are sums of. `pulled` says
/// whether forces pull at segments. What the ground bears is left out.
pub(crate) fn forces(plant: &Plant, pulled: bool) -> (Vec<[f64; 3]>, f64) {
    let (loads, segments) = (&plant.params.loads, &plant.segments);
    let count = segments.parent.len();
    let mut force = vec![[0.0; 3]; count];
    let mut size = 0.0;
    let mut act = |segment: usize, more: [f64; 3]| {
        let mut size = 0.0;
        if let Some(force) = force.get_mut(segment) {
            for axis in 0..3 {
                force[axis] += more[axis];
                size += more[axis].abs();
            }
        }
        size
    };
    if !loads.removed {
        let half = if plant.params.solver.discretization == Discretization::Paper { 0.0 } else { 0.5 };
        let mut is_tip = vec![true; count];
        for segment in 0..count {
            let (along, parts) = evenly(plant, segment);
            size += parts;
            act(segment, along.map(|force| (1.0 - half) * force));
            if let Ok(bearer) = usize::try_from(segments.parent[segment]) {
                act(bearer, along.map(|force| half * force));
                is_tip[bearer] = false;
            }
        }
        for tip in (0..count).filter(|&segment| is_tip[segment] && !loads.picked) {
            size += act(tip, [0.0, -loads.tip_mass * loads.gravity, 0.0]);
        }
        let tip_of = |axis: u32| (0..count).rev().find(|&segment| segments.axis[segment] == axis);
        if plant.params.arrangement.pattern == ArrangementPattern::FlexibleStem {
            let mut tips: Vec<(u32, usize)> = (0..count)
                .filter(|&segment| segments.order[segment] == 1)
                .map(|segment| (segments.axis[segment], segment))
                .collect();
            tips.sort_unstable();
            tips.dedup_by_key(|(axis, _)| *axis);
            for (copy, (axis, _)) in tips.into_iter().enumerate() {
                let turn =
                    plant.params.axis.azimuth.0 + copy as f64 * plant.params.arrangement.divergence.0 % 360.0;
                let (sin, cos) = turn.to_radians().sin_cos();
                let [x, y, z] = loads.tip_force;
                size += act(tip_of(axis).unwrap_or(count), [x * cos + z * sin, y, z * cos - x * sin]);
            }
        } else {
            size += act(tip_of(0).unwrap_or(count), loads.tip_force);
        }
    }
    for pull in loads.forces.iter().filter(|_| pulled) {
        size += act(pull.segment as usize, pull.force);
    }
    (force, size)
}

/// What lies and pushes evenly along a segment: its wood, its leaves, snow and wind on both, N; and the size of these parts, which
/// may cancel.
fn evenly(plant: &Plant, segment: usize) -> ([f64; 3], f64) {
    let (params, segments) = (&plant.params, &plant.segments);
    let loads = &params.loads;
    let length = segments.length[segment];
    let point = 3 * segments.point[segment] as usize;
    let points = &plant.polylines.points;
    let direction = [0, 1, 2].map(|axis| (points[point + axis] - points[point - 3 + axis]) / length);
    let is_young = plant.report.steps - segments.birth[segment] < loads.foliage_age;
    let leaves = if is_young { loads.foliage * length } else { 0.0 };
    let area = leaves * loads.foliage_area;
    let shown = 2.0 * segments.radius[segment] * length;
    let mut force = wind_force(wind(params), direction, loads.drag_coefficient * shown);
    let mut size: f64 = force.iter().map(|part| part.abs()).sum();
    for (force, wind) in force.iter_mut().zip(wind(params)) {
        let on_leaves = 0.5 * AIR * loads.foliage_drag * area * loads.wind * wind;
        *force += on_leaves;
        size += on_leaves.abs();
    }
    let snow = loads.snow * (shown * direction[0].hypot(direction[2]) + area);
    let weight = (segments.mass[segment] + leaves + snow) * loads.gravity;
    force[1] -= weight;
    (force, size + weight)
}
