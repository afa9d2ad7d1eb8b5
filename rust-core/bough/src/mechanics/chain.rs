//! Newton's increment of an unbranched chain of rods, in four parts side by side.
//!
//! Eliminated from the tip to the base, every rod waits for the division of the one before it. Here the chain is cut
//! into four parts of one length and they are eliminated in lock step, so that divisions overlap and compilers make
//! vector code (Wang, ACM Trans. Math. Softw. 7, 1981). The last rod of each part is a separator: seen from it the part
//! is clamped there, what it would pass on per turn of the separator is carried along as one more right-hand side (the
//! spike), and a system of three unknowns is left over for the separators.
//!
//! All pivots, the separators' included, are those of one block elimination of the Hessian: all are positive exactly when
//! the Hessian is positive definite.

use alloc::vec::Vec;

use core::array::from_fn;

/// How many parts there are: enough to hide the latency of a division.
const PARTS: usize = 4;
/// Shortest chain for which cutting pays.
pub(super) const SHORTEST: usize = 16;

type Lanes = [f64; PARTS];

/// Buffers, kept between uses. Entry i belongs to the i-th rod of every part.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts {
    /// Increment of each joint but for the turns of the separator and of the rod below.
    step: Vec<Lanes>,
    /// Share of the turn of the rod below that each joint gives back.
    slack: Vec<Lanes>,
    /// Increment of each joint for a unit of torque from the separator.
    spike: Vec<Lanes>,
}

/// What a rod passes on to its parent.
#[derive(Clone, Copy)]
struct Passed {
    /// Stiffness of everything from its joint on, in series.
    excess: f64,
    /// Torque.
    carried: f64,
}

/// The arrays of a chain, from the base to the tip.
#[derive(Clone, Copy)]
pub(super) struct Chain<'a> {
    pub(super) stiffness: &'a [f64],
    /// Diagonal of the load's Hessian.
    pub(super) geometric: &'a [f64],
    /// Torque left over at each base joint.
    pub(super) residual: &'a [f64],
}

impl Chain<'_> {
    /// Splits the arrays among the parts; a remainder of up to three rods at the tip is left out.
    fn parts(array: &[f64]) -> [&[f64]; PARTS] {
        let rods = array.len() / PARTS;
        from_fn(|part| &array[part * rods..(part + 1) * rods])
    }
}

/// As [`Chain::parts`], to write to, with the remainder.
fn parts_mut(array: &mut [f64]) -> ([&mut [f64]; PARTS], &mut [f64]) {
    let rods = array.len() / PARTS;
    let (first, rest) = array.split_at_mut(rods);
    let (second, rest) = rest.split_at_mut(rods);
    let (third, rest) = rest.split_at_mut(rods);
    let (fourth, remainder) = rest.split_at_mut(rods);
    ([first, second, third, fourth], remainder)
}

