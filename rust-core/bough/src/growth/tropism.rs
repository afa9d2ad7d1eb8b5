//! How new wood turns to the direction it seeks.

use glam::DVec3;

use crate::angle::wrap;
use crate::trigonometry::sin_cos;

/// From this strength (1/m) on a tropism is full: new wood takes the preferred direction.
const FULL_STRENGTH: f64 = 1e6;

/// Below this cosine of half the angle, new wood points exactly away from the preferred direction (to within
/// 2e-12 rad): a fixed point of equation 66, without a side to turn to. It keeps its direction.
const EXACTLY_AWAY: f64 = 1e-12;

/// The angle that remains between new wood and the preferred direction, of `angle` before (radians, signed),
/// after a turn of elasticity `lambda` (equation 73): `2 atan(tan(angle / 2) exp(-lambda))`.
///
/// Turns compose: `turned(turned(a, l), m) = turned(a, l + m)`.
///
/// ```
/// use bough::growth::turned;
/// let quarter = 90_f64.to_radians();
/// assert!((turned(quarter, 1.0).to_degrees() - 40.3950625791).abs() < 1e-9);
/// assert_eq!(turned(quarter, 0.0), quarter);
/// ```
pub fn turned(angle: f64, lambda: f64) -> f64 {
    let angle = wrap(angle);
    if lambda == 0.0 {
        return angle;
    }
    let (sin, cos) = sin_cos(0.5 * angle);
    if cos < EXACTLY_AWAY {
        return angle;
    }
    2.0 * libm::atan2(sin * libm::exp(-lambda), cos)
}

/// The elasticity of a joint of this length (m) under a tropism of this strength (1/m): `lambda = k l`.
pub(super) fn elasticity(strength: f64, length: f64) -> f64 {
    if strength >= FULL_STRENGTH { f64::INFINITY } else { strength * length }
}

/// The rotation vector that turns a direction in space towards another with this elasticity, in the plane of the two
/// (equation 73): no turn where they point exactly away from each other.
pub(super) fn turn_towards(from: DVec3, sought: DVec3, lambda: f64) -> DVec3 {
    let across = from.cross(sought);
    let (sin, cos) = (across.length(), from.dot(sought));
    if sin == 0.0 {
        return DVec3::ZERO;
    }
    let away = libm::atan2(sin, cos);
    across * ((away - turned(away, lambda)) / sin)
}
