//! Growth within a given amount of work: what a host needs to keep a deadline.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

use bough::mechanics::Status;
use bough::params::{ArrangementPattern, Method, Params, Stepping, Thickening};
use bough::{History, grow};

/// Every kind of growth.
fn kinds() -> Vec<Params> {
    let mut kinds = vec![Params::default(); 5];
    kinds[1].growth.thickening = Thickening::Pipes;
    kinds[2].arrangement.pattern = ArrangementPattern::Stem;
    kinds[3].solver.stepping = Stepping::Static;
    kinds[4].solver.method = Method::Euler;
    kinds[4].axis.segments = 6;
    kinds
}

#[test]
fn what_was_stopped_is_the_last_finished_step_and_says_so() {
    for params in kinds() {
        let mut history = History::new(&params).unwrap();
        let mut work = 1;
        let mut stops = 0;
        while !history.reach(u32::MAX, work) {
            let stopped = history.plant();
            assert_eq!(stopped.report.status, Status::Budget);
            assert_eq!(stopped.report.steps, history.step());
            if history.step() > 0 {
                let mut finished = History::new(&params).unwrap().at(history.step());
                finished.report.status = Status::Budget;
                assert_eq!(stopped, finished);
            }
            assert_eq!(history.plant(), stopped, "asked once more");
            work *= 2;
            stops += 1;
        }
        assert!(stops > 3);
        assert_eq!(history.plant(), grow(&params).unwrap());
    }
}

/// A thread of a kilometre that seeks upwards: some steps take dozens of iterations.
#[test]
fn a_step_is_given_up_in_its_midst() {
    let mut params = Params::default();
    params.axis.segments = 5;
    params.axis.segment_length = 231.0;
    params.tropism.strength = 1e9;
    params.solver.tolerance = 1e-15;
    let whole = grow(&params).unwrap();
    assert!(whole.report.iterations > 5 * 12, "{} iterations are not many", whole.report.iterations);
    let mut history = History::new(&params).unwrap();
    let mut given_up = 0;
    for step in 1..=5 {
        // Ten iterations of each.
        if !history.reach(step, u64::from(10 * step)) {
            assert_eq!(history.step(), step - 1);
            given_up += 1;
        }
        assert!(history.seek(step, u64::MAX));
    }
    assert!(given_up > 0);
    assert_eq!(history.plant(), whole);
}

/// It stood at no step at all, with the wood of the step that was given up.
#[test]
fn static_growth_that_is_given_up_stands_where_it_stood() {
    let mut params = Params::default();
    params.solver.stepping = Stepping::Static;
    let mut history = History::new(&params).unwrap();
    let before = history.at(5);
    assert!(!history.reach(30, 1));
    let stopped = history.plant();
    assert_eq!((stopped.report.steps, stopped.report.status), (5, Status::Budget));
    assert_eq!(stopped.polylines, before.polylines);
}

/// Asked for an age before its own, it stayed where it was, for all that any test saw.
#[test]
fn an_earlier_age_is_reached_too_from_the_midst_of_a_step_or_not() {
    for params in kinds() {
        let early = History::new(&params).unwrap().at(2);
        let mut history = History::new(&params).unwrap();
        history.at(5);
        assert!(history.reach(2, u64::MAX));
        assert_eq!(history.plant(), early);
        // A relaxation that has begun is underway between its slices.
        history.seek(4, 1);
        assert!(history.reach(2, u64::MAX));
        assert_eq!(history.plant(), early);
    }
}
