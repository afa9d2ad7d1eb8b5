//! Rotations in space, by rotation vectors (direction of the axis times angle, radians) and unit quaternions.
//!
//! Joints turn little, so all is by polynomials near zero, without a branch's or a library's cost; larger angles take
//! the closed forms. Only `libm` and arithmetic: the same bits everywhere.

use core::f64::consts::PI;

use glam::{DQuat, DVec3};

use crate::angle::Degrees;
use crate::trigonometry::sin_cos;

/// Up to here, of a sine squared, 10 terms of the arc sine leave less than 1e-18.
const SMALL_SINE: f64 = 1.0 / 64.0;
/// Up to here, of an angle squared, 7 terms of half its sine and cosine leave less than 1e-17, and 8 of [`Curving`] less than 1e-16.
const SMALL_ANGLE: f64 = 0.25;

/// The rotation by a rotation vector.
#[inline]
pub fn exp(rotation: DVec3) -> DQuat {
    let square = rotation.length_squared();
    if is_small(square) { exp_small(rotation) } else { exp_large(rotation, square) }
}

/// Whether [`exp_small`] and [`composed_small`] serve a rotation vector of this length squared.
#[inline]
pub(super) fn is_small(square: f64) -> bool {
    square <= SMALL_ANGLE
}

/// [`exp`] of at most half a radian.
#[inline(always)]
pub(super) fn exp_small(rotation: DVec3) -> DQuat {
    let square = 0.25 * rotation.length_squared();
    let DVec3 { x, y, z } = rotation * (0.5 * horner(&SINC, square));
    DQuat::from_xyzw(x, y, z, horner(&COSINE, square))
}

#[inline(never)]
fn exp_large(rotation: DVec3, square: f64) -> DQuat {
    let angle = libm::sqrt(square);
    let (sine, cosine) = sin_cos(0.5 * angle);
    let DVec3 { x, y, z } = rotation * (sine / angle);
    DQuat::from_xyzw(x, y, z, cosine)
}

/// Far below the bound of all terms, where half as many leave less than 1e-17.
const TINY: f64 = 1e-3;

/// Sum of a power series.
#[inline]
fn horner<const N: usize>(terms: &[f64; N], variable: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * variable + term)
}

const SINC: [f64; 7] = [
    1.0,
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
];
const COSINE: [f64; 7] =
    [1.0, -0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40_320.0, -1.0 / 3_628_800.0, 1.0 / 479_001_600.0];

/// The rotation vector of a rotation, at most pi long: the short way round.
#[inline]
pub fn log(rotation: DQuat) -> DVec3 {
    let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
    let sine = DVec3::new(rotation.x, rotation.y, rotation.z) * sign;
    let square = sine.length_squared();
    let scale = if square <= SMALL_SINE { small_arc(square) } else { large_arc(square, sign * rotation.w) };
    sine * (2.0 * scale)
}

const ARC: [f64; 10] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    5.0 / 112.0,
    35.0 / 1152.0,
    63.0 / 2816.0,
    231.0 / 13_312.0,
    143.0 / 10_240.0,
    6435.0 / 557_056.0,
    12_155.0 / 1_245_184.0,
];

/// arcsin(s) / s.
#[inline]
fn small_arc(square: f64) -> f64 {
    if square <= TINY {
        return horner(&[ARC[0], ARC[1], ARC[2], ARC[3], ARC[4]], square);
    }
    horner(&ARC, square)
}

#[inline(never)]
fn large_arc(square: f64, cosine: f64) -> f64 {
    let sine = libm::sqrt(square);
    libm::atan2(sine, cosine) / sine
}

/// The rotation vector of one rotation after another, `log(exp(first) exp(then))`: to second order in the other, and exact to first
/// for any `first`; always the short way round.
pub(super) fn composed(first: DVec3, then: DVec3) -> DVec3 {
    let sum = composed_by(first, then, Curving::at(first.length_squared()));
    if sum.length_squared() <= LONGEST * LONGEST { sum } else { log(exp(sum)) }
}

