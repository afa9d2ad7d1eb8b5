//! The paper's relaxation to the letter (equations 12 to 20): one damping constant for all joints, explicit Euler steps.
//!
//! The paper states neither constant nor step. Here the damping is half of what is critical for the joint at the base by itself: as all
//! joints swing together, more makes them creep, and less hardly helps (tried). The lightest joint, that of the tip, then bounds the step:
//! beyond `2 I / b` explicit Euler explodes.
//! Steps to rest grow like `n^3`, work like `n^4`. (The core's own relaxation gives each joint its own damping: `n^2.5`.)

use bough::mechanics::{Linkage, Loads};

use crate::case;

/// Of the largest stable step.
const SHARE: f64 = 0.9;

pub struct Euler {
    linkage: Linkage,
    loads: Loads,
    velocity: Vec<f64>,
    acceleration: Vec<f64>,
    damping: f64,
    step: f64,
    mass: f64,
}

/// What lies beyond a joint, seen from there: torque, mass and its moments.
#[derive(Default)]
struct Beyond {
    torque: f64,
    mass: f64,
    first: [f64; 2],
    second: f64,
}

impl Euler {
    pub fn new(segments: usize) -> Self {
        let (linkage, loads) = case::rod(segments);
        let mass = 1.0 / segments as f64;
        let mut relaxation = Euler {
            velocity: vec![0.0; segments],
            acceleration: vec![0.0; segments],
            damping: 0.0,
            step: 0.0,
            mass,
            linkage,
            loads,
        };
        let length = relaxation.linkage.length[0];
        let slowest: f64 = (1..=segments).map(|node| mass * (node as f64 * length).powi(2)).sum();
        relaxation.damping = (slowest / length).sqrt();
        let lightest = 0.5 * mass * length * length;
        relaxation.step = SHARE * 2.0 * lightest / relaxation.damping;
        relaxation
    }

    /// Steps until no joint has more than `tolerance` of the largest torque left over; returns how many steps it took.
    pub fn relax(&mut self, tolerance: f64) -> u64 {
        let mut steps = 0;
        while !self.accelerate(tolerance) {
            for (joint, velocity) in self.velocity.iter_mut().enumerate() {
                self.linkage.deviation[joint] += *velocity * self.step;
                *velocity += self.acceleration[joint] * self.step;
            }
            steps += 1;
        }
        steps
    }

    /// Equations 5 to 16, from the tip to the base; whether the joints are at rest.
    fn accelerate(&mut self, tolerance: f64) -> bool {
        let rods = self.linkage.len();
        let mut angle: f64 = self.linkage.deviation.iter().sum();
        let mut beyond = Beyond::default();
        let (mut most, mut left) = (0.0_f64, 0.0_f64);
        for rod in (0..rods).rev() {
            let (sine, cosine) = angle.sin_cos();
            let length = self.linkage.length[rod];
            let (x, y) = (length * cosine, length * sine);
            beyond.torque += x * self.loads.y[rod] - y * self.loads.x[rod];
            beyond.mass += if rod + 1 == rods { 0.5 * self.mass } else { self.mass };
            let [first_x, first_y] = beyond.first;
            beyond.second += 2.0 * (x * first_x + y * first_y) + beyond.mass * length * length;
            beyond.first = [first_x + beyond.mass * x, first_y + beyond.mass * y];
            let spring = self.linkage.stiffness[rod] * self.linkage.deviation[rod];
            let drag = self.damping * self.velocity[rod];
            self.acceleration[rod] = (beyond.torque - spring - drag) / beyond.second;
            most = most.max(beyond.torque.abs());
            // A joint can pass through balance at speed: its drag counts too.
            left = left.max((beyond.torque - spring).abs()).max(drag.abs());
            angle -= self.linkage.deviation[rod];
        }
        left <= tolerance * most
    }
}
