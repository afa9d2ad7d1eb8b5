//! What a plant consists of: the results as flat arrays, and the sections of its wood.

mod result;
mod section;

pub use result::{Plant, Polylines, Segments};
pub use section::Section;
