//! The floor of all solvers of this model, to measure others against in the same build.

use bough::trigonometry::small_sin_cos;

/// One sine, one cosine and ten flops for each number.
pub(crate) fn floor(angles: &[f64], sums: &mut [f64]) {
    for (angle, sum) in angles.iter().zip(sums) {
        let (sine, cosine) = small_sin_cos(*angle);
        let torque = 0.7 * cosine - 0.3 * sine;
        let stiffness = 0.3 * cosine + 0.7 * sine;
        *sum = 0.5 * *sum + torque * stiffness + 1.5;
    }
}
