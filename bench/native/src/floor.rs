//! What no solver of this model can do without: of each segment one sine, one cosine and ten flops.
//!
//! Both are by polynomials on [-pi/4, pi/4], after taking off quarter turns, with an error of about one rounding: the coefficients are
//! those of fdlibm's `k_sin.c` and `k_cos.c`. There is no branch, so that compilers make vector code of the loop.

use std::f64::consts::FRAC_2_PI;

/// pi/2 in two parts: exact for the few turns that plants make.
const HALF_PI: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];
/// Adding and subtracting this rounds to a whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;

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

#[inline(always)]
fn sin_cos(angle: f64) -> (f64, f64) {
    let shifted = angle * FRAC_2_PI + ROUND;
    let (quarters, bits) = (shifted - ROUND, shifted.to_bits());
    let x = angle - quarters * HALF_PI[0] - quarters * HALF_PI[1];
    let z = x * x;
    let odd_part = SINE[1] + z * (SINE[2] + z * (SINE[3] + z * (SINE[4] + z * SINE[5])));
    let sine = (x + x * z * (SINE[0] + z * odd_part)).to_bits();
    let even_part =
        COSINE[0] + z * (COSINE[1] + z * (COSINE[2] + z * (COSINE[3] + z * (COSINE[4] + z * COSINE[5]))));
    let half = 0.5 * z;
    let whole = 1.0 - half;
    let cosine = (whole + ((1.0 - whole - half) + z * z * even_part)).to_bits();
    let odd = 0_u64.wrapping_sub(bits & 1);
    (
        f64::from_bits(((sine & !odd) | (cosine & odd)) ^ ((bits & 2) << 62)),
        f64::from_bits(((cosine & !odd) | (sine & odd)) ^ ((bits.wrapping_add(1) & 2) << 62)),
    )
}

/// One sine, one cosine and ten flops for each angle.
#[inline(never)]
pub fn floor(angles: &[f64], sums: &mut [f64]) {
    for (angle, sum) in angles.iter().zip(sums) {
        let (sine, cosine) = sin_cos(*angle);
        // Ten flops, of which none can be left out: a torque and a Hessian term have as many.
        let torque = 0.7 * cosine - 0.3 * sine;
        let stiffness = 0.3 * cosine + 0.7 * sine;
        *sum = 0.5 * *sum + torque * stiffness + 1.5;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_is_that_of_rounding() {
        for step in -400_000..=400_000 {
            let angle = f64::from(step) * 1.7e-5;
            let (sine, cosine) = sin_cos(angle);
            assert!((sine - angle.sin()).abs() <= 2.3e-16, "sin {angle}");
            assert!((cosine - angle.cos()).abs() <= 2.3e-16, "cos {angle}");
        }
    }
}
