//! What a section bears, and where a plant breaks.

use core::f64::consts::PI;

use super::section::Section;

impl Section {
    /// Largest fibre stress of a solid section without memory under a bending and a twisting moment (N m), Pa.
    ///
    /// Bending stretches and twisting shears the surface most, at the same place; see [`largest_principal_stress`].
    ///
    /// ```
    /// use bough::plant::Section;
    /// let twig = Section::new(0.005);
    /// let bent = 4.0 * 2.0 / (core::f64::consts::PI * 0.005_f64.powi(3));
    /// assert!((twig.fibre_stress(-2.0, 0.0) / bent - 1.0).abs() < 1e-15);
    /// // Twisting alone: its principal stress is the shear stress, half as much as in bending.
    /// assert!((twig.fibre_stress(0.0, 2.0) / (0.5 * bent) - 1.0).abs() < 1e-15);
    /// ```
    pub fn fibre_stress(self, bending_moment: f64, twisting_moment: f64) -> f64 {
        largest_principal_stress(
            bending_moment * self.radius() / self.second_moment_of_area(),
            self.shear_stress(twisting_moment),
        )
    }

    /// Shear stress that a twisting moment (N m) makes at the surface, `2 T / (pi R^3)`, Pa.
    pub fn shear_stress(self, twisting_moment: f64) -> f64 {
        let radius = self.radius();
        2.0 * twisting_moment / (PI * radius * radius * radius)
    }
}

/// What bending stress and shear stress at the surface come to together: the larger principal stress,
/// `s / 2 + sqrt((s / 2)^2 + t^2)` (Rankine). Green wood breaks by its stretched or crushed fibres, and of the usual
/// criteria this is the one that is plain bending without a twist.
pub fn largest_principal_stress(bending_stress: f64, shear_stress: f64) -> f64 {
    let half = 0.5 * bending_stress.abs();
    if shear_stress == 0.0 { 2.0 * half } else { half + libm::hypot(half, shear_stress) }
}

/// The segment that breaks first: that with the largest fibre stress, the lowest of equals, and by how much its modulus of
/// rupture exceeds it. `None` where nothing is stressed.
pub fn weakest(stress: &[f64], modulus_of_rupture: f64) -> Option<(u32, f64)> {
    let mut most = 0.0;
    let mut found = None;
    for (segment, &stress) in stress.iter().enumerate() {
        if stress > most {
            most = stress;
            found = Some(segment as u32);
        }
    }
    found.map(|segment| (segment, modulus_of_rupture / most))
}
