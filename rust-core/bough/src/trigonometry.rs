//! Sine and cosine, of one angle or of many at once.
//!
//! Most of a Newton iteration would be spent in a general sine. Here all angles are taken in one loop without
//! branches, which compilers turn into vector code; only additions and multiplications are used, so every platform
//! gives the same bits.

use core::f64::consts::{FRAC_2_PI, TAU};

/// pi/2 in three parts; the first two have so many zero bits at the end that multiples up to 2^20 are exact.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Adding and subtracting this rounds to a whole number, ties to even, for sizes below 2^51.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Beyond this size the reduction would lose digits.
const LARGEST: f64 = 1e6;

/// Sine and cosine of an angle (radians).
///
/// The angle is reduced to at most pi/4 and a bit; there the Taylor series to the 17th and 18th power leave less than
/// 1e-17, so that the error is that of rounding: below 2.3e-16 (see the test), like the library's. Beyond 10^6, where the
/// reduction would lose digits, whole turns are taken off first.
#[inline]
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    if angle.abs() > LARGEST { small_sin_cos(angle % TAU) } else { small_sin_cos(angle) }
}

/// Writes the sine and cosine of every angle (radians).
pub(crate) fn sines_and_cosines(angles: &[f64], sines: &mut Vec<f64>, cosines: &mut Vec<f64>) {
    sines.clear();
    cosines.clear();
    sines.resize(angles.len(), 0.0);
    cosines.resize(angles.len(), 0.0);
    let mut large = false;
    for (angle, (sine, cosine)) in angles.iter().zip(sines.iter_mut().zip(cosines.iter_mut())) {
        large |= angle.abs() > LARGEST;
        (*sine, *cosine) = small_sin_cos(*angle);
    }
    if large {
        for (angle, (sine, cosine)) in angles.iter().zip(sines.iter_mut().zip(cosines.iter_mut())) {
            (*sine, *cosine) = sin_cos(*angle);
        }
    }
}

/// As [`sin_cos`], without a branch, up to 10^6.
#[inline(always)]
fn small_sin_cos(angle: f64) -> (f64, f64) {
    // The low bits of the sum are the number of quarter turns.
    let shifted = angle * FRAC_2_PI + ROUND;
    let (quarters, bits) = (shifted - ROUND, shifted.to_bits());
    let rest = angle - quarters * HALF_PI[0] - quarters * HALF_PI[1] - quarters * HALF_PI[2];
    let square = rest * rest;
    let (sin, cos) = (sine_series(rest, square).to_bits(), cosine_series(square).to_bits());
    let odd = 0_u64.wrapping_sub(bits & 1);
    let negative_sine = (bits & 2) << 62;
    let negative_cosine = (bits.wrapping_add(1) & 2) << 62;
    (
        f64::from_bits(((sin & !odd) | (cos & odd)) ^ negative_sine),
        f64::from_bits(((cos & !odd) | (sin & odd)) ^ negative_cosine),
    )
}

/// sin(x) for small x, given x and x squared.
fn sine_series(x: f64, square: f64) -> f64 {
    let tail = square
        * (-1.0 / 6.0
            + square
                * (1.0 / 120.0
                    + square
                        * (-1.0 / 5_040.0
                            + square
                                * (1.0 / 362_880.0
                                    + square
                                        * (-1.0 / 39_916_800.0
                                            + square
                                                * (1.0 / 6_227_020_800.0
                                                    + square
                                                        * (-1.0 / 1_307_674_368_000.0
                                                            + square * (1.0 / 355_687_428_096_000.0))))))));
    x + x * tail
}

/// cos(x) for small x, given x squared.
fn cosine_series(square: f64) -> f64 {
    let tail = 1.0 / 24.0
        + square
            * (-1.0 / 720.0
                + square
                    * (1.0 / 40_320.0
                        + square
                            * (-1.0 / 3_628_800.0
                                + square
                                    * (1.0 / 479_001_600.0
                                        + square
                                            * (-1.0 / 87_178_291_200.0
                                                + square
                                                    * (1.0 / 20_922_789_888_000.0
                                                        + square * (-1.0 / 6_402_373_705_728_000.0)))))));
    // 1 - square/2 loses bits of square/2; what is lost is added back.
    let half = 0.5 * square;
    let whole = 1.0 - half;
    whole + ((1.0 - whole - half) + square * square * tail)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    /// Against the library's functions, whose own error is below 1.2e-16, over all quarters and far out.
    #[test]
    fn the_error_is_that_of_rounding() {
        let mut angles: Vec<f64> = (-400_000..=400_000).map(|step| f64::from(step) * 1.7e-5).collect();
        angles.extend((-2000..2000).map(|quarter| f64::from(quarter) * 0.25 * PI));
        angles.extend((-1000..1000).map(|step| f64::from(step) * 987.654_321));
        angles.extend([0.0, -0.0, 1e-300, -1e-20, 1e-9, 0.5 * PI, PI]);
        let (mut sines, mut cosines) = (Vec::new(), Vec::new());
        sines_and_cosines(&angles, &mut sines, &mut cosines);
        for (angle, (sine, cosine)) in angles.iter().zip(sines.iter().zip(&cosines)) {
            let (exact_sine, exact_cosine) = libm::sincos(*angle);
            assert!((sine - exact_sine).abs() <= 2.3e-16, "sin {angle}: {sine} {exact_sine}");
            assert!((cosine - exact_cosine).abs() <= 2.3e-16, "cos {angle}: {cosine} {exact_cosine}");
            // Small sines keep their relative digits.
            assert!((sine - exact_sine).abs() <= 4.0 * f64::EPSILON * exact_sine.abs() || angle.abs() > 3.0);
        }
    }

    /// Taking turns off by the rounded 2 pi shifts an angle by its size times 4e-17.
    #[test]
    fn large_angles_lose_no_more_than_their_own_rounding() {
        for angle in [1.1e6, -7.3e6, 1e9, 3e12] {
            let (mut sines, mut cosines) = (Vec::new(), Vec::new());
            sines_and_cosines(&[0.5, angle], &mut sines, &mut cosines);
            let (sine, cosine) = libm::sincos(angle);
            let allowed = angle.abs() * f64::EPSILON;
            assert!((sines[1] - sine).abs() < allowed && (cosines[1] - cosine).abs() < allowed, "{angle}");
            assert_eq!((sines[1], cosines[1]), sin_cos(angle));
            assert_eq!((sines[0], cosines[0]), sin_cos(0.5));
        }
        for angle in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(sin_cos(angle).0.is_nan() && sin_cos(angle).1.is_nan());
        }
        let (sine, cosine) = sin_cos(f64::MAX);
        assert!((sine * sine + cosine * cosine - 1.0).abs() < 1e-15);
    }
}
