//! A tree for the solver alone: axes that fork, generation after generation, so that what is far from the ground is far in memory.

use bough::mechanics::{GROUND, Linkage, Loads};

/// Rods of an axis.
const RODS: usize = 12;
/// Diameter of a child over that of its parent: two alike by the law of 2.49.
const GIRTH: f64 = 0.757_014_885_699;
/// Half the angle between two children, radians.
const SPREAD: f64 = 0.51;
const LENGTH: f64 = 0.02;
/// Radius of the first axis, m; Young's modulus, Pa; weight of wood, N/m3.
const RADIUS: f64 = 0.05;
const MODULUS: f64 = 5e9;
const WEIGHT: f64 = 9_810.0;
/// Of the first axis above the horizontal, radians.
const ELEVATION: f64 = 1.2;

/// A tree of about so many rods, at rest.
pub fn tree(rods: usize) -> (Linkage, Loads) {
    let generations = ((rods as f64 / RODS as f64 + 1.0).log2().round() as u32).max(1);
    let mut linkage = Linkage::default();
    let mut radii: Vec<f64> = Vec::new();
    for generation in 0..generations {
        let radius = RADIUS * GIRTH.powi(generation as i32);
        let stiffness = MODULUS * std::f64::consts::PI * radius.powi(4) / 4.0 / LENGTH;
        for axis in 0..1_usize << generation {
            // The parent's axis is the one of half this number in the generation before.
            let bearer = ((1_usize << generation) / 2 + axis / 2)
                .wrapping_sub(1)
                .wrapping_mul(RODS)
                .wrapping_add(RODS - 1);
            for rod in 0..RODS {
                let parent = match (generation, rod) {
                    (0, 0) => GROUND,
                    (_, 0) => bearer as u32,
                    _ => linkage.len() as u32 - 1,
                };
                let fork = if rod > 0 || generation == 0 { 0.0 } else { [SPREAD, -SPREAD][axis % 2] };
                linkage.push(parent, LENGTH, stiffness, fork);
                radii.push(radius);
            }
        }
    }
    let mut loads = Loads::none(linkage.len());
    for (rod, radius) in radii.iter().enumerate() {
        let weight = WEIGHT * std::f64::consts::PI * radius * radius * LENGTH;
        loads.x[rod] = -weight * ELEVATION.sin();
        loads.y[rod] = -weight * ELEVATION.cos();
    }
    loads.gather(&linkage);
    (linkage, loads)
}
