//! The one declaration of every parameter, its validation, and the presets.

mod check;
mod cost;
mod declaration;
mod issue;
mod parameter;
mod plane;
mod preset;
mod species;
mod value;

pub use crate::angle::Degrees;
pub use check::{check, check_flat};
pub use cost::{MAX_PIPES_LAID, MAX_SEGMENTS, MAX_STEPPED};
pub(crate) use cost::{is_foreseeable, segments_of_generations, steps_of};
pub use declaration::*;
pub use issue::{BoughError, Issue, Sentence};
pub use parameter::{Kind, Parameter, Scale};
pub(crate) use plane::{copies_differ, is_spatial, sought_in_plane};
pub use preset::{PRESETS, Preset};
pub use value::PointForce;

/// How many numbers a complete set of params takes in the fixed part of the flat form; forces on segments follow.
pub fn flat_length() -> usize {
    PARAMETERS.iter().map(|parameter| parameter.kind.width()).sum()
}
