//! Newton's increment of a tree of rods that is numbered level by level.
//!
//! Rods at the same distance from the ground do not wait for each other, and where no fork comes between, a level's
//! bearers stand in the same order right before it: plain loops over slices, which compilers turn into vector code.

use alloc::vec::Vec;

use core::ops::Range;

use super::linkage::GROUND;

/// Narrowest mean width of the levels for which this pays.
pub(super) const NARROWEST: usize = 4;

/// The levels of a tree, from the ground up.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Levels {
    /// First rod of each level.
    starts: Vec<u32>,
    /// Whether each level's rods stand one by one on those of the level before.
    steady: Vec<bool>,
    /// How many rods were numbered so when they came: all of them, or the order is another.
    numbered: usize,
}

/// One level: its rods, and whether rod `i` of it stands on rod `i` of the level before.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Level {
    pub(super) rods: Range<usize>,
    /// The level before, where it is as wide and each rod stands on its counterpart.
    pub(super) bearers: Option<Range<usize>>,
}

impl Levels {
    pub(super) fn clear(&mut self) {
        self.starts.clear();
        self.steady.clear();
        self.numbered = 0;
    }

    /// Takes down the next rod.
    pub(super) fn push(&mut self, rod: usize, parent: u32) {
        let last = self.starts.last().map_or(0, |&start| start as usize);
        let before = self.starts.len().checked_sub(2).map_or(0, |level| self.starts[level] as usize);
        let parent = if parent == GROUND { None } else { Some(parent as usize) };
        match parent {
            // On the ground stands only the first level.
            None if self.starts.len() > 1 => return,
            None if rod > 0 => {}
            Some(parent) if parent < before => return,
            Some(parent) if parent < last => {
                let level = self.starts.len() - 1;
                self.steady[level] &= parent - before == rod - last;
            }
            _ => {
                self.starts.push(rod as u32);
                self.steady.push(parent == Some(last) || parent.is_none());
            }
        }
        self.numbered += 1;
    }

    /// Whether all of so many rods are numbered level by level, and the levels are wide.
    pub(super) fn are_wide(&self, rods: usize) -> bool {
        self.numbered == rods && rods >= NARROWEST * self.starts.len()
    }

    /// From the ground up.
    pub(super) fn iter(&self) -> impl DoubleEndedIterator<Item = Level> {
        (0..self.starts.len()).map(|level| {
            let start = |level: usize| self.starts.get(level).map_or(self.numbered, |&start| start as usize);
            let rods = start(level)..start(level + 1);
            let below = level.checked_sub(1).map(|below| start(below)..rods.start);
            let bearers = below.filter(|below| self.steady[level] && below.len() == rods.len());
            Level { rods, bearers }
        })
    }

    /// Adds each rod's number to its bearer's, from the top down.
    pub(super) fn gather(&self, parent: &[u32], numbers: &mut [f64]) {
        for Level { rods, bearers } in self.iter().rev() {
            let (below, level) = numbers[..rods.end].split_at_mut(rods.start);
            match bearers {
                Some(bearers) => {
                    for (below, number) in below[bearers].iter_mut().zip(level) {
                        *below += *number;
                    }
                }
                None => {
                    for (parent, number) in parent[rods].iter().zip(level) {
                        if *parent != GROUND {
                            below[*parent as usize] += *number;
                        }
                    }
                }
            }
        }
    }

    /// Adds each bearer's number to its rods', from the ground up.
    pub(super) fn spread(&self, parent: &[u32], numbers: &mut [f64]) {
        for Level { rods, bearers } in self.iter() {
            let (below, level) = numbers[..rods.end].split_at_mut(rods.start);
            match bearers {
                Some(bearers) => {
                    for (number, below) in level.iter_mut().zip(&below[bearers]) {
                        *number += below;
                    }
                }
                None => {
                    for (number, parent) in level.iter_mut().zip(&parent[rods]) {
                        *number += if *parent == GROUND { 0.0 } else { below[*parent as usize] };
                    }
                }
            }
        }
    }
}

/// A tree's arrays.
#[derive(Clone, Copy)]
pub(super) struct Tree<'a> {
    pub(super) parent: &'a [u32],
    pub(super) levels: &'a Levels,
    pub(super) stiffness: &'a [f64],
    /// Diagonal of the load's Hessian.
    pub(super) geometric: &'a [f64],
    /// Torque left over at each base joint.
    pub(super) residual: &'a [f64],
}

/// Buffers, kept between uses.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    /// Stiffness of what is beyond each joint; then the share of the bearer's turn that the joint gives back.
    slack: Vec<f64>,
    /// Torque from beyond each joint; then its increment but for that share.
    step: Vec<f64>,
    /// What the rods of one level pass on.
    passed: Vec<[f64; 2]>,
}

