//! Widths and angles at a bifurcation.

/// A bifurcation, as Murray (1927) has it: everything relative to the parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fork {
    /// Width of the thicker child over that of the parent, `d1 / d0`.
    pub thicker: f64,
    /// Width of the thinner child over that of the parent, `d2 / d0`.
    pub thinner: f64,
    /// Angle x by which the thicker child turns away from the parent's direction, radians, 0 or more.
    pub thicker_turn: f64,
    /// Angle y by which the thinner child turns away to the other side, radians, 0 or more.
    pub thinner_turn: f64,
}

impl Fork {
    /// The fork with this exponent alpha (2 or more) and girth ratio `d2 / d1` (above 0, at most 1).
    ///
    /// Widths follow equation 47, `d0^alpha = d1^alpha + d2^alpha`, angles 48 and 49. With
    /// `e = d1^2 + d2^2 - 1` (0 at alpha = 2, where both children go straight on) the angles are
    /// `sin^2(x/2) = e (1 + d2^2 - d1^2) / (4 d1^2)` and `sin^2(y/2) = e (1 + d1^2 - d2^2) / (4 d2^2)`,
    /// the same angles without the cancellation of the cosines near 1.
    ///
    /// The paper prints equation 49 with `d1` in the denominator. That is a slip: its own equation 50 for `x + y`
    /// holds only with `d2`. At alpha = 2.49 and ratio 0.8 the printed one gives 59.03 degrees instead of 36.48.
    ///
    /// ```
    /// use bough::growth::Fork;
    /// let fork = Fork::new(2.49, 0.8);
    /// assert!((fork.thicker_turn.to_degrees() - 22.3655025192).abs() < 1e-9);
    /// assert!((fork.thinner_turn.to_degrees() - 36.4807422114).abs() < 1e-9);
    /// ```
    pub fn new(exponent: f64, girth_ratio: f64) -> Self {
        let sum = libm::log1p(libm::pow(girth_ratio, exponent));
        let thicker = libm::exp(-sum / exponent);
        let thinner = girth_ratio * thicker;
        let (d1, d2) = (thicker * thicker, thinner * thinner);
        let excess = libm::expm1(libm::log1p(girth_ratio * girth_ratio) - 2.0 / exponent * sum).max(0.0);
        let turn = |sine_squared: f64| 2.0 * libm::asin(libm::sqrt(sine_squared.clamp(0.0, 1.0)));
        Fork {
            thicker,
            thinner,
            thicker_turn: turn(excess * (1.0 + d2 - d1) / (4.0 * d1)),
            thinner_turn: turn(excess * (1.0 + d1 - d2) / (4.0 * d2)),
        }
    }
}
