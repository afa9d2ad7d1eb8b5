//! How new segments are attached: at the tip of a growing axis, or as the first ones of two children at a fork.

use glam::{DQuat, DVec3};

use super::axis::{Axis, STEM};
use super::pipes::FirstPipe;
use super::state::Growth;
use super::tropism::{elasticity, turned};
use super::wood::Wood;
use crate::angle::{Degrees, wrap};
use crate::mechanics::GROUND;
use crate::params::{Discretization, Params, sought_in_plane};
use crate::plant::Section;
use crate::space::{exp, normalized, roll};

impl Growth {
    /// Every growing axis gains a segment; every axis that was full grown before this step forks.
    pub(super) fn extend(&mut self) {
        self.extend_stem();
        let grown = self.state.axes.len();
        // All forks come before all children: the rods are numbered level by level.
        for axis in 0..grown {
            let Axis { generation, segments, forked, .. } = self.state.axes[axis];
            if generation == STEM {
                continue;
            }
            let generation = generation as usize;
            if (segments as usize) < self.plan.generations[generation].length.len() {
                self.extend_axis(axis);
            } else if generation + 1 < self.plan.generations.len() && !forked {
                self.fork(axis);
            }
        }
        for child in grown..self.state.axes.len() {
            self.extend_axis(child);
        }
    }

    fn second_order(&self) -> bool {
        self.params.solver.discretization == Discretization::SecondOrder
    }

    /// Flexural rigidity of the first pipe, N m2.
    fn rigidity(&self, birth_radius: f64) -> f64 {
        self.params.material.youngs_modulus * Section::new(birth_radius).second_moment_of_area()
    }

    /// Attaches the next segment of an axis at rest, in the direction of its bearer turned by the tropism.
    pub(super) fn extend_axis(&mut self, axis: usize) {
        let Axis { generation, segments, base_radius, bearer, branching_turn, .. } = self.state.axes[axis];
        let plan = self.plan.of(generation);
        let length = plan.length[segments as usize];
        let birth_radius = base_radius * plan.radius[segments as usize];
        let rigidity = self.rigidity(birth_radius);
        // On a node a segment stands with its own half only.
        let on_node = bearer != GROUND && self.state.linkage.length[bearer as usize] == 0.0;
        let below = (segments > 0 && !on_node).then(|| plan.length[segments as usize - 1]);
        let (joint_length, pipe_stiffness) = match below {
            _ if !self.second_order() => (length, rigidity / length),
            None => (0.5 * length, 2.0 * rigidity / length),
            Some(below) => {
                let rigidity_below = self.rigidity(self.state.wood[bearer as usize].birth_radius);
                (0.5 * (below + length), 2.0 / (below / rigidity_below + length / rigidity))
            }
        };
        // The paper's first segment keeps the elevation.
        let turns = self.second_order() || bearer != GROUND;
        let turn = if segments == 0 { branching_turn } else { 0.0 };
        let rest = match self.is_spatial {
            true => {
                Rest::Space(self.rest_in_space(axis, segments == 0, if turns { joint_length } else { 0.0 }))
            }
            false => {
                Rest::Plane(turn + if turns { self.bend_and_turn(bearer, turn, joint_length) } else { 0.0 })
            }
        };
        let wood = Wood {
            birth_radius,
            axis: axis as u32,
            birth: self.state.step,
            joint_length,
            branching_turn: turn,
        };
        let mass = self.params.material.density * Section::new(birth_radius).area() * length;
        let since = f64::from(self.state.step) - 1.0;
        let rod = self.push(bearer, length, rest, wood, FirstPipe { since, stiffness: pipe_stiffness, mass });
        let axis = &mut self.state.axes[axis];
        axis.segments += 1;
        axis.bearer = rod;
    }

    /// Ends an axis in two children. To second order the fork is a massless node of zero length, half a segment
    /// beyond the parent's last joint and half a segment before the children's first.
    fn fork(&mut self, axis: usize) {
        let parent = self.state.axes[axis];
        self.state.axes[axis].forked = true;
        let bearer = self.end_in_node(axis);
        let fork = self.plan.fork;
        let plan = &self.plan.generations[parent.generation as usize];
        let tip_radius = parent.base_radius * plan.radius_at.last().copied().unwrap_or(1.0);
        let side = rolled_side(&self.params);
        let children = [(fork.thicker, side * fork.thicker_turn), (fork.thinner, -side * fork.thinner_turn)];
        let [plane, back] = rolled_plane(&self.params);
        for (width, branching_turn) in children {
            self.state.axes.push(Axis {
                generation: parent.generation + 1,
                base_radius: width * tip_radius,
                attached: parent.bearer,
                bearer,
                branching_turn,
                // The roll tells the side already.
                branching: plane * exp(DVec3::Z * (side * branching_turn)) * back,
                azimuth: parent.azimuth,
                segments: 0,
                forked: false,
            });
        }
    }

