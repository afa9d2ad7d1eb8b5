//! Statics of a tree of rigid rods joined by rotational springs, in a vertical plane.
//!
//! Knows nothing of growth, wood or params: stiffnesses, rest angles and forces in, equilibrium out.

mod chain;
mod coarse;
mod descent;
mod equilibrium;
mod hessian;
mod hold;
mod levels;
mod linkage;
mod loads;
mod relaxation;
mod report;
mod sweep;

pub use descent::energy;
pub use equilibrium::{LEAN, Settings, Workspace, hang, polish, settle};
pub(crate) use hessian::pass_down;
pub use hessian::{Elimination, gradient};
pub use hold::{Held, hold};
pub use linkage::{GROUND, Linkage};
pub use loads::Loads;
pub use relaxation::{MAX_EULER_STEPS, Relaxation};
pub use report::{Outcome, Report, Status};
pub(crate) use sweep::{carry_on, differences};
