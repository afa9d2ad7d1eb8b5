//! Statics of a tree of rigid rods joined by rotational springs, in a vertical plane.
//!
//! Knows nothing of growth, wood or params: stiffnesses, rest angles and forces in, equilibrium out.

mod equilibrium;
mod hessian;
mod hold;
mod linkage;
mod loads;
mod relaxation;
mod report;

pub use equilibrium::{Settings, Workspace, energy, hang, polish, settle};
pub use hessian::{Elimination, gradient};
pub use hold::{Held, hold};
pub use linkage::{GROUND, Linkage};
pub use loads::Loads;
pub use relaxation::{MAX_EULER_STEPS, Relaxation};
pub use report::{Outcome, Report, Status};
