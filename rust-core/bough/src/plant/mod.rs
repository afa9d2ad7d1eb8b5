//! What a plant consists of: the results as flat arrays and as a row of numbers, the sections of its wood, and what they stand.

mod measure;
mod result;
mod section;
mod strength;

pub use measure::{MEASURES, Measure, measures};
pub use result::{Plant, Polylines, Segments};
pub use section::Section;
pub use strength::{largest_principal_stress, weakest};
