//! The paper's relaxation as a record in time.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::mechanics::Status;
use bough::{grow, relaxation};
use support::{heavy_rod, piped_rod};

#[test]
fn the_record_ends_in_the_equilibrium_and_starts_before_it() {
    for params in [heavy_rod(50.0, 10.0, 20), piped_rod(50.0, 2.0, 20)] {
        let plant = grow(&params).unwrap();
        let record = relaxation(&params, 20).unwrap();
        assert_eq!((record.outcome.status, record.segments), (Status::Converged, 20));
        assert!(record.time.windows(2).all(|pair| pair[1] > pair[0]));
        assert_eq!(record.angle.len(), 20 * record.time.len());
        assert_eq!(record.velocity.len(), 20 * record.time.len());
        assert!(record.time.len() <= 512 && record.time.len() > 100);
        assert!(record.velocity[..20].iter().all(|velocity| *velocity == 0.0));
        // Joints move: the record is not of a plant at rest.
        assert!(record.velocity.iter().any(|velocity| velocity.abs() > 1e-3));
        let last = &record.angle[record.angle.len() - 20..];
        for (segment, angle) in last.iter().enumerate() {
            let turn = &plant.segments.rotation[4 * segment..];
            let settled = 2.0 * turn[2].atan2(turn[3]);
            assert!((angle - settled).abs() < 1e-8, "segment {segment}: {angle} {settled}");
        }
        // Without the new segment's weight the shape was that of the step before.
        let before = bough::History::new(&params).unwrap().at(19);
        for segment in 0..19 {
            let turn = &before.segments.rotation[4 * segment..];
            assert!((record.angle[segment] - 2.0 * turn[2].atan2(turn[3])).abs() < 1e-8);
        }
    }
}

#[test]
fn plants_too_large_to_record_are_refused_at_once() {
    let params = heavy_rod(50.0, 10.0, 3000);
    let error = relaxation(&params, 3000).unwrap_err();
    assert_eq!(
        error.to_string(),
        "axis.segments must leave at most 2000 segments where a relaxation is recorded; there are 3000."
    );
    assert!(relaxation(&params, 3).is_ok());
}
