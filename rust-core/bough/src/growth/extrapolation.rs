//! Growth of a finely cut axis, foreseen from coarser ones.
//!
//! Grown exactly, an axis of n segments costs n steps of n segments. But the shape depends smoothly on how finely the axis is
//! cut: `f(h) = f(0) + a h + b h^2 + c h^3 + ..` with `h = 1/n`. So the same plant is grown a few times in coarse cuts, and
//! the polynomial through what they remember is taken at the h that is asked for (Richardson, Phil. Trans. R. Soc. A 210,
//! 1911). What is extrapolated is the memory alone (rest curvatures) and where to start from; the fine axis then is
//! brought to equilibrium like any other, so its residual is as small.
//!
//! How good that is shows without the coarsest cut: the shape then differs by about as much as it is off.

use alloc::vec::Vec;

use super::plant::stress;
use super::state::Growth;
use crate::mechanics::Status;
use crate::params::{ArrangementPattern, Method, Params, Stepping, Thickening};
use crate::trigonometry::sin_cos;

/// Segments of the coarse cuts; refined by a factor until the estimate is good.
const CUTS: [u32; 4] = [48, 96, 144, 192];
/// How often the cuts are made twice as fine where the estimate is not good enough.
const REFINEMENTS: u32 = 2;
/// Tolerance of the coarse cuts. The torques at a young tip are a millionth of the largest, so what 1e-10 leaves over there is
/// remembered as a rest angle that is off by far more.
const TOLERANCE: f64 = 1e-14;
/// Distance from the exact shape over the length of the axis that is good enough.
const GOOD: f64 = 5e-7;
/// The estimate, over by how much the shape differs without the coarsest cut. Where everything is smooth that difference alone
/// is more than the error; terms like `h^2 log h` (a tip that bears a load, a strong tropism) can make it ten times less.
const CAUTION: f64 = 10.0;
/// Points of a polynomial along the axis: its error is far below that of the extrapolation.
const POINTS: usize = 6;
/// Up to this many segments an axis is grown exactly: that is as quick.
pub(super) const FEWEST: u32 = 256;

/// What exact growth is expected to lead to, for each joint of one axis from the base on.
#[derive(Clone, Debug, Default)]
pub(super) struct Forecast {
    /// Rest angle over the length of the joint, 1/m.
    pub(super) rest_curvature: Vec<f64>,
    /// Spring torque, N m.
    pub(super) moment: Vec<f64>,
    /// Largest fibre stress, Pa.
    pub(super) stress: Vec<f64>,
    /// Largest distance from the shape of exact growth that is to be expected, over the length of the axis.
    pub(super) error: f64,
    /// The worst of all coarse cuts, and their iterations.
    pub(super) status: Status,
    pub(super) iterations: u64,
    /// First step without a stable equilibrium, counted in steps of the fine axis.
    pub(super) unstable_since: Option<u32>,
}

/// The axis at the end of step `steps`.
pub(super) fn foresee(params: &Params, steps: u32) -> Forecast {
    if steps <= FEWEST {
        return Sampled::grow(params, steps, steps).forecast;
    }
    let mut cuts = CUTS;
    for _ in 0..REFINEMENTS {
        let forecast = extrapolate(&cuts.map(|cut| Sampled::grow(params, cut, steps)), params, steps);
        if forecast.error <= GOOD || 2 * cuts[CUTS.len() - 1] > steps {
            return forecast;
        }
        cuts = cuts.map(|cut| 2 * cut);
    }
    extrapolate(&cuts.map(|cut| Sampled::grow(params, cut, steps)), params, steps)
}

/// One coarse cut, grown.
struct Sampled {
    joints: u32,
    forecast: Forecast,
}

impl Sampled {
    /// Grows `steps` segments of the axis as `cut` longer ones, that in the end are as thick.
    fn grow(params: &Params, cut: u32, steps: u32) -> Sampled {
        let times = f64::from(steps) / f64::from(cut);
        let mut coarse = params.clone();
        coarse.axis.segments = cut;
        coarse.axis.segment_length *= times;
        if params.growth.thickening == Thickening::Pipes {
            coarse.axis.radius *= libm::sqrt(times);
        }
        coarse.solver.stepping = Stepping::Exact;
        coarse.solver.method = Method::Newton;
        coarse.solver.tolerance = TOLERANCE;
        coarse.arrangement.pattern = ArrangementPattern::Single;
        coarse.loads.forces.clear();
        let mut growth = Growth::unchecked(&coarse);
        while growth.step() {}
        let report = *growth.report();
        let linkage = &growth.state.linkage;
        let joints = growth.state.wood.iter().enumerate();
        let forecast = Forecast {
            rest_curvature: joints.map(|(joint, wood)| linkage.rest[joint] / wood.joint_length).collect(),
            moment: (0..linkage.len())
                .map(|joint| linkage.stiffness[joint] * linkage.deviation[joint])
                .collect(),
            stress: stress(&growth, linkage),
            error: 0.0,
            status: report.status,
            iterations: report.iterations,
            unstable_since: report.unstable_since.map(|step| (f64::from(step) * times) as u32),
        };
        Sampled { joints: cut, forecast }
    }
}

