//! Every way to an age leads to the same bits.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

use bough::params::{BranchingPattern, Params, Stepping, Thickening};
use bough::{Growth, History};

/// Stiff and soft, exact, static and extrapolated, an axis and a tree: the ages in some order, each against a fresh start.
#[test]
fn an_age_is_the_same_whichever_way_it_is_reached() {
    for stepping in [Stepping::Exact, Stepping::Static, Stepping::Extrapolated] {
        for modulus in [1e8, 1e9, 1e13] {
            for (segments, forks) in [(150, 0), (40, 0), (12, 3)] {
                let mut params = Params::default();
                params.axis.segments = segments;
                params.axis.segment_length = 1.5 / f64::from(segments);
                params.material.youngs_modulus = modulus;
                params.growth.thickening = Thickening::Pipes;
                params.axis.radius = 0.0127 / f64::from(segments).sqrt();
                params.tropism.strength = 0.5;
                params.solver.stepping = stepping;
                params.branching.generations = forks;
                if forks > 0 {
                    params.branching.pattern = BranchingPattern::Bifurcation;
                }
                let mut history = History::new(&params).unwrap();
                let steps = history.steps();
                for step in [steps - 1, steps, steps / 2, 17, 16, 15, steps / 2 + 1, steps - 2, steps] {
                    let fresh = History::new(&params).unwrap().at(step);
                    assert_eq!(history.at(step), fresh, "{stepping:?}, {segments} segments, step {step}");
                }
            }
        }
    }
}

/// A fault that random params found: steps that did not converge counted how often sines had been turned before a return.
#[test]
fn an_age_that_did_not_converge_is_the_same_too() {
    let mut params = Params::default();
    params.axis.segments = 6;
    params.axis.segment_length = 1.0;
    params.axis.radius = 3.6e-6;
    params.axis.elevation = bough::angle::Degrees(76.0);
    params.material.youngs_modulus = 1.0;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 1;
    params.loads.gravity = 1e6;
    params.loads.tip_force = [-1e12, 0.0, 0.0];
    params.solver.tolerance = 1e-14;
    let mut history = History::new(&params).unwrap();
    for step in [7, 2, 3, 4, 9, 5, 8] {
        let fresh = History::new(&params).unwrap().at(step);
        assert_eq!(history.at(step), fresh, "step {step}");
    }
}

/// A forked axis of two segments and two generations: its segments, step by step, with those that the solver puts between.
#[test]
fn a_growing_plant_counts_its_segments() {
    let mut params = Params::default();
    params.axis.segments = 2;
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 1;
    let mut growth = Growth::new(&params).unwrap();
    assert_eq!((growth.segments(), growth.steps_taken()), (0, 0));
    while growth.step() {
        let shown = growth.plant().segments.parent.len();
        assert!(growth.segments() >= shown && shown >= growth.steps_taken() as usize);
    }
    assert_eq!(growth.plant().segments.parent.len(), 2 + 2 * 2);
}
