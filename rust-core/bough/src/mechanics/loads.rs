//! Forces on the nodes of a linkage, and what each rod carries.

use alloc::vec;
use alloc::vec::Vec;

use super::linkage::{GROUND, Linkage};

/// For each rod the sum of all forces that act at its distal end or beyond it (the sums of equations 5 to 9),
/// in N, in the frame of the base direction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loads {
    /// Component along the base direction.
    pub x: Vec<f64>,
    /// Component at right angles to it, counter-clockwise.
    pub y: Vec<f64>,
}

impl Loads {
    /// No force on `rods` rods.
    pub fn none(rods: usize) -> Self {
        Loads { x: vec![0.0; rods], y: vec![0.0; rods] }
    }

    /// Sums the forces at the distal ends of the rods, given here, over everything beyond each rod. O(n).
    pub fn gather(&mut self, linkage: &Linkage) {
        for rod in (0..linkage.len()).rev() {
            if linkage.parent[rod] != GROUND {
                let parent = linkage.parent[rod] as usize;
                self.x[parent] += self.x[rod];
                self.y[parent] += self.y[rod];
            }
        }
    }

    /// Adds other loads, so many times.
    pub fn add(&mut self, other: &Loads, times: f64) {
        for (to, from) in [(&mut self.x, &other.x), (&mut self.y, &other.y)] {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += times * from);
        }
    }

    /// Writes what lies between `from` and `to` into `self`; a share of 1 is `to` itself, however heavy `from` was. Rods that
    /// `from` does not have yet carried nothing.
    pub(super) fn blend(&mut self, from: &Loads, to: &Loads, share: f64) {
        let mix = |from: &[f64], to: &[f64], mixed: &mut Vec<f64>| {
            let before = from.iter().copied().chain(core::iter::repeat(0.0));
            mixed.clear();
            mixed.extend(to.iter().zip(before).map(|(to, from)| (1.0 - share) * from + share * to));
        };
        mix(&from.x, &to.x, &mut self.x);
        mix(&from.y, &to.y, &mut self.y);
    }
}
