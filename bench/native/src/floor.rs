//! What no solver of this model can do without: of each segment one sine, one cosine and ten flops.
//!
//! Sine and cosine are the core's own: no faster ones of that accuracy (2.3e-16, tested there) were found, and slower ones would
//! flatter every ratio.

use bough::trigonometry::small_sin_cos;

/// One sine, one cosine and ten flops for each angle.
#[inline(never)]
pub fn floor(angles: &[f64], sums: &mut [f64]) {
    for (angle, sum) in angles.iter().zip(sums) {
        let (sine, cosine) = small_sin_cos(*angle);
        // Ten flops, of which none can be left out: a torque and a Hessian term have as many.
        let torque = 0.7 * cosine - 0.3 * sine;
        let stiffness = 0.3 * cosine + 0.7 * sine;
        *sum = 0.5 * *sum + torque * stiffness + 1.5;
    }
}
