//! What the tests of plants in space share.

use bough::Plant;
use bough::angle::Degrees;
use bough::params::{BranchingPattern, Params, PointForce, Thickening};

#[path = "../soundness/forces.rs"]
mod forces;

use super::distance;
use forces::forces;

pub(crate) fn points(plant: &Plant) -> impl Iterator<Item = [f64; 3]> {
    plant.polylines.points.chunks_exact(3).map(|point| [point[0], point[1], point[2]])
}

pub(crate) fn turned([x, y, z]: [f64; 3], degrees: f64) -> [f64; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x * cos + z * sin, y, z * cos - x * sin]
}

/// Length of a plant, along its longest axis and everything that bears it.
pub(crate) fn length(plant: &Plant) -> f64 {
    let mut reach = vec![0.0_f64; plant.segments.parent.len()];
    for segment in 0..reach.len() {
        let below = usize::try_from(plant.segments.parent[segment]).map_or(0.0, |parent| reach[parent]);
        reach[segment] = below + plant.segments.length[segment];
    }
    reach.into_iter().fold(0.0, f64::max)
}

/// Farthest that a point of one plant is from where the other, turned, has it.
pub(crate) fn apart(plant: &Plant, other: &Plant, degrees: f64) -> f64 {
    let pairs = points(plant).zip(points(other));
    pairs.map(|(here, there)| distance(here, turned(there, degrees))).fold(0.0, f64::max)
}

/// Forks that stand crosswise, wood that bends aside and twists, a fruit, light from one side.
pub(crate) fn bush() -> Params {
    let mut params = all_planar();
    params.branching.roll = Degrees(80.0);
    params.branching.generations = 3;
    params.axis.segments = 8;
    params.axis.rest_curvature_roll = Degrees(40.0);
    params.axis.rest_twist = 1.5;
    params.loads.tip_force = [0.0; 3];
    params.loads.forces.clear();
    params
}

/// The base bears the moment of all forces at the shape shown.
pub(crate) fn assert_held(plant: &Plant) {
    let expected = base_moment(plant);
    let segments = &plant.segments;
    let found = f64::hypot(segments.moment[0], segments.twist_moment[0]);
    let largest = segments.moment.iter().fold(0.0_f64, |most, moment| most.max(moment.abs()));
    assert!((found - expected).abs() <= 1e-9 * largest.max(1e-300), "{found} {expected}");
}

/// Size of the moment of all forces about the base, N m.
pub(crate) fn base_moment(plant: &Plant) -> f64 {
    let mut about = [0.0_f64; 3];
    for (segment, [fx, fy, fz]) in forces(plant, true).0.into_iter().enumerate() {
        let point = 3 * plant.segments.point[segment] as usize;
        let [x, y, z] = [0, 1, 2].map(|axis| plant.polylines.points[point + axis]);
        about[0] += y * fz - z * fy;
        about[1] += z * fx - x * fz;
        about[2] += x * fy - y * fx;
    }
    about[0].hypot(about[1]).hypot(about[2])
}

/// A plant with every kind of load, growth and bend that a plane can have.
pub(crate) fn all_planar() -> Params {
    let mut params = Params::default();
    params.axis.segments = 12;
    params.axis.elevation = Degrees(35.0);
    params.axis.rest_curvature = -0.8;
    params.axis.rest_curvature_roll = Degrees(180.0);
    params.tropism.elevation = Degrees(70.0);
    params.tropism.strength = 2.0;
    params.growth.thickening = Thickening::Pipes;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 2;
    params.branching.girth_ratio = 0.7;
    params.branching.roll = Degrees(180.0);
    params.axis.radius = 0.002;
    params.material.youngs_modulus = 3e9;
    params.loads.tip_mass = 0.002;
    params.loads.tip_force = [0.01, 0.02, 0.0];
    params.loads.forces = vec![PointForce { segment: 20, force: [0.05, -0.1, 0.0] }];
    params.solver.tolerance = 1e-13;
    params
}
