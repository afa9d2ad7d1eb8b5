//! A chain cut more coarsely, to find quickly where a fine one hangs.
//!
//! The bends of the joints are shared among the nearest coarse nodes (hat functions along the axis), so that the coarse
//! chain is the fine one to second order in the length of its rods. Moments, interpolated between the coarse nodes, give
//! the fine chain's deviations back.

use alloc::vec::Vec;

use super::linkage::{GROUND, Linkage};
use super::loads::Loads;

/// How many rods become one.
const RATIO: usize = 8;
/// Fewest rods that are worth cutting coarsely: the coarse chain still has to show the shape.
pub(super) const FEWEST: usize = 64;

/// The coarse chain, and where its nodes are on the fine one. Buffers are kept between uses.
#[derive(Clone, Debug, Default)]
pub(super) struct Coarse {
    pub(super) linkage: Linkage,
    pub(super) loads: Loads,
    /// Each fine joint's coarse node below, and the share of its bend that goes to the node above.
    shares: Vec<(usize, f64)>,
    /// Bend per torque, and rest angle, of each coarse node.
    nodes: Vec<[f64; 2]>,
}

impl Coarse {
    /// Cuts a chain, with the loads on it.
    pub(super) fn cut(&mut self, chain: &Linkage, loads: &Loads) {
        let rods = chain.len();
        let coarse_rods = rods.div_ceil(RATIO);
        let Coarse { linkage, loads: coarse, shares, nodes } = self;
        linkage.clear();
        shares.clear();
        coarse.x.clear();
        coarse.y.clear();
        nodes.clear();
        nodes.resize(coarse_rods, [0.0; 2]);
        for rod in 0..coarse_rods {
            let fine = rod * RATIO..usize::min((rod + 1) * RATIO, rods);
            let length: f64 = chain.length[fine.clone()].iter().sum();
            let (mut along, mut x, mut y) = (0.0, 0.0, 0.0);
            for joint in fine {
                let (compliance, rest) = (1.0 / chain.stiffness[joint], chain.rest[joint]);
                // The last node has no spring: what would go there stays below.
                let above = if rod + 1 < coarse_rods { along / length } else { 0.0 };
                nodes[rod][0] += (1.0 - above) * compliance;
                nodes[rod][1] += (1.0 - above) * rest;
                if above > 0.0 {
                    nodes[rod + 1][0] += above * compliance;
                    nodes[rod + 1][1] += above * rest;
                }
                shares.push((rod, along / length));
                // The work that a load does when the whole coarse rod turns.
                x += loads.x[joint] * (chain.length[joint] / length);
                y += loads.y[joint] * (chain.length[joint] / length);
                along += chain.length[joint];
            }
            coarse.x.push(x);
            coarse.y.push(y);
            let bearer = rod.checked_sub(1).map_or(GROUND, |bearer| bearer as u32);
            linkage.push(bearer, length, 1.0 / nodes[rod][0], nodes[rod][1]);
        }
    }

    /// Gives the fine chain the deviations that go with the coarse one's moments; there is none at the tip.
    pub(super) fn bend(&self, chain: &mut Linkage) {
        let moment = |node: usize| match self.linkage.stiffness.get(node) {
            Some(stiffness) => stiffness * self.linkage.deviation[node],
            None => 0.0,
        };
        for (joint, &(node, share)) in self.shares.iter().enumerate() {
            let interpolated = (1.0 - share) * moment(node) + share * moment(node + 1);
            chain.deviation[joint] = interpolated / chain.stiffness[joint];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of uneven rods, bent at rest, with uneven loads; its last coarse rod is a shorter one.
    fn uneven_chain() -> (Linkage, Loads) {
        let rods = 8 * RATIO + 3;
        let (mut chain, mut loads) = (Linkage::default(), Loads::none(rods));
        for rod in 0..rods {
            let uneven = |period: usize| (rod % period + 1) as f64 / period as f64;
            let bearer = rod.checked_sub(1).map_or(GROUND, |bearer| bearer as u32);
            chain.push(bearer, 0.1 * uneven(5), 3.0 * uneven(7), uneven(4) - 0.5);
            loads.x[rod] = uneven(3) - 0.4;
            loads.y[rod] = 0.7 - uneven(6);
        }
        loads.gather(&chain);
        (chain, loads)
    }

    /// Where each base joint is along the axis, m.
    fn places(chain: &Linkage) -> Vec<f64> {
        let ends = chain.length.iter().scan(0.0, |end, length| {
            *end += length;
            Some(*end)
        });
        chain.length.iter().zip(ends).map(|(length, end)| end - length).collect()
    }

    /// What must not change, or the coarse chain would hang elsewhere: how far the springs give way and are bent at rest, all
    /// together and about the base (second order asks for both), and the work of loads when a coarse rod turns.
    #[test]
    fn a_coarse_cut_keeps_the_springs_their_bends_and_the_work_of_loads() {
        let (chain, loads) = uneven_chain();
        let mut coarse = Coarse::default();
        coarse.cut(&chain, &loads);
        let coarse_places = places(&coarse.linkage);
        let last = coarse_places[coarse_places.len() - 1];
        // The tip has no spring: what belongs there is kept at the last joint.
        let fine_places: Vec<f64> = places(&chain).into_iter().map(|place| f64::min(place, last)).collect();
        let compliance = |chain: &Linkage| -> Vec<f64> {
            chain.stiffness.iter().map(|stiffness| 1.0 / stiffness).collect()
        };
        let pairs = [
            (chain.rest.clone(), coarse.linkage.rest.clone()),
            (compliance(&chain), compliance(&coarse.linkage)),
        ];
        // Sums of 67 terms below 1: some tens of roundings.
        let same = |fine: f64, coarse: f64| assert!((fine - coarse).abs() < 1e-12, "{fine} {coarse}");
        for (fine, coarse) in pairs {
            same(fine.iter().sum(), coarse.iter().sum());
            let about_the_base = |places: &[f64], values: &[f64]| -> f64 {
                places.iter().zip(values).map(|(place, value)| place * value).sum()
            };
            same(about_the_base(&fine_places, &fine), about_the_base(&coarse_places, &coarse));
        }
        for (fine, coarse_load) in [(&loads.x, &coarse.loads.x), (&loads.y, &coarse.loads.y)] {
            for (rod, load) in coarse_load.iter().enumerate() {
                let here = rod * RATIO..usize::min((rod + 1) * RATIO, chain.len());
                same(here.map(|rod| chain.length[rod] * fine[rod]).sum(), coarse.linkage.length[rod] * load);
            }
        }
    }

    /// A moment that falls evenly from the base to nothing at the tip is what the coarse nodes can tell exactly, so each fine
    /// spring must get just what it bears.
    #[test]
    fn an_even_moment_bends_every_fine_spring_as_it_should() {
        let (mut chain, loads) = uneven_chain();
        let mut coarse = Coarse::default();
        coarse.cut(&chain, &loads);
        let tip: f64 = chain.length.iter().sum();
        let moment = |place: f64| 2.0 * (tip - place);
        for (joint, place) in places(&coarse.linkage).into_iter().enumerate() {
            coarse.linkage.deviation[joint] = moment(place) / coarse.linkage.stiffness[joint];
        }
        coarse.bend(&mut chain);
        for (joint, place) in places(&chain).into_iter().enumerate() {
            let borne = chain.stiffness[joint] * chain.deviation[joint];
            // Lengths are added up here in another order: some tens of roundings of moments up to 8.
            assert!((borne - moment(place)).abs() < 1e-12, "joint {joint}: {borne} {}", moment(place));
        }
    }
}