/// The polynomial in h through the coarse cuts, at the fine one.
fn extrapolate(grown: &[Sampled], params: &Params, steps: u32) -> Forecast {
    let mut forecast = Forecast::default();
    for coarse in grown {
        forecast.status = forecast.status.max(coarse.forecast.status);
        forecast.iterations += coarse.forecast.iterations;
        forecast.unstable_since = coarse.forecast.unstable_since.or(forecast.unstable_since);
    }
    let all = weights(grown, steps);
    // The same without the coarsest cut.
    let mut fewer = weights(&grown[1..], steps);
    fewer.insert(0, 0.0);
    let length = params.axis.segment_length;
    let rigidity = 0.25 * core::f64::consts::PI * params.material.youngs_modulus;
    let square = params.axis.radius * params.axis.radius;
    let mut lines = [Line::default(), Line::default()];
    for joint in 0..steps {
        let mut sums = [[0.0; 3]; 2];
        for (index, coarse) in grown.iter().enumerate() {
            let values = coarse.at(joint, steps);
            for (sums, weight) in sums.iter_mut().zip([all[index], fewer[index]]) {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        let [rest_curvature, moment, stress] = sums[0];
        forecast.rest_curvature.push(rest_curvature);
        forecast.moment.push(moment);
        forecast.stress.push(stress.max(0.0));
        let pipes = match params.growth.thickening {
            Thickening::None => 1.0,
            Thickening::Pipes => f64::from(steps - joint),
        };
        let rigidity = rigidity * square * square * pipes * pipes;
        for (line, [rest_curvature, moment, _]) in lines.iter_mut().zip(sums) {
            line.go_on(length * (rest_curvature + moment / rigidity), length);
        }
        let [this, other] = &lines;
        forecast.error = forecast.error.max(libm::hypot(this.x - other.x, this.y - other.y));
    }
    forecast.error *= CAUTION / (length * f64::from(steps));
    if forecast.status == Status::NonFinite {
        forecast.error = f64::INFINITY;
    }
    forecast
}

/// The centre line so far.
#[derive(Clone, Copy, Debug, Default)]
struct Line {
    angle: f64,
    x: f64,
    y: f64,
}

impl Line {
    fn go_on(&mut self, turn: f64, length: f64) {
        self.angle += turn;
        let (sin, cos) = sin_cos(self.angle);
        self.x += length * cos;
        self.y += length * sin;
    }
}

/// Lagrange's weights of the coarse cuts for the fine one, in powers of h.
fn weights(grown: &[Sampled], steps: u32) -> Vec<f64> {
    let fineness: Vec<f64> = grown.iter().map(|coarse| 1.0 / f64::from(coarse.joints)).collect();
    let fine = 1.0 / f64::from(steps);
    let weight = |own: &f64| {
        let others = fineness.iter().filter(|other| *other != own);
        others.map(|other| (fine - other) / (own - other)).product()
    };
    fineness.iter().map(weight).collect()
}

impl Sampled {
    /// Rest curvature, moment and stress where joint `joint` of `steps` is. The base joint is like no other: it
    /// stands for itself.
    fn at(&self, joint: u32, steps: u32) -> [f64; 3] {
        let Forecast { rest_curvature, moment, stress, .. } = &self.forecast;
        if joint == 0 {
            return [rest_curvature[0], moment[0], stress[0]];
        }
        let place = f64::from(joint) * f64::from(self.joints) / f64::from(steps);
        let last_first = self.joints as usize - POINTS;
        let first = (place as usize).saturating_sub(POINTS / 2 - 1).clamp(1, last_first);
        let mut values = [0.0; 3];
        for point in 0..POINTS {
            let mut weight = 1.0;
            for other in (0..POINTS).filter(|other| *other != point) {
                weight *= (place - (first + other) as f64) / (point as f64 - other as f64);
            }
            for (value, field) in values.iter_mut().zip([rest_curvature, moment, stress]) {
                *value += weight * field[first + point];
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without memory nothing but moments tells how the axis hangs, and they are foreseen a little wrong. The estimate must
    /// see that: be no less than the distance from the shape of the exact moments, nor so much more that it tells nothing.
    #[test]
    fn moments_that_are_off_count_in_the_estimate() {
        let steps = 300;
        let mut params = Params::default();
        params.axis.segments = steps;
        params.axis.segment_length = 1.5 / f64::from(steps);
        params.axis.radius = 0.002;
        let [foreseen, exact] = [foresee(&params, steps), Sampled::grow(&params, steps, steps).forecast];
        assert!(foreseen.rest_curvature.iter().all(|curvature| *curvature == 0.0));
        let length = params.axis.segment_length;
        let square = params.axis.radius * params.axis.radius;
        let rigidity = 0.25 * core::f64::consts::PI * params.material.youngs_modulus * square * square;
        let mut lines = [Line::default(), Line::default()];
        let mut apart = 0.0_f64;
        for (foreseen, exact) in foreseen.moment.iter().zip(&exact.moment) {
            for (line, moment) in lines.iter_mut().zip([foreseen, exact]) {
                line.go_on(length * moment / rigidity, length);
            }
            apart = apart.max(libm::hypot(lines[0].x - lines[1].x, lines[0].y - lines[1].y));
        }
        apart /= length * f64::from(steps);
        assert!(apart > 1e-15, "{apart:e}: only rounding is left to see");
        // Caution makes it ten times too much, and without the coarsest cut the shape is off by some tens of times more.
        assert!((apart..1e3 * apart).contains(&foreseen.error), "{apart:e} {:e}", foreseen.error);
    }
}
