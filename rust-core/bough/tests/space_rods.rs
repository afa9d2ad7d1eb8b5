//! Rods in space against published and closed-form solutions. Bough's y is up; tables with z up are turned into it.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "tests may stop, and round as they like")]

use bough::mechanics::{GROUND, Linkage, Settings, Status};
use bough::space::{Rods, Shape, Workspace, exp, gather, settle};
use glam::{DQuat, DVec3};

mod support;
use support::extrapolated;

/// A chain of equal rods along x whose joints are bent at rest: a rod of second order, half a segment at the clamp.
struct Chain {
    linkage: Linkage,
    shape: Shape,
    twist_ratio: f64,
}

impl Chain {
    /// `curvature` is the rest curvature vector in the rod's own frame: x twists, y and z bend.
    fn new(
        segments: u32,
        length: f64,
        stiffness: f64,
        twist_ratio: f64,
        curvature: DVec3,
        base: DQuat,
    ) -> Self {
        let mut chain = Chain { linkage: Linkage::default(), shape: Shape::default(), twist_ratio };
        let piece = length / f64::from(segments);
        for segment in 0..segments {
            let joint = if segment == 0 { 0.5 * piece } else { piece };
            let parent = if segment == 0 { GROUND } else { segment - 1 };
            chain.linkage.push(parent, piece, stiffness / joint, 0.0);
            let rest = exp(curvature * joint);
            chain.shape.push(if segment == 0 { base } else { DQuat::IDENTITY }, rest);
        }
        chain
    }

    fn rods(&self) -> Rods<'_> {
        Rods::new(&self.linkage, self.twist_ratio)
    }

    /// The tip under forces at the ends of the segments, raised from zero.
    fn tip(&mut self, mut force: Vec<DVec3>) -> DVec3 {
        gather(&self.linkage.parent, &mut force);
        let settings = Settings { tolerance: 1e-12 };
        let Chain { linkage, shape, twist_ratio } = self;
        let rods = Rods::new(linkage, *twist_ratio);
        let outcome = settle(rods, shape, &[], &force, &[], settings, &mut Workspace::default());
        assert_eq!((outcome.status, outcome.unstable_directions), (Status::Converged, Some(0)));
        self.end()
    }

    fn end(&self) -> DVec3 {
        let mut orientation = Vec::new();
        self.shape.orientations(self.rods(), &mut orientation);
        let pieces = orientation.iter().zip(&self.linkage.length);
        pieces.map(|(orientation, length)| *orientation * DVec3::X * *length).sum()
    }

    fn load_at_tip(&self, force: DVec3) -> Vec<DVec3> {
        let mut forces = vec![DVec3::ZERO; self.linkage.len()];
        *forces.last_mut().unwrap() = force;
        forces
    }

    /// Half of a segment's weight at each of its ends.
    fn weight(&self, per_length: f64) -> Vec<DVec3> {
        let half = 0.5 * per_length * self.linkage.length[0];
        let last = self.linkage.len() - 1;
        (0..=last).map(|rod| DVec3::NEG_Y * if rod == last { half } else { 2.0 * half }).collect()
    }
}

const CUTS: [u32; 6] = [16, 32, 64, 128, 256, 512];

/// The tip at infinitely many segments, and the order at which it gets there.
fn limit(tip: impl Fn(u32) -> DVec3) -> (DVec3, f64) {
    let tips: Vec<DVec3> = CUTS.iter().map(|&segments| tip(segments)).collect();
    let of = |axis: usize| {
        let values: Vec<f64> = tips.iter().map(|tip| tip[axis]).collect();
        extrapolated(&CUTS, &values, &[2, 4, 6])
    };
    let limit = DVec3::new(of(0), of(1), of(2));
    let off = |index: usize| (tips[index] - limit).length();
    (limit, (off(2) / off(3)).log2())
}

/// Bathe & Bolourchi (1979): an arc of 45 degrees and radius 100 in a plane, loaded across it. EI = 833333.3333, GJ = EI.
#[test]
fn the_bend_of_45_degrees() {
    let stiffness = 1e7 / 12.0;
    for (load, expected) in [
        (300.0, [58.779_685_39, 22.245_034_74, 40.188_283_84]),
        (600.0, [47.151_294_4, 15.685_078_16, 53.468_598_44]),
    ] {
        // In the plane x, z of the world the arc turns to -z; across it is up.
        let (tip, order) = limit(|segments| {
            let arc = DVec3::new(0.0, 1.0 / 100.0, 0.0);
            let length = 100.0 * 45_f64.to_radians();
            let mut chain = Chain::new(segments, length, stiffness, 1.0, arc, DQuat::IDENTITY);
            let force = chain.load_at_tip(DVec3::Y * load);
            chain.tip(force)
        });
        let found = [tip.x, -tip.z, tip.y];
        println!("45 degree bend, P = {load}, GJ = EI: {found:?}, order {order:.3}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 2e-6, "{found} {expected}");
        }
        assert!((order - 2.0).abs() < 0.02, "{order}");
    }
}

