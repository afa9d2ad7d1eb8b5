//! The quick ways through chains and through trees numbered level by level, against the plain one and against sums
//! written out.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::mechanics::{Elimination, GROUND, Linkage, Loads, Settings, Status, hang};
use proptest::prelude::*;

/// Length, stiffness, rest angle, deviation and force of one rod.
type Rod = (f64, f64, f64, f64, f64, f64);

fn rods(number: core::ops::Range<usize>) -> impl Strategy<Value = Vec<Rod>> {
    prop::collection::vec((0.1..2.0, 0.1..5.0, -0.5..0.5, -0.5..0.5, -1.0..1.0, -1.0..1.0), number)
}

fn build(rods: &[Rod], weight: f64, parent: impl Fn(usize) -> u32) -> (Linkage, Loads) {
    let mut linkage = Linkage::default();
    let mut loads = Loads::none(rods.len());
    for (index, &(length, stiffness, rest, deviation, x, y)) in rods.iter().enumerate() {
        linkage.push(parent(index), length, stiffness, rest);
        linkage.deviation[index] = deviation;
        loads.x[index] = weight * x;
        loads.y[index] = weight * y;
    }
    loads.gather(&linkage);
    (linkage, loads)
}

fn chain(rod: usize) -> u32 {
    rod.checked_sub(1).map_or(GROUND, |below| below as u32)
}

/// Four axes on the ground; from the sixth level on each rod bears two until there are `widest` a level.
fn levels(widest: usize) -> impl Fn(usize) -> u32 {
    let mut parents = vec![GROUND; 4];
    let (mut start, mut width, mut level) = (0, 4, 0);
    while parents.len() < 2000 {
        level += 1;
        let forks = level % 6 == 0 && 2 * width <= widest;
        let wider = if forks { 2 * width } else { width };
        for rod in 0..wider {
            parents.push((start + rod * width / wider) as u32);
        }
        start += width;
        width = wider;
    }
    move |rod| parents[rod]
}

/// Newton's step by the quick way and by plain elimination, from the same state.
fn compare(linkage: &Linkage, loads: &Loads) -> Result<bool, TestCaseError> {
    let mut state = Elimination::default();
    state.evaluate(linkage, loads);
    let plainly_not_positive = state.eliminate(linkage, 0.0);
    let mut increment = Vec::new();
    let plainly_largest = state.newton_step(linkage, &mut increment);
    let mut moved = linkage.clone();
    let (not_positive, largest) = state.newton(&mut moved);
    prop_assert_eq!(not_positive, plainly_not_positive);
    // Two orders of elimination differ by rounding times the condition number: below 1e6 for these stiffnesses unless a
    // pivot happens to vanish, and then the turn grows with it.
    let allowed = 1e-10 * plainly_largest.max(1e-3) * (1.0 + plainly_largest);
    prop_assert!((largest - plainly_largest).abs() <= allowed, "{largest} {plainly_largest}");
    for rod in 0..linkage.len() {
        let step = moved.deviation[rod] - linkage.deviation[rod];
        prop_assert!((step - increment[rod]).abs() <= allowed, "rod {rod}: {step} {}", increment[rod]);
    }
    Ok(not_positive == 0)
}

/// Torques about every joint, each summed over all rods that it bears.
fn torques_written_out(linkage: &Linkage, loads: &Loads) -> Vec<f64> {
    let mut angle = vec![0.0; linkage.len()];
    for rod in 0..linkage.len() {
        let below = if linkage.parent[rod] == GROUND { 0.0 } else { angle[linkage.parent[rod] as usize] };
        angle[rod] = below + linkage.joint_angle(rod);
    }
    let mut torque = vec![0.0; linkage.len()];
    for rod in 0..linkage.len() {
        let (sin, cos) = angle[rod].sin_cos();
        let own = linkage.length[rod] * (cos * loads.y[rod] - sin * loads.x[rod]);
        let mut joint = rod as u32;
        while joint != GROUND {
            torque[joint as usize] += own;
            joint = linkage.parent[joint as usize];
        }
    }
    torque
}

