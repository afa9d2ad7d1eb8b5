//! The gradient, the Hessian and its elimination against finite differences and dense linear algebra, at random states.

#![allow(clippy::needless_range_loop, reason = "tests read like the formula")]

use alloc::vec;
use alloc::vec::Vec;

use glam::{DQuat, DVec3};

use super::balance::{Balance, Damping};
use super::element::{Spring, Symmetric};
use super::equilibrium::{Workspace, energy_rounding, settle};
use super::rotation::{exp, log};
use super::shape::{Rods, Shape, gather};
use crate::mechanics::{GROUND, Settings};

/// Numbers that look random and are the same in every run (Knuth's MMIX generator).
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn within(&mut self, size: f64) -> f64 {
        size * (2.0 * self.number() - 1.0)
    }

    pub(super) fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.within(size), self.within(size), self.within(size))
    }
}

/// A random tree in a random state, with random loads.
pub(super) struct Tree {
    parent: Vec<u32>,
    length: Vec<f64>,
    stiffness: Vec<f64>,
    twist_ratio: f64,
    pub(super) shape: Shape,
    pub(super) force: Vec<DVec3>,
}

impl Tree {
    pub(super) fn random(random: &mut Random, count: usize, bent: f64, load: f64) -> Self {
        let mut tree = Tree {
            parent: Vec::new(),
            length: Vec::new(),
            stiffness: Vec::new(),
            twist_ratio: 0.1 + 2.0 * random.number(),
            shape: Shape::default(),
            force: Vec::new(),
        };
        for rod in 0..count {
            let bearer = (random.number() * rod as f64) as u32;
            tree.parent.push(if rod == 0 { GROUND } else { bearer });
            tree.length.push(if random.number() < 0.1 { 0.0 } else { 0.2 + random.number() });
            tree.stiffness.push(0.5 + 2.0 * random.number());
            tree.shape.push(exp(random.vector(1.0)), exp(random.vector(0.5)));
            tree.shape.deviation[rod] = random.vector(bent).to_array();
            tree.force.push(random.vector(load));
        }
        gather(&tree.parent, &mut tree.force);
        tree
    }

    pub(super) fn rods(&self) -> Rods<'_> {
        let Tree { parent, length, stiffness, twist_ratio, .. } = self;
        Rods { parent, length, stiffness, twist_ratio: *twist_ratio, plane: None }
    }

    /// The shape with every rod turned by its own rotation vector in the world's frame.
    fn turned(&self, turns: &[DVec3]) -> Shape {
        let (mut before, mut shape) = (Vec::new(), self.shape.clone());
        self.shape.orientations(self.rods(), &mut before);
        for rod in 0..turns.len() {
            let after = exp(turns[rod]) * before[rod];
            let base = match self.parent[rod] {
                GROUND => DQuat::IDENTITY,
                parent => exp(turns[parent as usize]) * before[parent as usize],
            };
            shape.deviation[rod] = log((base * shape.rest[rod]).conjugate() * after).to_array();
        }
        shape
    }

    /// The energy by its definition.
    fn energy(&self, shape: &Shape) -> f64 {
        let mut orientation = Vec::new();
        shape.orientations(self.rods(), &mut orientation);
        (0..self.parent.len())
            .map(|rod| {
                let [across, twist] = shape.across(rod, DVec3::from_array(shape.deviation[rod]));
                let spring = 0.5 * self.stiffness[rod] * (self.twist_ratio * twist * twist + across * across);
                spring - self.length[rod] * (orientation[rod] * DVec3::X).dot(self.force[rod])
            })
            .sum()
    }

    /// The gradient in the rods' absolute turns, from the parts that the elimination uses.
    fn gradient(&self, shape: &Shape) -> Vec<f64> {
        let mut orientation = Vec::new();
        shape.orientations(self.rods(), &mut orientation);
        let mut gradient = vec![DVec3::ZERO; self.parent.len()];
        for rod in 0..self.parent.len() {
            let (spring, arm) = self.parts(shape, &orientation, rod);
            gradient[rod] += spring.moment - arm.cross(self.force[rod]);
            if self.parent[rod] != GROUND {
                gradient[self.parent[rod] as usize] -= spring.moment;
            }
        }
        gradient.iter().flat_map(|vector| vector.to_array()).collect()
    }

    fn parts(&self, shape: &Shape, orientation: &[DQuat], rod: usize) -> (Spring, DVec3) {
        let along = orientation[rod] * DVec3::X;
        let wood = orientation[rod] * DVec3::from_array(shape.axis[rod]);
        let bent = orientation[rod] * DVec3::from_array(shape.deviation[rod]);
        (Spring::new(self.stiffness[rod], self.twist_ratio, bent, wood), self.length[rod] * along)
    }

    /// The Hessian, dense, from the same parts.
    pub(super) fn hessian(&self) -> Vec<Vec<f64>> {
        let mut orientation = Vec::new();
        self.shape.orientations(self.rods(), &mut orientation);
        let mut hessian = vec![vec![0.0; 3 * self.parent.len()]; 3 * self.parent.len()];
        for rod in 0..self.parent.len() {
            let (Spring { moment, hessian: spring, .. }, arm) = self.parts(&self.shape, &orientation, rod);
            let pull = self.force[rod];
            let half = [[0.0, -moment.z, moment.y], [moment.z, 0.0, -moment.x], [-moment.y, moment.x, 0.0]];
            for a in 0..3 {
                for b in 0..3 {
                    let identity = if a == b { arm.dot(pull) } else { 0.0 };
                    let load = identity - 0.5 * (arm[a] * pull[b] + arm[b] * pull[a]);
                    let own = entry(&spring, a, b);
                    hessian[3 * rod + a][3 * rod + b] += own + load;
                    if self.parent[rod] != GROUND {
                        let below = 3 * self.parent[rod] as usize;
                        hessian[below + a][below + b] += own;
                        // The commutator: - 1/2 M (omega_p x omega).
                        hessian[3 * rod + a][below + b] -= own + 0.5 * half[a][b];
                        hessian[below + a][3 * rod + b] -= own - 0.5 * half[a][b];
                    }
                }
            }
        }
        hessian
    }
}

