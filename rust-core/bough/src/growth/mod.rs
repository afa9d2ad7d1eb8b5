//! How a plant grows: a step thickens old wood, extends or forks the axes, turns new wood, and lets all settle.

mod attach;
mod axis;
mod buckling;
mod extrapolation;
mod flexible_stem;
mod fork;
mod history;
mod pipes;
mod plan;
mod plant;
mod pull;
mod space;
mod state;
mod stem;
mod trajectory;
mod trend;
mod tropism;
mod weight;
mod wood;

pub use fork::Fork;
pub use history::{History, grow};
pub use state::Growth;
pub use trajectory::{Trajectory, relaxation};
pub use tropism::turned;
