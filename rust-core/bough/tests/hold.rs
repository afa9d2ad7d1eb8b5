//! Holding a point: the force found is the one that, applied, puts the point there.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod support;

use bough::mechanics::{GROUND, Linkage, Loads, Settings, Status, Workspace, hang, hold, settle};
use proptest::prelude::*;

const SETTINGS: Settings = Settings { tolerance: 1e-12 };

/// A rod of length 1 that weighs `q`, EI = 1.
fn rod(segments: usize, q: f64) -> (Linkage, Loads) {
    let length = 1.0 / segments as f64;
    let mut linkage = Linkage::default();
    let mut loads = Loads::none(segments);
    for segment in 0..segments {
        let parent = if segment == 0 { GROUND } else { segment as u32 - 1 };
        linkage.push(parent, length, 1.0 / length, 0.0);
        loads.y[segment] = -q * length;
    }
    loads.gather(&linkage);
    (linkage, loads)
}

fn end(linkage: &Linkage, rod: usize) -> [f64; 2] {
    let mut angles = Vec::new();
    linkage.angles(&mut angles);
    (0..=rod).fold([0.0, 0.0], |[x, y], rod| {
        let (sin, cos) = libm::sincos(angles[rod]);
        [x + linkage.length[rod] * cos, y + linkage.length[rod] * sin]
    })
}

proptest! {
    #![proptest_config(support::cases(300))]

    #[test]
    fn the_force_found_is_the_one_that_solves_it(
        segments in 3_usize..40, q in 0.2..5.0, at in 0.3..1.0, x in 0.2..0.9, angle in -1.2..1.2,
    ) {
        let (mut linkage, loads) = rod(segments, q);
        hang(&mut linkage, &loads, SETTINGS);
        let resting = linkage.clone();
        let rod = ((segments - 1) as f64 * at) as usize;
        let reach = (rod + 1) as f64 / segments as f64;
        // One or two rods reach only a circle, or fold.
        prop_assume!(rod >= 2);
        let (sin, cos) = libm::sincos(angle);
        let wanted = [reach * x * cos, reach * x * sin];
        let held = hold(&mut linkage, &loads, rod, wanted, [0.0, 0.0], SETTINGS);
        prop_assert_eq!(held.outcome.status, Status::Converged);
        let found = end(&linkage, rod);
        prop_assert!((found[0] - wanted[0]).abs() < 2e-10 && (found[1] - wanted[1]).abs() < 2e-10);
        // The held shape is an equilibrium of the loads and the force, by an independent evaluation.
        let mut pulled = loads.clone();
        for on_path in 0..=rod {
            pulled.x[on_path] += held.force[0];
            pulled.y[on_path] += held.force[1];
        }
        let again = settle(&mut linkage.clone(), &pulled, &pulled, &[], SETTINGS, &mut Workspace::default());
        prop_assert!(again.residual <= 1e-9);
        // Letting go restores the shape, when the pull did not take it to another branch.
        let mut released = linkage.clone();
        settle(&mut released, &pulled, &loads, &[], SETTINGS, &mut Workspace::default());
        let (rest, back) = (end(&resting, segments - 1), end(&released, segments - 1));
        prop_assert!((rest[0] - back[0]).abs() < 1e-9 && (rest[1] - back[1]).abs() < 1e-9);
    }
}

#[test]
fn a_place_out_of_reach_is_approached() {
    let (mut linkage, loads) = rod(20, 1.0);
    hang(&mut linkage, &loads, SETTINGS);
    let held = hold(&mut linkage, &loads, 19, [5.0, 3.0], [0.0, 0.0], SETTINGS);
    assert_eq!(held.outcome.status, Status::Converged);
    let [x, y] = held.place;
    assert!((libm::hypot(x, y) - 0.998).abs() < 1e-9 && (y / x - 0.6).abs() < 1e-9);
}