/// [`composed`] for a small `first`.
#[inline(always)]
pub(super) fn composed_small(first: DVec3, then: DVec3) -> DVec3 {
    composed_by(first, then, Curving::small(first.length_squared()))
}

#[inline(always)]
fn composed_by(first: DVec3, then: DVec3, curving: Curving) -> DVec3 {
    let once = first.cross(then);
    let curved = first.cross(once) * curving.first;
    first + then + once * 0.5 + curved - then.cross(once) * (1.0 / 12.0)
}

/// The modified Rodrigues parameters of a rotation: its axis times the tangent of a quarter of its angle, at most 1 long. Three
/// numbers, as the rotation vector, without its arc tangent.
pub fn rodrigues(rotation: DQuat) -> DVec3 {
    let DQuat { x, y, z, w } = rotation;
    DVec3::new(x, y, z) * (if w < 0.0 { -1.0 } else { 1.0 } / (1.0 + w.abs()))
}

/// The rotation of these modified Rodrigues parameters.
pub fn from_rodrigues(parameters: DVec3) -> DQuat {
    let square = parameters.length_squared();
    let inverse = 1.0 / (1.0 + square);
    let DVec3 { x, y, z } = parameters * (2.0 * inverse);
    DQuat::from_xyzw(x, y, z, (1.0 - square) * inverse)
}

/// A product of unit quaternions, with the length that rounding took brought back: exact but for the square of that.
#[inline]
pub fn normalized(rotation: DQuat) -> DQuat {
    rotation * (1.5 - 0.5 * rotation.length_squared())
}

/// What the curvature of the space of rotations adds to the energy of a joint at a rotation of this size: with
/// `g = phi/2 cot(phi/2)` the numbers `(1 - g) / phi^2`, and the derivative of that over `phi`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curving {
    pub(super) first: f64,
    pub(super) second: f64,
}

impl Curving {
    #[inline]
    pub(super) fn at(square: f64) -> Self {
        if is_small(square) { Self::small(square) } else { Self::large(square) }
    }

    /// `2 zeta(2k) / (2 pi)^(2k)`, the series of the cotangent.
    #[inline(always)]
    pub(super) fn small(square: f64) -> Self {
        const TERMS: [f64; 8] = [
            1.0 / 12.0,
            1.0 / 720.0,
            1.0 / 30_240.0,
            1.0 / 1_209_600.0,
            1.0 / 47_900_160.0,
            691.0 / 1_307_674_368_000.0,
            1.0 / 74_724_249_600.0,
            3617.0 / 10_670_622_842_880_000.0,
        ];
        let (mut first, mut second) = (0.0, 0.0);
        for term in TERMS.iter().rev() {
            second = second * square + first;
            first = first * square + term;
        }
        Curving { first, second: 2.0 * second }
    }

    #[inline(never)]
    fn large(square: f64) -> Self {
        let angle = libm::sqrt(square);
        let (sine, cosine) = sin_cos(0.5 * angle);
        let cotangent = cosine / sine;
        let first = (1.0 - 0.5 * angle * cotangent) / square;
        let slope = 0.5 * (cotangent - 0.5 * angle / (sine * sine));
        Curving { first, second: (-2.0 * first - slope / angle) / square }
    }
}

/// The orientation of an axis that leaves its base in this direction: +x of the segment along it, +y in its vertical
/// plane on the upper side. An azimuth turns the plane about the vertical, counter-clockwise seen from above.
pub fn orientation(elevation: Degrees, azimuth: Degrees) -> DQuat {
    let half = |angle: Degrees| Degrees(0.5 * angle.0).sin_cos();
    let ((sin_e, cos_e), (sin_a, cos_a)) = (half(elevation), half(azimuth));
    DQuat::from_xyzw(0.0, sin_a, 0.0, cos_a) * DQuat::from_xyzw(0.0, 0.0, sin_e, cos_e)
}

