//! Loops over all rods in which no rod waits for another.
//!
//! Slices that a function is given cannot overlap, so compilers make vector code of these loops without checks. Inlined, or
//! over arrays that are fields of one struct, they lose that knowledge: where code is compiled for size, and so without such
//! checks, that is a third of the time of growth.

/// External torque of each rod's own load about its base, and the diagonal of the load's Hessian (equation 8).
#[inline(never)]
pub(super) fn torques(
    [length, x, y]: [&[f64]; 3],
    [sine, cosine]: [&[f64]; 2],
    torque: &mut [f64],
    geometric: &mut [f64],
) {
    let rods = torque.len();
    // Slices of one length: their bounds are checked once.
    let (length, x, y) = (&length[..rods], &x[..rods], &y[..rods]);
    let (sine, cosine, geometric) = (&sine[..rods], &cosine[..rods], &mut geometric[..rods]);
    for rod in 0..rods {
        torque[rod] = length[rod] * (cosine[rod] * y[rod] - sine[rod] * x[rod]);
        geometric[rod] = length[rod] * (cosine[rod] * x[rod] + sine[rod] * y[rod]);
    }
}

/// What the springs leave over of the torques.
#[inline(never)]
pub(super) fn residuals(stiffness: &[f64], deviation: &[f64], torque: &[f64], residual: &mut [f64]) {
    let rods = residual.len();
    let (stiffness, deviation, torque) = (&stiffness[..rods], &deviation[..rods], &torque[..rods]);
    for rod in 0..rods {
        residual[rod] = stiffness[rod] * deviation[rod] - torque[rod];
    }
}

/// `after - before`.
#[inline(never)]
pub(crate) fn differences(after: &[f64], before: &[f64], difference: &mut [f64]) {
    let rods = difference.len();
    let (after, before) = (&after[..rods], &before[..rods]);
    for rod in 0..rods {
        difference[rod] = after[rod] - before[rod];
    }
}

/// `2 last - earlier`, written over `last`: changes carried on in a straight line.
#[inline(never)]
pub(crate) fn carry_on(last: &mut [f64], earlier: &[f64]) {
    let rods = usize::min(last.len(), earlier.len());
    let (last, earlier) = (&mut last[..rods], &earlier[..rods]);
    for rod in 0..rods {
        last[rod] = 2.0 * last[rod] - earlier[rod];
    }
}

/// Largest size of the numbers; NaN when any is. Four maxima side by side: one would wait for itself.
#[inline(never)]
pub(super) fn largest(numbers: &[f64]) -> f64 {
    let mut chunks = numbers.chunks_exact(4);
    // A maximum forgets NaN, a sum does not.
    let (mut lanes, mut sums) = ([0.0_f64; 4], [0.0_f64; 4]);
    for chunk in &mut chunks {
        for lane in 0..4 {
            let size = chunk[lane].abs();
            lanes[lane] = if size > lanes[lane] { size } else { lanes[lane] };
            sums[lane] += size;
        }
    }
    let rest = chunks.remainder();
    let sum: f64 = sums.iter().sum::<f64>() + rest.iter().map(|number| number.abs()).sum::<f64>();
    if sum.is_nan() { sum } else { lanes.iter().chain(rest).fold(0.0, |most, number| most.max(number.abs())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A search that has overflowed ends by what its largest number is: NaN must come through from every place, and a number
    /// without bound, which is larger than all others, must not become NaN on the way.
    #[test]
    fn the_largest_number_is_nan_where_any_is_and_nowhere_else() {
        for count in 1..10 {
            for place in 0..count {
                let mut numbers = [0.5_f64; 10];
                for size in [2.0, f64::MAX, f64::INFINITY] {
                    numbers[place] = -size;
                    assert_eq!(largest(&numbers[..count]), size, "{place} of {count}");
                }
                numbers[place] = f64::NAN;
                assert!(largest(&numbers[..count]).is_nan(), "{place} of {count}");
            }
        }
    }
}
