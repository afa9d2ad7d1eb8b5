//! What to expect of the next growth step: old wood moves smoothly.

use alloc::vec::Vec;

use crate::mechanics::{carry_on, differences};

/// By how much each joint's deviation changed in the last two steps.
#[derive(Clone, Debug, Default)]
pub(super) struct Trend {
    last: Vec<f64>,
    before_last: Vec<f64>,
}

impl Trend {
    /// Writes the changes expected in the next step, for the joints that took part in the last one: the last changes,
    /// carried on in a straight line.
    pub(super) fn expect(&self, changes: &mut Vec<f64>) {
        changes.clone_from(&self.last);
        carry_on(changes, &self.before_last);
    }

    /// Takes down what a step has changed.
    pub(super) fn note(&mut self, before: &[f64], after: &[f64]) {
        core::mem::swap(&mut self.before_last, &mut self.last);
        self.last.resize(before.len(), 0.0);
        differences(after, before, &mut self.last);
    }
}
