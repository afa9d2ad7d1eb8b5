//! How the plan of a plant, and its forks, change with a parameter. Derivatives are relative (d ln y) unless said otherwise:
//! lengths, girths and stiffnesses are products of powers.

use alloc::vec::Vec;
use core::f64::consts::PI;

use super::plan::AxisPlan;
use crate::params::{Params, Thickening};
use crate::trigonometry::sin_cos;

/// The axes of one generation.
#[derive(Clone, Debug, Default)]
pub(super) struct AxisSlope {
    /// Of each segment's length.
    pub(super) length: Vec<f64>,
    /// Of each segment's radius at birth over that of the base.
    pub(super) radius: Vec<f64>,
    /// Of the radius at the tip over that of the base.
    pub(super) tip: f64,
}

impl AxisSlope {
    /// Along `direction`, which holds the derivative of every parameter.
    pub(super) fn new(params: &Params, plan: &AxisPlan, direction: &Params) -> Self {
        let segments = plan.length.len();
        let (axis, along) = (&params.axis, &direction.axis);
        let bump = |segment: usize| {
            let (sin, _) = sin_cos(PI * segment as f64 / (segments.max(2) - 1) as f64);
            if segments < 3 { 0.0 } else { sin * sin }
        };
        let weight = |segment: usize| 1.0 + (axis.length_profile - 1.0) * bump(segment);
        let bumps: f64 = (0..segments).map(bump).sum();
        let weights: f64 = (0..segments).map(weight).sum();
        let mean = along.segment_length / axis.segment_length;
        let (taper, taper_along) = match params.growth.thickening {
            Thickening::Pipes => (1.0, 0.0),
            Thickening::None => (axis.taper, along.taper),
        };
        let total: f64 = plan.length.iter().sum();
        let mut slope = AxisSlope { tip: ratio(taper_along, taper), ..AxisSlope::default() };
        // The share of the axis below a segment, and its derivative.
        let (mut share, mut moves) = (0.0, 0.0);
        for (segment, length) in plan.length.iter().enumerate() {
            let profile = along.length_profile * (bump(segment) / weight(segment) - bumps / weights);
            slope.length.push(mean + profile);
            let own = length / total;
            let middle = share + 0.5 * own;
            let radius = taper_along * middle + (taper - 1.0) * (moves + 0.5 * own * profile);
            slope.radius.push(ratio(radius, plan.radius[segment]));
            share += own;
            moves += own * profile;
        }
        slope
    }
}

/// What does not change at all does not change in relation to nothing either.
pub(super) fn ratio(change: f64, value: f64) -> f64 {
    if change == 0.0 { 0.0 } else { change / value }
}

/// Both children of a fork, the thicker one first.
#[derive(Clone, Copy, Debug)]
pub(super) struct ForkSlope {
    /// Of the widths over that of the parent.
    pub(super) width: [f64; 2],
    /// Of the angles by which they turn, radians; not relative. Infinite at the exponent 2, where both go straight on.
    pub(super) turn: [f64; 2],
}

impl ForkSlope {
    /// By equations 47 to 49.
    pub(super) fn new(params: &Params, direction: &Params) -> Self {
        let (alpha, ratio_of_girths) = (params.branching.exponent, params.branching.girth_ratio);
        let (alpha_along, ratio_along) = (direction.branching.exponent, direction.branching.girth_ratio);
        if alpha_along == 0.0 && ratio_along == 0.0 {
            return ForkSlope { width: [0.0; 2], turn: [0.0; 2] };
        }
        let power = libm::pow(ratio_of_girths, alpha);
        let log_sum = libm::log1p(power);
        let log_ratio = libm::log(ratio_of_girths);
        // ln d1 = -ln(1 + r^alpha) / alpha
        let grown = power / (1.0 + power) * (log_ratio * alpha_along + alpha * ratio_along / ratio_of_girths);
        let thicker = (log_sum / alpha * alpha_along - grown) / alpha;
        let width = [thicker, thicker + ratio_along / ratio_of_girths];
        let squares = [libm::exp(-2.0 * log_sum / alpha), libm::exp(2.0 * (log_ratio - log_sum / alpha))];
        let turn = |own: usize| {
            let [own_square, other] = [squares[own], squares[1 - own]];
            let [own_width, other_width] = [2.0 * width[own], 2.0 * width[1 - own]];
            // cos x = (1 + a^2 - b^2) / (2 a) with a, b the squares of the own and the other width
            let cosine = (1.0 + own_square * own_square - other * other) / (2.0 * own_square);
            let slope = (own_square * own_square * own_width - other * other * other_width) / own_square
                - cosine * own_width;
            -slope / libm::sqrt(1.0 - cosine * cosine)
        };
        ForkSlope { width, turn: [turn(0), turn(1)] }
    }
}
