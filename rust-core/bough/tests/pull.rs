//! Pulling at a grown plant: forces given in the params, and the force that holds a point.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod support;

use bough::params::{ArrangementPattern, PRESETS, Params, PointForce};
use bough::{History, grow};
use support::distance;

fn end_of(plant: &bough::Plant, segment: usize) -> [f64; 3] {
    let point = 3 * plant.segments.point[segment] as usize;
    [plant.polylines.points[point], plant.polylines.points[point + 1], plant.polylines.points[point + 2]]
}

/// On every kind of plant: turn a point by a tenth of a radian about the base, then give the force found to a fresh
/// plant: it must put the point there. Letting go restores the shape to the last bit. (A point may be held where a free
/// force would let the plant snap over; its report then says that it is not stable, and the force alone is not tried.)
#[test]
fn the_force_shown_is_the_one_that_solves_it() {
    let mut tried = 0;
    for id in ["figure-8d", "figure-13c", "figure-17c", "figure-18b", "figure-21c"] {
        let preset = PRESETS.iter().find(|preset| preset.id == id).unwrap();
        let params = Params::of_preset(preset);
        let mut history = History::new(&params).unwrap();
        let free = history.at(u32::MAX);
        let length: f64 = params.axis.segment_length * f64::from(params.axis.segments);
        for segment in [params.axis.segments as usize / 2, free.segments.parent.len() - 1] {
            let at = end_of(&free, segment);
            let place = [0.99 * at[0] - 0.1 * at[1], 0.99 * at[1] + 0.1 * at[0], 0.0];
            let held = history.hold(segment as u32, place).unwrap();
            assert!(distance(end_of(&held, segment), place) < 1e-9 * length, "{id}, segment {segment}");
            assert!(held.report.residual <= 1e-9);
            assert_eq!(history.plant(), free);
            if held.report.stable == Some(false) {
                continue;
            }
            tried += 1;
            let mut pulled = params.clone();
            pulled.loads.forces.clone_from(&held.params.loads.forces);
            let again = grow(&pulled).unwrap();
            let off = distance(end_of(&again, segment), place);
            println!(
                "{id}, segment {segment}: force {:.3?} N, off {off:.1e}",
                held.params.loads.forces[0].force
            );
            assert!(off < 1e-7 * length, "{id}, segment {segment}: {off}");
        }
    }
    assert!(tried >= 5, "only {tried} held shapes were stable by themselves");
}

/// A pointer that moves in small steps ends where one that jumps does.
#[test]
fn dragging_in_steps_ends_where_a_jump_does() {
    let params = Params::default();
    let mut history = History::new(&params).unwrap();
    let free = history.at(40);
    let [x, y, _] = free.tip(0);
    let target = [x - 0.4, y + 0.3, 0.0];
    let jumped = history.hold(39, target).unwrap();
    history.plant();
    let mut dragged = None;
    for step in 1..=20 {
        let share = f64::from(step) / 20.0;
        dragged = history.hold(39, [x - 0.4 * share, y + 0.3 * share, 0.0]);
    }
    let dragged = dragged.unwrap();
    assert!(distance(dragged.tip(0), jumped.tip(0)) < 1e-9);
    let [jump, drag] = [&jumped, &dragged].map(|plant| plant.params.loads.forces[0].force);
    assert!(distance(jump, drag) < 1e-6 * distance(jump, [0.0; 3]));
}

/// Around a stem a copy is held in its own plane; the others and the stem stay.
#[test]
fn one_axis_of_a_stem_can_be_held() {
    let mut params = Params::default();
    params.arrangement.pattern = ArrangementPattern::Stem;
    params.arrangement.count = 5;
    let mut history = History::new(&params).unwrap();
    let free = history.at(u32::MAX);
    assert!(history.hold(2, [1.0, 1.0, 1.0]).is_none(), "the stem is rigid");
    // The last segment of the third copy.
    let segment = free.segments.axis.iter().rposition(|&axis| axis == 3).unwrap();
    let at = end_of(&free, segment);
    let place = [0.8 * at[0], at[1] + 0.2, 0.8 * at[2]];
    let held = history.hold(segment as u32, place).unwrap();
    assert!(distance(end_of(&held, segment), place) < 1e-9);
    for other in 0..free.segments.axis.len() {
        let same = held.segments.moment[other] == free.segments.moment[other];
        assert_eq!(same, free.segments.axis[other] != 3, "segment {other}");
    }
    assert_eq!(history.plant(), free);
    // Every segment of every copy can be, and none of the stem.
    for (segment, &axis) in free.segments.axis.iter().enumerate() {
        assert_eq!(history.hold(segment as u32, end_of(&free, segment)).is_some(), axis > 0, "{segment}");
    }
}

