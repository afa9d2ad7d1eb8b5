//! Statics of a tree of rigid rods in space: joints that bend about two axes and twist.
//!
//! The paper names three rotational degrees of freedom a joint as its first open problem. Knows nothing of growth, wood or
//! params, as [`crate::mechanics`], whose planar rods are the special case.

mod balance;
mod buckling;
#[cfg(test)]
mod derivatives;
mod descent;
mod element;
mod equilibrium;
mod hold;
mod joints;
mod rotation;
mod shape;

pub use balance::{Balance, Damping};
pub use buckling::load_over_critical;
pub use equilibrium::{NEUTRAL, Workspace, settle};
pub use hold::{Held, hold};
pub use rotation::{LONGEST, direction, exp, from_rodrigues, log, normalized, orientation, rodrigues, roll};
pub use shape::{Rods, Shape, gather};
