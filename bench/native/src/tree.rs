//! A tree for the solver alone: axes that fork, generation after generation, so that what is far from the ground is far in memory.

use bough::mechanics::{GROUND, Linkage, Loads};
use bough::space::{Shape, exp};
use glam::{DQuat, DVec3};

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

/// Each fork of the tree in space is turned about its parent by this, radians.
const ROLL: f64 = 1.3;

/// The same tree with its forks turned, at rest, and the forces beyond each rod.
pub fn tree_in_space(rods: usize) -> (Linkage, Shape, Vec<DVec3>) {
    let (linkage, loads) = tree(rods);
    let mut shape = Shape::default();
    for (rod, rest) in linkage.rest.iter().enumerate() {
        let start = if rod == 0 { exp(DVec3::Z * ELEVATION) } else { exp(DVec3::Z * *rest) };
        let roll = if *rest == 0.0 { DQuat::IDENTITY } else { exp(DVec3::X * ROLL) };
        shape.push(roll * start, DQuat::IDENTITY);
    }
    // Gathered already, in the frame of the base direction; of a weight only the size is needed.
    let weight = loads.x.iter().zip(&loads.y).map(|(x, y)| DVec3::NEG_Y * x.hypot(*y));
    (linkage, shape, weight.collect())
}

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
