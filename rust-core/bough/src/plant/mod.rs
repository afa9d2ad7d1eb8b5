//! What a plant consists of: the results as flat arrays and as a row of numbers, and the sections of its wood.

mod measure;
mod result;
mod section;

pub use measure::{MEASURES, Measure, measures};
pub use result::{Plant, Polylines, Segments};
pub use section::Section;