/// The direction of this elevation and azimuth, a unit vector.
pub fn direction(elevation: Degrees, azimuth: Degrees) -> DVec3 {
    let ((sin_e, cos_e), (sin_a, cos_a)) = (elevation.sin_cos(), azimuth.sin_cos());
    DVec3::new(cos_e * cos_a, sin_e, -cos_e * sin_a)
}

/// A rotation about the segment's own direction, +x.
pub fn roll(angle: Degrees) -> DQuat {
    let (sin, cos) = Degrees(0.5 * angle.0).sin_cos();
    DQuat::from_xyzw(sin, 0.0, 0.0, cos)
}

/// Longest rotation vector of a joint: beyond, the short way round is the other one.
pub const LONGEST: f64 = PI;

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    fn vectors() -> Vec<DVec3> {
        let mut vectors = Vec::new();
        for size in [0.0, 1e-300, 1e-12, 1e-3, 0.2, 0.24, 0.26, 0.49, 0.51, 1.0, 2.0, 3.1] {
            for direction in [DVec3::X, -DVec3::Z, DVec3::new(0.6, -0.48, 0.64)] {
                vectors.push(size * direction);
            }
        }
        vectors
    }

    #[test]
    fn log_undoes_exp() {
        for vector in vectors() {
            let rotation = exp(vector);
            assert!((rotation.length_squared() - 1.0).abs() <= 4.0 * f64::EPSILON, "{vector}");
            // Relative to the vector: small joint rotations keep their digits.
            assert!((log(rotation) - vector).length() <= 8.0 * f64::EPSILON * vector.length(), "{vector}");
            assert!((log(-rotation) - vector).length() <= 8.0 * f64::EPSILON * vector.length(), "{vector}");
        }
    }

    #[test]
    fn rodrigues_parameters_are_undone() {
        for vector in vectors() {
            let (rotation, longer) = (exp(vector), exp(-vector * (2.0 * PI / vector.length() - 1.0)));
            for rotation in [rotation, -rotation, longer] {
                if rotation.is_finite() {
                    let (parameters, undone) = (rodrigues(rotation), from_rodrigues(rodrigues(rotation)));
                    assert!(parameters.length() <= 1.0 + f64::EPSILON);
                    assert!((log(undone) - log(rotation)).length() <= 8.0 * f64::EPSILON * vector.length());
                }
            }
        }
    }

    #[test]
    fn the_two_ways_to_the_curving_meet() {
        for square in [0.2, 0.25, 0.3] {
            let (small, large) = (Curving::small(square), Curving::large(square));
            assert!((small.first - large.first).abs() < 1e-14, "{square}");
            assert!((small.second - large.second).abs() < 1e-12, "{square}");
        }
        // Its second is the first's derivative over the angle.
        for angle in [0.1, 0.6, 2.0_f64] {
            let step = 1e-5;
            let first = |angle: f64| Curving::at(angle * angle).first;
            let slope = (first(angle + step) - first(angle - step)) / (2.0 * step);
            assert!((Curving::at(angle * angle).second - slope / angle).abs() < 1e-9, "{angle}");
        }
    }

    #[test]
    fn orientations_point_where_they_say() {
        for (elevation, azimuth) in [(0.0, 0.0), (50.0, 0.0), (-60.0, 30.0), (90.0, 200.0), (10.0, -90.0)] {
            let (elevation, azimuth) = (Degrees(elevation), Degrees(azimuth));
            let orientation = orientation(elevation, azimuth);
            assert!((orientation * DVec3::X - direction(elevation, azimuth)).length() < 1e-15);
            // Its upper side lies in the vertical plane.
            assert!((orientation * DVec3::Z).y.abs() < 1e-15);
        }
    }
}