/// The first segment cannot change its length: its end comes as near as it can, that is to where it is pointed.
#[test]
fn the_first_segment_turns_to_where_it_is_drawn() {
    for (space, aside) in [(false, 0.0), (true, 0.0), (true, 0.4)] {
        let mut params = Params::default();
        params.solver.space = space;
        let mut history = History::new(&params).unwrap();
        let free = history.at(40);
        let at = end_of(&free, 0);
        let length = distance(at, [0.0; 3]);
        let own = history.hold(0, at).unwrap();
        assert!(distance(end_of(&own, 0), at) < 1e-9 * length);
        history.plant();
        let aim = [at[0] - 0.5 * at[1], at[1] + 0.5 * at[0], aside * length];
        let held = history.hold(0, aim).unwrap();
        let expected = aim.map(|along| along * length / distance(aim, [0.0; 3]));
        assert!(distance(end_of(&held, 0), expected) < 1e-9 * length, "in space: {space}, {aside}");
        assert!(held.report.residual <= params.solver.tolerance);
        // Where the base itself is wanted there is no direction to point to.
        assert!(history.hold(0, [0.0; 3]).is_none());
    }
}

/// In space also out of its plane, whichever way it points.
#[test]
fn one_axis_of_a_stem_is_held_out_of_its_plane() {
    let mut params = Params::default();
    params.axis.segments = 8;
    params.solver.space = true;
    params.arrangement.pattern = ArrangementPattern::Stem;
    params.arrangement.count = 3;
    params.arrangement.interval = 0;
    params.arrangement.divergence.0 = 70.0;
    let mut history = History::new(&params).unwrap();
    let free = history.at(u32::MAX);
    for copy in 1..=3 {
        let segment = free.segments.axis.iter().rposition(|&axis| axis == copy).unwrap();
        let [x, y, z] = end_of(&free, segment);
        let (reach, foot) = (x.hypot(z), f64::from(copy) * params.arrangement.spacing);
        let place = [0.9 * x - 0.2 * z, foot + 0.9 * (y - foot), 0.9 * z + 0.2 * x];
        let held = history.hold(segment as u32, place).unwrap();
        assert!(distance(end_of(&held, segment), place) < 1e-8 * reach, "copy {copy}");
    }
}

#[test]
fn forces_are_checked_like_all_params() {
    let mut params = Params::default();
    params.loads.forces = vec![
        PointForce { segment: 2_000_000, force: [0.0, 1.0, 0.0] },
        PointForce { segment: 1, force: [f64::NAN, 1e300, 0.0] },
    ];
    let error = grow(&params).unwrap_err();
    let codes: Vec<_> = error.issues.iter().map(|issue| (issue.path, issue.code)).collect();
    let path = "loads.forces";
    assert_eq!(codes, [(path, "outOfRange"), (path, "notFinite"), (path, "outOfRange")]);
    // A segment that is not there is not pulled at.
    params.loads.forces = vec![PointForce { segment: 500, force: [0.0, 1.0, 0.0] }];
    assert_eq!(grow(&params).unwrap().polylines, grow(&Params::default()).unwrap().polylines);
    // Taken off with all other loads.
    params.loads.forces = vec![PointForce { segment: 39, force: [0.0, 1.0, 0.0] }];
    params.loads.removed = true;
    let removed = grow(&params).unwrap();
    assert!(removed.segments.moment.iter().all(|moment| *moment == 0.0));
}

/// What holds another segment, or a plant of another age, is no grip to go on from.
#[test]
fn a_grip_is_gone_on_from_only_where_it_holds() {
    let mut params = Params::default();
    for space in [false, true] {
        params.solver.space = space;
        let place = [0.3, 0.2, 0.0];
        let fresh = |step: u32, segment: u32| {
            let mut history = History::new(&params).unwrap();
            history.at(step);
            history.hold(segment, place).unwrap()
        };
        let mut history = History::new(&params).unwrap();
        history.at(30);
        history.hold(20, place).unwrap();
        assert_eq!(history.hold(12, place).unwrap(), fresh(30, 12));
        history.at(25);
        assert_eq!(history.hold(12, place).unwrap(), fresh(25, 12));
        // Held at the same segment it goes on: sooner there than from nothing.
        let [again, anew] = [history.hold(12, place).unwrap(), fresh(25, 12)];
        assert!(again.report.iterations < anew.report.iterations, "{:?}", again.report);
    }
}