fn compare_torques(linkage: &Linkage, loads: &Loads) -> Result<(), TestCaseError> {
    let mut state = Elimination::default();
    state.evaluate(linkage, loads);
    let expected = torques_written_out(linkage, loads);
    let size: f64 = expected.iter().map(|torque| torque.abs()).fold(1.0, f64::max);
    for rod in 0..linkage.len() {
        prop_assert!((state.torque[rod] - expected[rod]).abs() <= 1e-12 * size, "rod {rod}");
        let residual = linkage.stiffness[rod] * linkage.deviation[rod] - expected[rod];
        prop_assert!((state.residual[rod] - residual).abs() <= 1e-12 * size, "rod {rod}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(support::cases(200))]

    /// Long enough to be cut into parts, with every remainder; light and heavy, so that some Hessians are indefinite.
    #[test]
    fn a_chain_in_parts_is_the_chain(rods in rods(1..120), weight in 0.0..0.05_f64) {
        let (linkage, loads) = build(&rods, weight, chain);
        prop_assert!(linkage.is_chain());
        compare_torques(&linkage, &loads)?;
        compare(&linkage, &loads)?;
    }

    #[test]
    fn a_tree_by_levels_is_the_tree(rods in rods(8..700), weight in 0.0..0.5_f64, widest in 4..64_usize) {
        let (linkage, loads) = build(&rods, weight, levels(widest));
        compare_torques(&linkage, &loads)?;
        compare(&linkage, &loads)?;
    }
}

/// Both outcomes are met by the tests above: quick steps that are taken, and indefinite Hessians that are counted.
#[test]
fn light_rods_are_stable_and_compressed_ones_are_not() {
    let rods: Vec<Rod> = (0..100).map(|_| (1.0, 5.0, 0.0, 0.0, 1.0, 0.01)).collect();
    for (weight, stable) in [(1e-6, true), (-1.0, false)] {
        let (linkage, loads) = build(&rods, weight, chain);
        assert_eq!(compare(&linkage, &loads).ok(), Some(stable));
        let (linkage, loads) = build(&rods, weight, levels(16));
        assert_eq!(compare(&linkage, &loads).ok(), Some(stable));
    }
}

/// Where one axis ends and its neighbour forks, a level is as wide as the one before, but its rods do not stand each on its
/// counterpart: taken for such, forces would go down the wrong branch.
#[test]
fn levels_of_one_width_need_not_stand_rod_on_rod() {
    let width = 8;
    for ending in 0..width - 1 {
        // Which axis ends is the same in every fourth level, and elsewhere none does.
        let parent = |rod: usize| match (rod / width, rod % width) {
            (0, _) => GROUND,
            (level, place) => {
                let moved = usize::from(level % 4 == 3 && place == ending);
                ((level - 1) * width + place + moved) as u32
            }
        };
        let rods: Vec<Rod> = (0..10 * width)
            .map(|rod| {
                let uneven = |period: usize| (rod % period + 1) as f64 / period as f64;
                (uneven(5), 3.0 * uneven(7), 0.2 - uneven(4), 0.3 - uneven(3), uneven(6), uneven(11) - 0.5)
            })
            .collect();
        let (linkage, loads) = build(&rods, 0.01, parent);
        compare_torques(&linkage, &loads).unwrap();
        compare(&linkage, &loads).unwrap();
    }
}

/// After a small last turn what is left over is not evaluated but bounded. A rod across its load loses `t (1 - cos u)` of its
/// torque, so that there the bound `load u^2 (1/2 + u/6)` must hold and be reached but for `u/3` of it; and it is said relative
/// to the least torque that may act after the turn, `t - load u`. Loads along the rods are counted as if they were across.
#[test]
fn what_is_proven_to_be_left_is_no_less_and_hardly_more_than_what_is() {
    for rods in 1..10_usize {
        for along in [0.0, -0.3, 0.2] {
            let (mut linkage, mut loads) = (Linkage::default(), Loads::none(rods));
            let (mut torque, mut load) = (0.0, 0.0);
            for rod in 0..rods {
                let length = 3.0 / (rod + 1) as f64;
                // Only the base gives way, so that all rods turn as far.
                let stiffness = if rod == 0 { 4e4 } else { 1e14 };
                linkage.push(chain(rod), length, stiffness, 0.0);
                // As gathered loads are, larger towards the base.
                loads.y[rod] = 5.0 / rods as f64 * (rods - rod) as f64;
                loads.x[rod] = along * loads.y[rod];
                torque += length * loads.y[rod];
                load += length * (loads.x[rod].abs() + loads.y[rod].abs());
            }
            let outcome = hang(&mut linkage, &loads, Settings { tolerance: 1e-5 });
            assert_eq!((outcome.status, outcome.iterations), (Status::Converged, 1));
            let turn = linkage.deviation[0];
            assert!((1e-4..1e-3).contains(&turn), "{turn}");
            let mut state = Elimination::default();
            state.evaluate(&linkage, &loads);
            let left = state.largest_residual();
            let proven = outcome.residual * (torque - load * turn);
            // The other joints turn by some 1e-13; rounding leaves 1e-16 of the torque, of which 1e-8 and more is left over. A
            // load along the rods leaves u^3/6 of its own, less than the u/3 between the bound and what is left.
            let across = proven / left * torque / load;
            assert!(
                (1.0..1.0 + turn).contains(&across),
                "{rods} rods, {along}: {across} at a turn of {turn}"
            );
        }
    }
}

/// As the contract has them: what was called so must be called so for ever.
#[test]
fn ways_to_end_are_called_as_promised() {
    let all = [Status::Converged, Status::Budget, Status::MaxIterations, Status::NonFinite];
    assert_eq!(all.map(Status::name), ["converged", "budget", "maxIterations", "nonFinite"]);
}
