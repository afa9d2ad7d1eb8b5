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
