//! How a plant grows: a step thickens old wood, extends or forks the axes, turns new wood, and lets all settle.

mod aftermath;
mod attach;
mod axis;
mod buckling;
mod burden;
mod extrapolation;
mod flexible_stem;
mod fork;
mod history;
mod pipes;
mod plan;
mod plant;
mod pull;
mod sensitivity;
mod slope;
mod space;
mod state;
mod stem;
mod trajectory;
mod trend;
mod tropism;
mod weather;
mod weight;
mod wood;

pub use fork::Fork;
pub use history::{History, grow};
pub use sensitivity::{Sensitivity, sensitivity};
pub use state::Growth;
pub use trajectory::{Trajectory, iterations, relaxation};
pub use tropism::turned;
pub use weather::{AIR, wind, wind_force};