    /// To second order, ends an axis in a massless node of zero length, which stands for half of its last segment, and
    /// returns it; otherwise its last segment.
    pub(super) fn end_in_node(&mut self, axis: usize) -> u32 {
        let bearer = self.state.axes[axis].bearer;
        if !self.second_order() {
            return bearer;
        }
        let tip = self.state.wood[bearer as usize];
        let length = self.state.linkage.length[bearer as usize];
        let joint_length = 0.5 * length;
        let pipe_stiffness = 2.0 * self.rigidity(tip.birth_radius) / length;
        let rest = match self.is_spatial {
            true => Rest::Space(self.rest_in_space(axis, false, joint_length)),
            false => Rest::Plane(self.bend_and_turn(bearer, 0.0, joint_length)),
        };
        let node = Wood { birth: self.state.step, joint_length, branching_turn: 0.0, ..tip };
        let since = self.state.pipes.since[bearer as usize];
        let pipe = FirstPipe { since, stiffness: pipe_stiffness, mass: 0.0 };
        self.push(bearer, 0.0, rest, node, pipe)
    }

    /// Adds a rod, at rest in the direction that it has from its bearer; returns its index.
    fn push(&mut self, bearer: u32, length: f64, rest: Rest, wood: Wood, pipe: FirstPipe) -> u32 {
        let rod = self.rods();
        self.state.wood.push(wood);
        self.state.pipes.push(pipe);
        let pipes = f64::from(self.pipes(rod));
        let angle = if let Rest::Plane(angle) = rest { angle } else { 0.0 };
        self.state.linkage.push(bearer, length, pipes * pipes * pipe.stiffness, angle);
        match rest {
            Rest::Space([branching, bend]) => {
                self.state.shape.push(branching, bend);
                if self.turns() {
                    // As all orientations are found again from the shape, to the last bit.
                    let turned = self.orientation_of(bearer) * self.state.shape.joint(rod);
                    self.orientation.push(normalized(turned));
                }
            }
            Rest::Plane(rest) if self.turns() => self.angle.push(self.direction(bearer) + rest),
            Rest::Plane(_) => {}
        }
        rod as u32
    }

    /// Direction of a rod when the step began, in the frame of the base direction.
    fn direction(&self, rod: u32) -> f64 {
        if rod == GROUND { 0.0 } else { self.angle[rod as usize] }
    }

    /// By how much new wood that starts at `turn` from its bearer's direction is bent, and turned by the tropism, radians: half
    /// of the bend before the turn and half after, so that the cut is of second order.
    fn bend_and_turn(&self, bearer: u32, turn: f64, length: f64) -> f64 {
        let crate::params::Axis { rest_curvature, rest_curvature_roll, .. } = self.params.axis;
        if rest_curvature == 0.0 {
            return self.tropic_turn(bearer, turn, length);
        }
        let bend = rest_curvature_roll.sin_cos().1 * rest_curvature * length;
        bend + self.tropic_turn(bearer, turn + 0.5 * bend, length)
    }

    /// How far a tropism turns new wood that starts at `turn` from its bearer's direction, radians (equation 73).
    fn tropic_turn(&self, bearer: u32, turn: f64, length: f64) -> f64 {
        if !self.turns() {
            return 0.0;
        }
        let tropism = &self.params.tropism;
        let elevation = sought_in_plane(&self.params).unwrap_or(tropism.elevation);
        // The nearer way round in degrees, where that is exact: so left and right are mirrored to the bit.
        let mut sought = Degrees(elevation.0 - self.params.axis.elevation.0).wrapped();
        let direction = self.direction(bearer) + turn;
        if sought.0.abs() == 180.0 {
            // Half a turn is as far either way: the side to which the wood points already is the nearer one.
            sought.0 = libm::copysign(180.0, direction);
        }
        let away = wrap(direction - sought.radians());
        turned(away, elasticity(tropism.strength, length)) - away
    }
}

/// The side to which the thicker child turns in the plane: counter-clockwise, unless the fork's plane is rolled over.
fn rolled_side(params: &Params) -> f64 {
    if params.branching.roll.0 == 0.0 { 1.0 } else { -1.0 }
}

/// How the plane of a fork is turned about its parent, and how the children's own frames are turned back: by the half turns in
/// it, which only change sides. So the planes roll on from fork to fork, and a half turn mirrors the plant.
fn rolled_plane(params: &Params) -> [DQuat; 2] {
    let angle = params.branching.roll.0;
    [roll(Degrees(angle)), roll(Degrees(-180.0 * libm::rint(angle / 180.0)))]
}

/// Rest angle of new wood, or its rotation: the branching, and the bend of the wood from there.
enum Rest {
    Plane(f64),
    Space([DQuat; 2]),
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{BranchingPattern, Thickening};

    /// The node of a fork stands for half of the parent's last segment, with all of that one's pipes, at every age.
    #[test]
    fn the_node_of_a_fork_has_its_bearers_pipes() {
        let mut params = Params::default();
        params.axis.segments = 5;
        params.branching.pattern = BranchingPattern::Bifurcation;
        params.branching.generations = 2;
        params.growth.thickening = Thickening::Pipes;
        let mut growth = Growth::new(&params).unwrap();
        let mut nodes = 0;
        while growth.step() {
            let linkage = &growth.state.linkage;
            for node in (0..growth.rods()).filter(|&rod| linkage.length[rod] == 0.0) {
                let bearer = linkage.parent[node] as usize;
                let whole = growth.section(bearer).second_moment_of_area() * params.material.youngs_modulus;
                let expected = 2.0 * whole / linkage.length[bearer];
                assert_eq!(growth.pipes(node), growth.pipes(bearer));
                assert!((linkage.stiffness[node] / expected - 1.0).abs() < 1e-14);
                assert_eq!(growth.mass(node), 0.0);
                nodes += 1;
            }
        }
        // One node over 5 + 5 steps, two more over 5.
        assert_eq!(nodes, 10 + 10);
    }
}