impl Parts {
    /// Adds Newton's increment to every deviation, writes the turn of every rod, and returns the largest. `None`, with
    /// nothing written, where the Hessian is not positive definite or a number is not finite. O(n).
    pub(super) fn newton(&mut self, chain: Chain, deviation: &mut [f64], turn: &mut [f64]) -> Option<f64> {
        let last = chain.stiffness.len() / PARTS - 1;
        for array in [&mut self.step, &mut self.slack, &mut self.spike] {
            array.resize(last + 1, [0.0; PARTS]);
        }
        let stiffness = Chain::parts(chain.stiffness);
        let geometric = Chain::parts(chain.geometric);
        let residual = Chain::parts(chain.residual);
        let mut least = f64::INFINITY;

        // The remainder and the last rod of the last part, one by one: nothing lies beyond the tip.
        let mut passed = Passed { excess: 0.0, carried: 0.0 };
        let alone = (last + 1) * PARTS - 1..chain.stiffness.len();
        let mut own = [[0.0; 2]; PARTS];
        for (rod, own) in alone.clone().zip(&mut own).rev() {
            let (stiffness, residual) = (chain.stiffness[rod], chain.residual[rod]);
            let excess = chain.geometric[rod] + passed.excess;
            let pivot = stiffness + excess;
            least = smaller(least, pivot);
            let flexibility = 1.0 / pivot;
            let slack = excess * flexibility;
            *own = [(passed.carried - residual) * flexibility, slack];
            passed.carried = slack * residual + stiffness * flexibility * passed.carried;
            passed.excess = stiffness * slack;
        }

        // The parts' inner rods, from each separator down to the one before. A separator clamps what is below it.
        let tip = PARTS - 1;
        let mut excess: Lanes =
            from_fn(|part| if part < tip { stiffness[part][last] } else { passed.excess });
        let mut carried: Lanes =
            from_fn(|part| if part < tip { residual[part][last] } else { passed.carried });
        let mut spike: Lanes = from_fn(|part| if part < tip { 1.0 } else { 0.0 });
        // Turn of each part's last inner rod: from its loads, and for a unit of torque from the separator.
        let (mut turned, mut turned_by_spike) = ([0.0; PARTS], [0.0; PARTS]);
        let mut smallest = [f64::INFINITY; PARTS];
        {
            let (steps, slacks, spikes) =
                (&mut self.step[..last], &mut self.slack[..last], &mut self.spike[..last]);
            let stiffness = stiffness.map(|part| &part[..last]);
            let geometric = geometric.map(|part| &part[..last]);
            let residual = residual.map(|part| &part[..last]);
            for rod in (0..last).rev() {
                for part in 0..PARTS {
                    let (kappa, left) = (stiffness[part][rod], residual[part][rod]);
                    let beyond = geometric[part][rod] + excess[part];
                    let pivot = kappa + beyond;
                    smallest[part] = smaller(smallest[part], pivot);
                    let flexibility = 1.0 / pivot;
                    let (slack, gain) = (beyond * flexibility, kappa * flexibility);
                    let step = (carried[part] - left) * flexibility;
                    let by_spike = spike[part] * flexibility;
                    turned[part] += spike[part] * step;
                    turned_by_spike[part] += spike[part] * by_spike;
                    steps[rod][part] = step;
                    slacks[rod][part] = slack;
                    spikes[rod][part] = by_spike;
                    carried[part] = slack * left + gain * carried[part];
                    spike[part] *= gain;
                    excess[part] = kappa * slack;
                }
            }
        }
        least = smallest.into_iter().fold(least, smaller);

        // The separators, from the last to the first; each then waits for the one before it.
        let mut beyond = Passed { excess: 0.0, carried: 0.0 };
        let (mut free, mut follows) = ([0.0; PARTS], [0.0; PARTS]);
        for part in (0..tip).rev() {
            let kappa = stiffness[part][last];
            let pivot =
                geometric[part][last] + excess[part + 1] + kappa * (1.0 - kappa * turned_by_spike[part])
                    - beyond.excess;
            least = smaller(least, pivot);
            let load = carried[part + 1] - residual[part][last] + kappa * turned[part] + beyond.carried;
            let coupling = kappa * spike[part];
            free[part] = load / pivot;
            follows[part] = coupling / pivot;
            beyond = Passed { excess: coupling * follows[part], carried: coupling * free[part] };
        }
        // Written so that NaN fails.
        let definite = least > 0.0 && carried[0].is_finite() && free.iter().all(|turn| turn.is_finite());
        if !definite {
            return None;
        }
        let mut separator = [0.0; PARTS];
        let mut below = 0.0;
        for part in 0..tip {
            below = free[part] + follows[part] * below;
            separator[part] = below;
        }
        Some(self.apply(stiffness.map(|part| part[last]), separator, own, deviation, turn))
    }

    /// From the base of each part to its separator, all increments; then those of the rods that were taken one by one.
    fn apply(
        &self,
        stiffness: Lanes,
        separator: Lanes,
        own: [[f64; 2]; PARTS],
        deviation: &mut [f64],
        turn: &mut [f64],
    ) -> f64 {
        let last = self.step.len() - 1;
        let torque: Lanes = from_fn(|part| stiffness[part] * separator[part]);
        let mut below: Lanes = from_fn(|part| if part == 0 { 0.0 } else { separator[part - 1] });
        let mut largest = [0.0; PARTS];
        let (deviations, tip_deviations) = parts_mut(deviation);
        let (turns, tip_turns) = parts_mut(turn);
        let [d0, d1, d2, d3] = deviations;
        let [t0, t1, t2, t3] = turns;
        {
            let (steps, slacks, spikes) = (&self.step[..last], &self.slack[..last], &self.spike[..last]);
            let (d0, d1, d2, d3) = (&mut d0[..last], &mut d1[..last], &mut d2[..last], &mut d3[..last]);
            let (t0, t1, t2, t3) = (&mut t0[..last], &mut t1[..last], &mut t2[..last], &mut t3[..last]);
            for rod in 0..last {
                let step: Lanes = from_fn(|part| {
                    steps[rod][part] + torque[part] * spikes[rod][part] - slacks[rod][part] * below[part]
                });
                below = from_fn(|part| below[part] + step[part]);
                largest = from_fn(|part| larger(largest[part], below[part].abs()));
                d0[rod] += step[0];
                d1[rod] += step[1];
                d2[rod] += step[2];
                d3[rod] += step[3];
                [t0[rod], t1[rod], t2[rod], t3[rod]] = below;
            }
        }
        let mut most = largest.into_iter().fold(0.0, larger);
        for (part, (deviation, turn)) in [(d0, t0), (d1, t1), (d2, t2)].into_iter().enumerate() {
            deviation[last] += separator[part] - below[part];
            turn[last] = separator[part];
            most = larger(most, separator[part].abs());
        }
        let mut reached = below[PARTS - 1];
        let ends = core::iter::once((&mut d3[last], &mut t3[last]));
        for ((deviation, turn), [step, slack]) in
            ends.chain(tip_deviations.iter_mut().zip(tip_turns)).zip(own)
        {
            let step = step - slack * reached;
            reached += step;
            *deviation += step;
            *turn = reached;
            most = larger(most, reached.abs());
        }
        most
    }
}

/// As a vector instruction has it: the first number only where it compares.
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
