//! Left and right are alike: the mirrored input gives the mirrored plant, to the last bit.

use bough::Plant;
use bough::params::Params;

use super::{grow, planar};

/// Whether params that are mirror images differ in nothing that has a side.
fn is_own_image(params: &Params, mirrored: &Params) -> bool {
    params.axis.elevation == mirrored.axis.elevation
        && params.tropism.elevation == mirrored.tropism.elevation
        && params.axis.rest_curvature == 0.0
        && params.loads.tip_force[0] == 0.0
        && params.loads.wind == 0.0
        && params.loads.forces.iter().all(|pull| pull.force[0] == 0.0)
}

/// Panics if the plant of the mirrored params is not the mirrored plant.
pub fn check_mirrored(params: &Params) {
    let Some(params) = planar(params.clone()) else { return };
    let mut mirrored = params.clone();
    for elevation in [&mut mirrored.axis.elevation.0, &mut mirrored.tropism.elevation.0] {
        *elevation = if *elevation < 0.0 { -180.0 - *elevation } else { 180.0 - *elevation };
    }
    mirrored.branching.roll.0 = 180.0 - params.branching.roll.0;
    mirrored.axis.rest_curvature *= -1.0;
    mirrored.loads.tip_force[0] *= -1.0;
    mirrored.loads.wind_azimuth.0 = 180.0 - params.loads.wind_azimuth.0;
    for pull in &mut mirrored.loads.forces {
        pull.force[0] *= -1.0;
    }
    let (plant, image) = (grow(&params).unwrap(), grow(&mirrored).unwrap());
    // What is its own mirror image and cannot stand has to lean to some side, and both lean to the same.
    if is_own_image(&params, &mirrored) && plant.report.self_buckling.is_some_and(|share| share > 1.0) {
        assert_eq!(plant.polylines.points, image.polylines.points);
        return;
    }
    let opposed: [fn(&Plant) -> &[f64]; 3] = [
        |plant| &plant.segments.moment,
        |plant| &plant.segments.curvature,
        |plant| &plant.segments.rest_curvature,
    ];
    for array in opposed {
        for (segment, (here, there)) in array(&plant).iter().zip(array(&image)).enumerate() {
            assert!(here == &-there, "segment {segment}: {here} and {there}: {params:?}");
        }
    }
    assert_eq!(plant.segments.stress, image.segments.stress);
    assert_eq!(plant.report.status, image.report.status);
    assert_eq!(plant.report.stable, image.report.stable);
    let places = plant.polylines.points.chunks_exact(3).zip(image.polylines.points.chunks_exact(3));
    for (here, there) in places {
        // Places follow from angles by sines and cosines, whose roundings are mirrored as well.
        assert!(here[0] == -there[0] && here[1] == there[1], "{here:?} and {there:?}: {params:?}");
    }
}
