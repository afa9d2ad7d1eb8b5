//! The shape of plant branches under gravity and tropisms.
//!
//! Implements the model of Jirasek & Prusinkiewicz, *A Biomechanical Model of Branch Shape in Plants* (1998):
//! an axis is a chain of rigid segments joined by rotational springs; it grows by one segment a step, its
//! growth turns to a preferred direction, its wood thickens by pipes laid down unstressed, and after every
//! step it comes to rest under its weight. Equations are cited by their numbers in that paper.
//!
//! ```
//! use bough::{grow, params::Params};
//!
//! let mut params = Params::default();
//! params.axis.segments = 20;
//! let plant = grow(&params)?;
//! assert_eq!(plant.polylines.points.len(), 3 * 21);
//! assert!(plant.report.residual <= params.solver.tolerance);
//! # Ok::<(), bough::params::BoughError>(())
//! ```
//!
//! The parts, each knowing only those before it: [`params`] (the one declaration), [`plant`] (the result and
//! the sections of its wood), [`mechanics`] (loads, energy, equilibrium), [`growth`] (the step, and its history).

#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod angle;
pub mod growth;
pub mod mechanics;
pub mod params;
pub mod plant;
pub mod space;
pub mod trigonometry;

pub use growth::{Growth, History, grow, relaxation};
pub use plant::Plant;

/// Version of this crate, and of the npm package built from it.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
