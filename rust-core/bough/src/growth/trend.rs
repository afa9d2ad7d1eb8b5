//! What to expect of the next growth step: old wood moves smoothly.

/// By how much each joint's deviation changed in the last two steps.
#[derive(Clone, Debug, Default)]
pub(super) struct Trend {
    last: Vec<f64>,
    before_last: Vec<f64>,
}

impl Trend {
    /// The changes expected in the next step, for the joints that took part in the last one: the last changes, carried on
    /// in a straight line.
    pub(super) fn next(&self) -> Vec<f64> {
        let earlier = self.before_last.iter().map(Some).chain(core::iter::repeat(None));
        let carried_on = |(last, earlier): (&f64, Option<&f64>)| match earlier {
            Some(earlier) => 2.0 * last - earlier,
            None => *last,
        };
        self.last.iter().zip(earlier).map(carried_on).collect()
    }

    /// Takes down what a step has changed.
    pub(super) fn note(&mut self, before: &[f64], after: &[f64]) {
        self.before_last = core::mem::take(&mut self.last);
        self.last.extend(before.iter().zip(after).map(|(before, after)| after - before));
    }
}
