//! Angles that cross boundaries carry their unit in their type.

use core::f64::consts::{PI, TAU};

use crate::trigonometry::sin_cos;

/// An angle in degrees, as users write it.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Degrees(pub f64);

impl Degrees {
    /// The same angle in radians.
    pub fn radians(self) -> f64 {
        self.0 * (PI / 180.0)
    }

    /// The same direction from -180 to 180 degrees; exact.
    pub fn wrapped(self) -> Self {
        Degrees(libm::remainder(self.0, 360.0))
    }

    /// Sine and cosine, exact at the multiples of 90 degrees and exactly mirrored between quadrants.
    ///
    /// A vertical axis thus feels exactly no torque from its weight, and the plant at elevation 180 - e is
    /// the mirror image of the one at e to the last bit.
    pub fn sin_cos(self) -> (f64, f64) {
        let turned = self.0 % 360.0;
        // Ties to even: 45 and 135 degrees are then seen from the vertical and horizontal axes mirrored.
        let quadrant = libm::rint(turned / 90.0);
        let (sin, cos) = sin_cos(Degrees(turned - 90.0 * quadrant).radians());
        match libm::fmod(quadrant + 4.0, 4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

/// Brings an angle in radians into (-pi, pi].
pub fn wrap(angle: f64) -> f64 {
    let turned = angle - TAU * libm::round(angle / TAU);
    if turned <= -PI { turned + TAU } else { turned }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(Degrees(90.0).sin_cos(), (1.0, 0.0));
        assert_eq!(Degrees(-90.0).sin_cos(), (-1.0, 0.0));
        assert_eq!(Degrees(180.0).sin_cos(), (0.0, -1.0));
        assert_eq!(Degrees(-180.0).sin_cos(), (0.0, -1.0));
        assert_eq!(Degrees(270.0).sin_cos(), (-1.0, 0.0));
    }

    #[test]
    fn mirrored_elevations_are_mirrored_to_the_bit() {
        for tenth in 0..=1800 {
            let elevation = f64::from(tenth) / 8.0 - 90.0;
            let (sin, cos) = Degrees(elevation).sin_cos();
            let (mirror_sin, mirror_cos) = Degrees(180.0 - elevation).sin_cos();
            assert_eq!((sin, cos), (mirror_sin, -mirror_cos), "{elevation} degrees");
            assert!((sin * sin + cos * cos - 1.0).abs() < 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn wrapped_angles_lie_above_minus_pi_and_not_above_pi() {
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(PI), PI);
        assert!((wrap(7.0) - (7.0 - TAU)).abs() < 1e-15);
    }
}
