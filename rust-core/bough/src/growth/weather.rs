//! Snow and wind on the grown plant: forces that depend on how it stands.

use alloc::vec;
use alloc::vec::Vec;

use glam::DVec3;

use super::state::Growth;
use crate::params::Params;

/// Density of air at 15 degrees Celsius at sea level, kg/m3.
pub const AIR: f64 = 1.225;

/// Where the wind of these params blows to and how fast: x, y, z in m/s.
pub fn wind(params: &Params) -> [f64; 3] {
    let (sin, cos) = params.loads.wind_azimuth.sin_cos();
    [params.loads.wind * cos, 0.0, -params.loads.wind * sin]
}

/// Force of a wind (m/s) on wood that shows it so much area (diameter times length, m2, times the drag coefficient) and points
/// in this direction, N. The cross-flow principle (Hoerner, *Fluid-Dynamic Drag*, 1965): only the part of the wind
/// across the rod counts, by its square; along it nothing drags.
///
/// ```
/// use bough::growth::wind_force;
/// // Upright in 10 m/s: half the density times area times the square of the speed.
/// let [push, ..] = wind_force([10.0, 0.0, 0.0], [0.0, 1.0, 0.0], 0.2);
/// assert!((push - 0.5 * 1.225 * 0.2 * 100.0).abs() < 1e-14);
/// assert_eq!(wind_force([10.0, 0.0, 0.0], [1.0, 0.0, 0.0], 0.2), [0.0; 3]);
/// ```
pub fn wind_force(wind: [f64; 3], direction: [f64; 3], area: f64) -> [f64; 3] {
    let [x, y, z] = direction;
    let along = wind[0] * x + wind[1] * y + wind[2] * z;
    let across = [wind[0] - along * x, wind[1] - along * y, wind[2] - along * z];
    let pressure = 0.5 * AIR * area * libm::hypot(libm::hypot(across[0], across[1]), across[2]);
    across.map(|speed| pressure * speed)
}

impl Growth {
    /// Whether snow lies or wind blows: not where all loads are taken off.
    pub(super) fn has_weather(&self) -> bool {
        let loads = &self.params.loads;
        !loads.removed && (loads.snow > 0.0 || loads.wind > 0.0)
    }

    /// Forces of snow and wind at the distal ends of the rods, N; `direction` is where each rod points there. Drag on leaves is
    /// along the wind, however they hang: they turn and fold in it. Vectors are in any frame, in which the wind (m/s) and
    /// upwards are these.
    pub(super) fn weather(
        &self,
        wind: [f64; 3],
        up: [f64; 3],
        direction: &mut dyn FnMut(usize) -> [f64; 3],
    ) -> Vec<[f64; 3]> {
        let loads = &self.params.loads;
        let mut forces = vec![[0.0; 3]; self.rods()];
        for rod in 0..forces.len() {
            let direction = direction(rod);
            let side = 2.0 * self.section(rod).radius() * self.state.linkage.length[rod];
            let leaves = self.leaf_mass(rod) * loads.foliage_area;
            let push = wind_force(wind, direction, loads.drag_coefficient * side);
            let on_leaves = 0.5 * AIR * loads.foliage_drag * leaves * loads.wind;
            let level = DVec3::from_array(direction).cross(DVec3::from_array(up)).length();
            let weight = loads.snow * (side * level + leaves) * loads.gravity;
            for (node, share) in self.shares(rod) {
                for axis in 0..3 {
                    forces[node][axis] += share * (push[axis] + on_leaves * wind[axis] - weight * up[axis]);
                }
            }
        }
        forces
    }
}
