//! The cross-section of a segment: a bundle of concentric pipes of equal area.

use core::f64::consts::PI;

/// A solid round section that was born with one pipe and has gained others of the same area since.
///
/// The k-th pipe has `(2k - 1)` times the first one's second moment of area (equations 42 and 43 with
/// `R_k = R_1 sqrt(k)`), so `n` pipes have `n^2` times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Radius at birth, of the first pipe, m.
    pub birth_radius: f64,
    /// How many pipes there are.
    pub pipes: u32,
}

impl Section {
    /// A section of one pipe.
    pub fn new(birth_radius: f64) -> Self {
        Section { birth_radius, pipes: 1 }
    }

    /// Outer radius, m: `R_1 sqrt(n)`.
    pub fn radius(self) -> f64 {
        self.birth_radius * libm::sqrt(f64::from(self.pipes))
    }

    /// Cross-sectional area, m2: `n` times that of one pipe.
    pub fn area(self) -> f64 {
        PI * self.birth_radius * self.birth_radius * f64::from(self.pipes)
    }

    /// Second moment of area of the whole bundle, m4 (equations 39, 42, 43).
    pub fn second_moment_of_area(self) -> f64 {
        let pipes = f64::from(self.pipes);
        let square = self.birth_radius * self.birth_radius;
        pipes * pipes * (0.25 * PI * square * square)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hollow_pipes_add_up_to_the_solid_section() {
        let mut sum = 0.0;
        for pipes in 1..=50 {
            let outer = Section { birth_radius: 0.003, pipes };
            let inner = if pipes == 1 { 0.0 } else { Section { pipes: pipes - 1, ..outer }.radius() };
            let fourth = |radius: f64| radius * radius * radius * radius;
            // Equation 43.
            sum += 0.25 * PI * (fourth(outer.radius()) - fourth(inner));
            let whole = outer.second_moment_of_area();
            assert!((sum - whole).abs() <= 1e-13 * whole, "{pipes} pipes");
            assert!((outer.area() - PI * outer.radius() * outer.radius()).abs() <= 1e-15 * outer.area());
        }
    }
}