/// A horizontal quarter circle under its own weight. GJ = EI / 1.3.
#[test]
fn the_heavy_quarter_circle() {
    for (weight, expected) in [
        (1.0, [0.898_176_986, 0.889_128_942, -0.609_385_963]),
        (3.0, [0.621_705_632, 0.596_592_561, -1.084_736_116]),
    ] {
        let (tip, order) = limit(|segments| {
            let arc = DVec3::new(0.0, 1.0, 0.0);
            let length = 0.5 * std::f64::consts::PI;
            let mut chain = Chain::new(segments, length, 1.0, 1.0 / 1.3, arc, DQuat::IDENTITY);
            let force = chain.weight(weight);
            chain.tip(force)
        });
        let found = [tip.x, -tip.z, tip.y];
        println!("quarter circle, w = {weight}, GJ = EI/1.3: {found:?}, order {order:.3}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
        assert!((order - 2.0).abs() < 0.02, "{order}");
    }
}

/// The same under loads so small that it is linear, against the closed forms.
#[test]
fn the_quarter_circle_hardly_loaded() {
    let (ratio, small) = (0.4, 1e-5);
    let pi = std::f64::consts::PI;
    let quarter = |segments: u32| {
        Chain::new(segments, 0.5 * pi, 1.0, ratio, DVec3::new(0.0, 1.0, 0.0), DQuat::IDENTITY)
    };
    let (tip, _) = limit(|segments| {
        let mut chain = quarter(segments);
        let force = chain.load_at_tip(DVec3::NEG_Y * small);
        chain.tip(force)
    });
    let expected = small * (pi / 4.0 + (0.75 * pi - 2.0) / ratio);
    assert!((-tip.y / expected - 1.0).abs() < 1e-6, "{} {expected}", -tip.y);
    let (tip, _) = limit(|segments| {
        let mut chain = quarter(segments);
        let force = chain.weight(small);
        chain.tip(force)
    });
    let expected = small * (0.5 + (0.5 * pi - 1.0) * (0.5 * pi - 1.0) / (2.0 * ratio));
    assert!((-tip.y / expected - 1.0).abs() < 1e-6, "{} {expected}", -tip.y);
}

/// An arm b at right angles to the end of a: a bends, and twists under b.
#[test]
fn the_l_frame() {
    let (a, b, ratio, load) = (1.3, 0.7, 0.35, 1e-6);
    let pieces = 200_u32;
    let mut chain = Chain::new(pieces, a, 1.0, ratio, DVec3::ZERO, DQuat::IDENTITY);
    let (own, arm) = (a / f64::from(pieces), b / f64::from(pieces));
    // A massless node ends a, half a segment beyond its last joint; b starts half a segment before its first.
    chain.linkage.push(pieces - 1, 0.0, 2.0 / own, 0.0);
    chain.shape.push(DQuat::IDENTITY, DQuat::IDENTITY);
    for segment in 0..pieces {
        let joint = if segment == 0 { 0.5 * arm } else { arm };
        chain.linkage.push(pieces + segment, arm, 1.0 / joint, 0.0);
        let corner = if segment == 0 { exp(DVec3::Y * 0.5 * std::f64::consts::PI) } else { DQuat::IDENTITY };
        chain.shape.push(corner, DQuat::IDENTITY);
    }
    let force = chain.load_at_tip(DVec3::NEG_Y * load);
    let tip = chain.tip(force);
    let expected = load * (a * a * a / 3.0 + b * b * b / 3.0 + a * b * b / ratio);
    println!("L-frame: sag {:.9e}, closed form {expected:.9e}", -tip.y);
    // Second order in 200 pieces: 1 / 200^2 of the bending terms.
    assert!((-tip.y / expected - 1.0).abs() < 2e-5);
    let [_, twist] = chain.shape.moment(chain.rods(), 0);
    assert!((twist.abs() / (load * b) - 1.0).abs() < 1e-9, "{twist}");
}

/// Constant rest curvature and twist without load: a helix of radius k / (k^2 + t^2) and pitch 2 pi t / (k^2 + t^2).
#[test]
fn the_helix() {
    let (curvature, twist) = (3.0, 2.0);
    let square = curvature * curvature + twist * twist;
    let (radius, pitch) = (curvature / square, 2.0 * std::f64::consts::PI * twist / square);
    let turns = 3.0;
    let length = turns * 2.0 * std::f64::consts::PI / f64::sqrt(square);
    let chain = Chain::new(3000, length, 1.0, 0.3, DVec3::new(twist, 0.0, curvature), DQuat::IDENTITY);
    let mut orientation = Vec::new();
    chain.shape.orientations(chain.rods(), &mut orientation);
    // The axis of the helix is the direction of the rotation vector in the world.
    let axis = DVec3::new(twist, 0.0, curvature) / f64::sqrt(square);
    let tip = chain.end();
    assert!((tip.dot(axis) / (turns * pitch) - 1.0).abs() < 1e-5, "pitch {}", tip.dot(axis) / turns);
    assert!((tip - axis * tip.dot(axis)).length() < 1e-5, "whole turns end where they began");
    // Half a turn away the rod is two radii off.
    let half: DVec3 = orientation.iter().take(500).map(|turned| *turned * DVec3::X * (length / 3000.0)).sum();
    let across = (half - axis * half.dot(axis)).length();
    println!(
        "helix: radius {:.9} ({radius:.9}), pitch {:.9} ({pitch:.9})",
        0.5 * across,
        tip.dot(axis) / turns
    );
    assert!((across / (2.0 * radius) - 1.0).abs() < 1e-5);
}