fn entry(matrix: &Symmetric, a: usize, b: usize) -> f64 {
    matrix[if a == b { a } else { a + b + 2 }]
}

fn vectors(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}

#[test]
fn the_gradient_is_the_energys() {
    let mut random = Random(1);
    for case in 0..60 {
        let tree = Tree::random(&mut random, 1 + case % 7, [0.05, 0.6, 1.5][case % 3], 1.0);
        let gradient = tree.gradient(&tree.shape);
        let size = gradient.iter().fold(1.0_f64, |most, number| most.max(number.abs()));
        for unknown in 0..gradient.len() {
            let energy = |step: f64| {
                let mut turns = vec![0.0; gradient.len()];
                turns[unknown] = step;
                tree.energy(&tree.turned(&vectors(&turns)))
            };
            // Fourth order, so that neither cutting off nor rounding exceeds 1e-9.
            let (h, two) = (2e-3, 4e-3);
            let slope = (8.0 * (energy(h) - energy(-h)) - (energy(two) - energy(-two))) / (12.0 * h);
            assert!(
                (slope - gradient[unknown]).abs() < 1e-9 * size,
                "case {case}: {slope} {}",
                gradient[unknown]
            );
        }
    }
}

#[test]
fn the_hessian_is_the_energys() {
    let mut random = Random(2);
    let mut worst = 0.0_f64;
    for case in 0..40 {
        let tree = Tree::random(&mut random, 1 + case % 5, [0.05, 0.6, 1.5][case % 3], 1.0);
        let hessian = tree.hessian();
        let size = hessian.iter().flatten().fold(1.0_f64, |most, number| most.max(number.abs()));
        let unknowns = hessian.len();
        for a in 0..unknowns {
            for b in 0..=a {
                assert!((hessian[a][b] - hessian[b][a]).abs() <= 1e-14 * size, "not symmetric");
                let energy = |by_a: f64, by_b: f64| {
                    let mut turns = vec![0.0; unknowns];
                    turns[a] += by_a;
                    turns[b] += by_b;
                    tree.energy(&tree.turned(&vectors(&turns)))
                };
                // Second differences at two steps, extrapolated: cut off at h^4, rounded by 1e-16 / h^2.
                let second =
                    |h: f64| (energy(h, h) - energy(h, -h) - energy(-h, h) + energy(-h, -h)) / (4.0 * h * h);
                let found = (4.0 * second(2e-3) - second(4e-3)) / 3.0;
                worst = worst.max((found - hessian[a][b]).abs() / size);
            }
        }
    }
    std::println!("Hessian against finite differences: {worst:.1e} of its largest entry");
    assert!(worst < 1e-8, "{worst:e}");
}

