//! What is known before growth begins: how many segments the axes of each generation have, how long and how
//! thick they are, and how an axis forks.

use alloc::vec;
use alloc::vec::Vec;

use core::f64::consts::PI;

use super::axis::STEM;
use super::fork::Fork;
use crate::params::{Arrangement, ArrangementPattern, Params, Thickening, segments_of_generations, steps_of};
use crate::trigonometry::sin_cos;

/// The finished axes of one generation, segment by segment from the base.
#[derive(Clone, Debug)]
pub(super) struct AxisPlan {
    /// Length of each segment, m; their mean is `axis.segmentLength`.
    pub(super) length: Vec<f64>,
    /// Radius at the middle of each segment at its birth, over that at the base of the axis.
    pub(super) radius: Vec<f64>,
    /// Radius at the base and at the distal end of each segment at its birth, over that at the base.
    pub(super) radius_at: Vec<f64>,
}

/// The whole plant before it grows.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// One plan a generation; generation 0 is the main axis.
    pub(super) generations: Vec<AxisPlan>,
    /// How the axes of all generations but the last fork.
    pub(super) fork: Fork,
    /// The flexible stem, one segment below each of its axes.
    pub(super) stem: Option<AxisPlan>,
    steps: u32,
}

impl Plan {
    pub(super) fn new(params: &Params) -> Self {
        let branching = &params.branching;
        let generations = segments_of_generations(params).map(|segments| AxisPlan::new(params, segments));
        let fork = Fork::new(branching.exponent, branching.girth_ratio);
        let arrangement = &params.arrangement;
        let stem =
            (arrangement.pattern == ArrangementPattern::FlexibleStem).then(|| AxisPlan::stem(arrangement));
        Plan { generations: generations.collect(), fork, stem, steps: steps_of(params) as u32 }
    }

    /// Growth steps until the last generation is finished.
    pub(super) fn steps(&self) -> u32 {
        self.steps
    }

    /// That of an axis of a generation, or of the stem.
    pub(super) fn of(&self, generation: u32) -> &AxisPlan {
        match &self.stem {
            Some(stem) if generation == STEM => stem,
            _ => &self.generations[generation as usize],
        }
    }
}

impl AxisPlan {
    /// A stem of one segment below each axis, the lowest as much longer as its bare trunk, all as thick.
    fn stem(arrangement: &Arrangement) -> Self {
        let segments = arrangement.count as usize;
        let mut length = vec![arrangement.spacing; segments];
        length.iter_mut().take(1).for_each(|lowest| *lowest += arrangement.trunk);
        AxisPlan { length, radius: vec![1.0; segments], radius_at: vec![1.0; segments + 1] }
    }

    fn new(params: &Params, segments: u32) -> Self {
        let axis = &params.axis;
        let length = lengths(segments as usize, axis.length_profile, axis.segment_length);
        // Pipes make their own taper.
        let taper = if params.growth.thickening == Thickening::Pipes { 1.0 } else { axis.taper };
        let total: f64 = length.iter().sum();
        let radius_after = |distance: f64| 1.0 + (taper - 1.0) * (distance / total);
        let mut radius = Vec::with_capacity(length.len());
        let mut radius_at = vec![1.0];
        let mut distance = 0.0;
        for &segment in &length {
            radius.push(radius_after(distance + 0.5 * segment));
            distance += segment;
            radius_at.push(radius_after(distance).max(0.0));
        }
        AxisPlan { length, radius, radius_at }
    }
}

/// Segment lengths with mean `mean`: `1` at both ends rising smoothly (sine squared) to `profile` in the middle,
/// scaled.
fn lengths(segments: usize, profile: f64, mean: f64) -> Vec<f64> {
    if profile == 1.0 || segments < 3 {
        return vec![mean; segments];
    }
    let last = (segments - 1) as f64;
    let weight = |segment: usize| {
        let (sin, _) = sin_cos(PI * segment as f64 / last);
        1.0 + (profile - 1.0) * sin * sin
    };
    let weights: Vec<f64> = (0..segments).map(weight).collect();
    let scale = mean * segments as f64 / weights.iter().sum::<f64>();
    weights.into_iter().map(|weight| scale * weight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::BranchingPattern;

    #[test]
    fn the_profile_keeps_the_mean_and_its_ratio() {
        for profile in [0.2, 1.0, 3.0] {
            for segments in [1, 2, 3, 10, 41] {
                let lengths = lengths(segments, profile, 0.05);
                let total: f64 = lengths.iter().sum();
                assert!((total - 0.05 * segments as f64).abs() < 1e-14);
                if segments % 2 == 1 && segments > 1 {
                    let ratio = lengths[segments / 2] / lengths[0];
                    assert!((ratio - profile).abs() < 1e-12, "{segments} segments: {ratio}");
                }
            }
        }
    }

    #[test]
    fn a_cone_ends_in_a_point_and_its_segments_do_not() {
        let mut params = Params::default();
        params.axis.taper = 0.0;
        let plan = AxisPlan::new(&params, 40);
        assert_eq!(plan.radius_at.last().copied().map(|radius| radius < 1e-15), Some(true));
        assert!(plan.radius.iter().all(|&radius| radius > 0.0));
    }

    #[test]
    fn generations_shrink_by_the_length_ratio() {
        let mut params = Params::default();
        params.axis.segments = 12;
        params.branching.pattern = BranchingPattern::Bifurcation;
        params.branching.generations = 5;
        params.branching.length_ratio = 0.5;
        assert_eq!(segments_of_generations(&params).collect::<Vec<_>>(), [12, 6, 3, 2, 1, 1]);
        assert_eq!(Plan::new(&params).steps(), 25);
    }
}
