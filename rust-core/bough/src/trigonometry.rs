//! Sine and cosine, of one angle or of many at once.
//!
//! Most of a Newton iteration would be spent in a general sine. Here all angles are taken in one loop without
//! branches, which compilers turn into vector code; only additions and multiplications are used, so every platform
//! gives the same bits.

use alloc::vec::Vec;

use core::f64::consts::{FRAC_2_PI, TAU};

/// pi/2 in three parts; the first two have so many zero bits at the end that multiples up to 2^20 are exact.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Adding and subtracting this rounds to a whole number, ties to even, for sizes below 2^51.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Beyond this size the reduction would lose digits.
const LARGEST: f64 = 1e6;

/// Sine and cosine of an angle (radians).
///
/// The angle is reduced to at most pi/4 and a bit, where polynomials leave less than 1e-17, so that the error is that of
/// rounding: below 2.3e-16 (see the test), like the library's. Beyond 10^6, where the reduction would lose digits, whole
/// turns are taken off first.
#[inline]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    if angle.abs() > LARGEST { small_sin_cos(angle % TAU) } else { small_sin_cos(angle) }
}

/// Writes the sine and cosine of every angle (radians).
pub(crate) fn sines_and_cosines(angles: &[f64], sines: &mut Vec<f64>, cosines: &mut Vec<f64>) {
    sines.resize(angles.len(), 0.0);
    cosines.resize(angles.len(), 0.0);
    if small_sines_and_cosines(angles, sines, cosines) {
        for (angle, (sine, cosine)) in angles.iter().zip(sines.iter_mut().zip(cosines.iter_mut())) {
            (*sine, *cosine) = sin_cos(*angle);
        }
    }
}

/// As [`sines_and_cosines`]; returns whether an angle was too large for that. Slices that a function is given cannot overlap,
/// so compilers make vector code of the loop; inlined they would lose that knowledge.
#[inline(never)]
fn small_sines_and_cosines(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) -> bool {
    let rods = angles.len();
    let (sines, cosines) = (&mut sines[..rods], &mut cosines[..rods]);
    let mut large = false;
    for rod in 0..rods {
        large |= angles[rod].abs() > LARGEST;
        (sines[rod], cosines[rod]) = small_sin_cos(angles[rod]);
    }
    large
}

/// Largest turn for [`turn_sines_and_cosines`], radians: the first terms left out are below 5e-18.
pub(crate) const SMALL_TURN: f64 = 1.0 / 256.0;

/// Sines and cosines of angles that turn by at most [`SMALL_TURN`] each, from those before; at 40 % of the cost of new ones.
/// Every turn adds at most one rounding to the error, so it must not be repeated without end.
#[inline(never)]
pub(crate) fn turn_sines_and_cosines(turns: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    let rods = turns.len();
    let (sines, cosines) = (&mut sines[..rods], &mut cosines[..rods]);
    for rod in 0..rods {
        let turn = turns[rod];
        let square = turn * turn;
        let sine_of_turn = turn + turn * square * (-1.0 / 6.0 + square * (1.0 / 120.0));
        let versed = square * (-0.5 + square * (1.0 / 24.0));
        let (sine, cosine) = (sines[rod], cosines[rod]);
        sines[rod] = sine + (cosine * sine_of_turn + sine * versed);
        cosines[rod] = cosine + (cosine * versed - sine * sine_of_turn);
    }
}

/// As [`sin_cos`], without a branch, up to 10^6: compilers make vector code of loops over it.
#[inline(always)]
pub fn small_sin_cos(angle: f64) -> (f64, f64) {
    // The low bits of the sum are the number of quarter turns.
    let shifted = angle * FRAC_2_PI + ROUND;
    let (quarters, bits) = (shifted - ROUND, shifted.to_bits());
    let rest = angle - quarters * HALF_PI[0] - quarters * HALF_PI[1] - quarters * HALF_PI[2];
    let square = rest * rest;
    let (sin, cos) = (small_sine(rest, square).to_bits(), small_cosine(square).to_bits());
    let odd = 0_u64.wrapping_sub(bits & 1);
    let negative_sine = (bits & 2) << 62;
    let negative_cosine = (bits.wrapping_add(1) & 2) << 62;
    (
        f64::from_bits(((sin & !odd) | (cos & odd)) ^ negative_sine),
        f64::from_bits(((cos & !odd) | (sin & odd)) ^ negative_cosine),
    )
}

/// The minimax polynomials of fdlibm (Sun Microsystems, 1993) on at most pi/4: less than 2^-57 from sine and cosine.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Estrin's scheme: half the depth of Horner's, so that the terms do not wait for each other.
#[inline(always)]
fn polynomial([a, b, c, d, e, f]: [f64; 6], square: f64) -> f64 {
    let fourth = square * square;
    (a + square * b) + fourth * ((c + square * d) + fourth * (e + square * f))
}

/// sin(x) for small x, given x and x squared.
#[inline(always)]
fn small_sine(x: f64, square: f64) -> f64 {
    x + x * square * polynomial(SINE, square)
}

/// cos(x) for small x, given x squared.
#[inline(always)]
fn small_cosine(square: f64) -> f64 {
    // 1 - square/2 loses bits of square/2; what is lost is added back.
    let half = 0.5 * square;
    let whole = 1.0 - half;
    whole + ((1.0 - whole - half) + square * square * polynomial(COSINE, square))
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;
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

    #[test]
    fn a_small_turn_costs_one_rounding() {
        for turn in [0.0, 1e-300, 1e-9, -3e-5, 1e-3, SMALL_TURN, -SMALL_TURN] {
            let angles: Vec<f64> = (-4000..4000).map(|step| f64::from(step) * 1.7e-3).collect();
            let exact: Vec<(f64, f64)> = angles.iter().map(|angle| libm::sincos(angle + turn)).collect();
            let (mut sines, mut cosines) = (Vec::new(), Vec::new());
            sines_and_cosines(&angles, &mut sines, &mut cosines);
            let turns = vec![turn; angles.len()];
            turn_sines_and_cosines(&turns, &mut sines, &mut cosines);
            for (angle, (exact, turned)) in angles.iter().zip(exact.iter().zip(sines.iter().zip(&cosines))) {
                // 2.3e-16 before, a rounding of the angle (up to 6.8) here and there, and one of the sum.
                let allowed = 2.3e-16 + f64::EPSILON * (0.5 * angle.abs().max(1.0) + 0.5);
                assert!((exact.0 - turned.0).abs() <= allowed, "sin {angle} after {turn}");
                assert!((exact.1 - turned.1).abs() <= allowed, "cos {angle} after {turn}");
            }
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