#[test]
fn the_elimination_solves_the_dense_system() {
    let mut random = Random(3);
    for case in 0..60 {
        let mut tree =
            Tree::random(&mut random, 1 + case % 9, [0.05, 0.5, 1.0][case % 3], [0.1, 1.0][case % 2]);
        let (gradient, hessian) = (tree.gradient(&tree.shape), tree.hessian());
        let size = gradient.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
        let mut balance = Balance::default();
        let mut shape = tree.shape.clone();
        balance.orient(tree.rods(), &shape);
        let (before, force) = (balance.orientation.clone(), tree.force.clone());
        balance.weigh(tree.rods(), &shape, &force, Damping::default());
        assert!((balance.energy - tree.energy(&tree.shape)).abs() <= 1e-13 * balance.energy_size);
        // A step so small that what it turns is linear in it to 1e-8.
        let scale = 1e-8 / (1.0 + size);
        balance.advance(tree.rods(), &mut shape, scale, f64::INFINITY);
        let turns: Vec<f64> = (0..before.len())
            .flat_map(|rod| log(balance.orientation[rod] * before[rod].conjugate()).to_array())
            .map(|turn| turn / scale)
            .collect();
        let largest = turns.iter().fold(1.0_f64, |most, number| most.max(number.abs()));
        for row in 0..gradient.len() {
            let product: f64 = hessian[row].iter().zip(&turns).map(|(entry, turn)| entry * turn).sum();
            assert!((product + gradient[row]).abs() < 3e-6 * (size + largest), "case {case}, row {row}");
        }
        // The orientations that were turned along are those of the deviations.
        tree.shape = shape;
        let mut anew = Vec::new();
        tree.shape.orientations(tree.rods(), &mut anew);
        for (anew, along) in anew.iter().zip(&balance.orientation) {
            assert!((*anew - *along).length() < 1e-14);
        }
    }
}

/// Eigenvalues of a symmetric matrix, by Jacobi's rotations: nothing of the elimination is in it.
fn eigenvalues(mut matrix: Vec<Vec<f64>>) -> Vec<f64> {
    let n = matrix.len();
    for _ in 0..60 {
        for p in 0..n {
            for q in p + 1..n {
                if matrix[p][q].abs() < 1e-300 {
                    continue;
                }
                let ratio = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
                let tangent = ratio.signum() / (ratio.abs() + libm::sqrt(ratio * ratio + 1.0));
                let cosine = 1.0 / libm::sqrt(tangent * tangent + 1.0);
                let sine = tangent * cosine;
                for row in &mut matrix {
                    let (a, b) = (row[p], row[q]);
                    (row[p], row[q]) = (cosine * a - sine * b, sine * a + cosine * b);
                }
                for column in 0..n {
                    let (a, b) = (matrix[p][column], matrix[q][column]);
                    (matrix[p][column], matrix[q][column]) = (cosine * a - sine * b, sine * a + cosine * b);
                }
            }
        }
    }
    (0..n).map(|i| matrix[i][i]).collect()
}

#[test]
fn stability_agrees_with_the_eigenvalues_of_200_random_plants() {
    let mut random = Random(4);
    let (mut checked, mut unstable) = (0, 0);
    while checked < 200 {
        let count = 1 + (random.number() * 7.0) as usize;
        let (bent, load) = (random.number(), 2.0 * random.number());
        let tree = Tree::random(&mut random, count, bent, load);
        let eigenvalues = eigenvalues(tree.hessian());
        let size = eigenvalues.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        // Nearer to zero than this the sign of an eigenvalue is rounding.
        if eigenvalues.iter().any(|value| value.abs() < 1e-9 * size) {
            continue;
        }
        let negative = eigenvalues.iter().filter(|&&value| value < 0.0).count() as u32;
        let mut balance = Balance::default();
        balance.orient(tree.rods(), &tree.shape);
        balance.weigh(tree.rods(), &tree.shape, &tree.force, Damping::default());
        assert_eq!(balance.unstable, negative, "plant {checked}");
        checked += 1;
        unstable += u32::from(negative > 0);
    }
    std::println!("200 random plants, {unstable} of them unstable: as many negative eigenvalues as counted");
    assert!(unstable > 20 && unstable < 180, "{unstable}");
}

/// In every accepted iteration at constant load the energy falls, or rises by no more than its rounding: while growing, and
/// when a floppy tree is let go from its unloaded shape.
#[test]
fn energy_falls_in_every_accepted_iteration() {
    let mut random = Random(5);
    let (mut accepted, mut worst) = (0, f64::NEG_INFINITY);
    for case in 0..120 {
        let load = [0.05, 0.5, 5.0, 50.0][case % 4];
        let mut tree = Tree::random(&mut random, 2 + case % 40, 0.0, load);
        let (force, mut shape) = (tree.force.clone(), core::mem::take(&mut tree.shape));
        let mut workspace = Workspace::default();
        let settings = Settings { tolerance: 1e-10 };
        settle(tree.rods(), &mut shape, &[], &force, &[], settings, &mut workspace);
        for [before, after, size] in &workspace.trace {
            let allowed = energy_rounding(*size, shape.rest.len());
            assert!(after - before <= allowed, "case {case}: {before} {after}");
            worst = worst.max((after - before) / allowed);
            accepted += 1;
        }
    }
    std::println!(
        "{accepted} accepted iterations: the energy rose by at most {worst:.3} of the bound of its rounding"
    );
    assert!(accepted > 500);
}