impl Rows {
    /// Adds Newton's increment to every deviation, writes the turn of every rod, and returns the largest. `None`, with
    /// nothing written, where the Hessian is not positive definite or a number is not finite. O(n).
    pub(super) fn newton(&mut self, tree: Tree, deviation: &mut [f64], turn: &mut [f64]) -> Option<f64> {
        let Tree { parent, levels, stiffness, geometric, residual } = tree;
        self.slack.clear();
        self.slack.extend_from_slice(geometric);
        self.step.clear();
        self.step.resize(stiffness.len(), 0.0);
        let mut least = f64::INFINITY;
        for Level { rods, bearers } in levels.iter().rev() {
            let width = rods.len();
            self.passed.resize(usize::max(width, self.passed.len()), [0.0; 2]);
            let passed = &mut self.passed[..width];
            let (slack_below, slack) = self.slack[..rods.end].split_at_mut(rods.start);
            let (step_below, step) = self.step[..rods.end].split_at_mut(rods.start);
            let (kappa, left) = (&stiffness[rods.clone()], &residual[rods.clone()]);
            let (slack, step) = (&mut slack[..width], &mut step[..width]);
            for rod in 0..width {
                let excess = slack[rod];
                let pivot = kappa[rod] + excess;
                least = if pivot < least { pivot } else { least };
                let flexibility = 1.0 / pivot;
                let (gives, gain) = (excess * flexibility, kappa[rod] * flexibility);
                passed[rod] = [kappa[rod] * gives, gives * left[rod] + gain * step[rod]];
                step[rod] = (step[rod] - left[rod]) * flexibility;
                slack[rod] = gives;
            }
            match bearers {
                Some(bearers) => {
                    let below = slack_below[bearers.clone()].iter_mut().zip(&mut step_below[bearers]);
                    for ((excess, carried), passed) in below.zip(&*passed) {
                        *excess += passed[0];
                        *carried += passed[1];
                    }
                }
                None => {
                    for (parent, passed) in parent[rods].iter().zip(&*passed) {
                        if *parent != GROUND {
                            slack_below[*parent as usize] += passed[0];
                            step_below[*parent as usize] += passed[1];
                        }
                    }
                }
            }
        }
        // Written so that NaN fails: it reaches the ground.
        let base = levels.iter().next().map_or(0..0, |level| level.rods);
        if !(least > 0.0 && self.step[base].iter().all(|step| step.is_finite())) {
            return None;
        }
        let mut largest = 0.0_f64;
        for Level { rods, bearers } in levels.iter() {
            let width = rods.len();
            let (below, turn) = turn[..rods.end].split_at_mut(rods.start);
            let turn = &mut turn[..width];
            match bearers {
                Some(bearers) => turn.copy_from_slice(&below[bearers]),
                None => {
                    for (turn, parent) in turn.iter_mut().zip(&parent[rods.clone()]) {
                        *turn = if *parent == GROUND { 0.0 } else { below[*parent as usize] };
                    }
                }
            }
            let (slack, step) = (&self.slack[rods.clone()], &self.step[rods.clone()]);
            let deviation = &mut deviation[rods][..width];
            for rod in 0..width {
                let step = step[rod] - slack[rod] * turn[rod];
                deviation[rod] += step;
                turn[rod] += step;
                let size = turn[rod].abs();
                largest = if size > largest { size } else { largest };
            }
        }
        Some(largest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec;

    /// What [`Levels`] are to be, by their definition: none if the rods come in another order.
    fn expected(parents: &[u32]) -> Option<Vec<Level>> {
        let mut depths: Vec<usize> = Vec::new();
        for &parent in parents {
            depths.push(if parent == GROUND { 0 } else { depths[parent as usize] + 1 });
        }
        if !depths.is_sorted() {
            return None;
        }
        let level = |depth: usize| {
            depths.partition_point(|&other| other < depth)..depths.partition_point(|&other| other <= depth)
        };
        let levels = 0..depths.last().map_or(0, |last| last + 1);
        Some(
            levels
                .map(|depth| {
                    let rods = level(depth);
                    let below = depth.checked_sub(1).map(level);
                    let stands = |below: &Range<usize>| {
                        let bearers = parents[rods.clone()].iter().map(|&parent| parent as usize);
                        bearers.eq(below.clone())
                    };
                    let bearers = below.filter(stands);
                    Level { rods, bearers }
                })
                .collect(),
        )
    }

    /// All trees of up to six rods, some on the ground.
    #[test]
    fn levels_are_those_of_the_definition() {
        let mut trees: Vec<Vec<u32>> = vec![vec![]];
        for _ in 0..6 {
            let longest: Vec<Vec<u32>> =
                trees.iter().filter(|tree| tree.len() == trees[trees.len() - 1].len()).cloned().collect();
            for tree in longest {
                for parent in (0..tree.len() as u32).chain([GROUND]) {
                    let mut tree = tree.clone();
                    tree.push(parent);
                    trees.push(tree);
                }
            }
        }
        let mut accepted = 0;
        for parents in trees.iter().filter(|tree| !tree.is_empty()) {
            let mut levels = Levels::default();
            for (rod, &parent) in parents.iter().enumerate() {
                levels.push(rod, parent);
            }
            let found = (levels.numbered == parents.len()).then(|| levels.iter().collect());
            assert_eq!(found, expected(parents), "{parents:?}");
            accepted += usize::from(found.is_some());
        }
        assert!(accepted > 100, "{accepted}");
    }

    #[test]
    fn levels_are_wide_where_they_hold_four_rods_each() {
        let levels_of = |wide: u32, high: u32| {
            let mut levels = Levels::default();
            for rod in 0..wide * high {
                levels.push(rod as usize, rod.checked_sub(wide).unwrap_or(GROUND));
            }
            levels
        };
        assert!(levels_of(4, 3).are_wide(12));
        assert!(!levels_of(3, 3).are_wide(9));
        // One more came that was not taken down.
        assert!(!levels_of(4, 3).are_wide(13));
    }
}
