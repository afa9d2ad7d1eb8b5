//! A plant in a row of numbers: the columns of sweeps.

use alloc::vec::Vec;

use super::result::Plant;

/// One number that is told of a plant.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its name as a column, camelCase.
    pub name: &'static str,
    /// SI unit, empty for pure numbers.
    pub unit: &'static str,
    /// What it is.
    pub help: &'static str,
    of: fn(&Plant) -> f64,
}

impl Measure {
    /// The number.
    pub fn of(&self, plant: &Plant) -> f64 {
        (self.of)(plant)
    }
}

macro_rules! measures {
    ($($name:literal, $unit:literal, $help:literal, $of:expr;)+) => {
        /// Every measure, in the order of columns. JavaScript has them under the same names.
        pub static MEASURES: &[Measure] = &[
            $(Measure { name: $name, unit: $unit, help: $help, of: $of },)+
        ];
    };
}

measures! {
    "tipX", "m", "Place of the main axis's tip, to the right of its base.", |plant| from_base(plant)[0];
    "tipY", "m", "Place of the main axis's tip, above its base.", |plant| from_base(plant)[1];
    "tipZ", "m", "Place of the main axis's tip, towards the viewer.", |plant| from_base(plant)[2];
    "height", "m", "How far the plant reaches above its base.", height;
    "reach", "m", "How far it reaches from the upright line through its base.", reach;
    "length", "m", "Length of all axes together.", |plant| plant.segments.length.iter().sum();
    "mass", "kg", "Mass of the wood.", |plant| plant.segments.mass.iter().sum();
    "baseRadius", "m", "Radius at the base.", |plant| plant.polylines.radii.first().copied().unwrap_or_default();
    "baseMoment", "N m", "Bending moment at the base, as segments.moment has it.",
        |plant| plant.segments.moment.first().copied().unwrap_or_default();
    "largestMoment", "N m", "Largest bending moment of any joint, without its sign.", |plant| largest(&plant.segments.moment);
    "largestStress", "Pa", "Largest fibre stress of any segment.", |plant| largest(&plant.segments.stress);
    "segments", "", "How many segments it has.", |plant| plant.segments.parent.len() as f64;
    "axes", "", "How many axes it has.", |plant| plant.polylines.offsets.len().saturating_sub(1) as f64;
    "steps", "", "Growth steps taken.", |plant| f64::from(plant.report.steps);
    "gravityNumber", "", "Weight times length squared over EI at the base.", |plant| plant.report.gravity_number;
    "residual", "", "Largest torque left over at a joint, relative to the largest torque.", |plant| plant.report.residual;
    "iterations", "", "Iterations of all growth steps together.", |plant| plant.report.iterations as f64;
    "stable", "", "1 if the shape is a minimum of energy, 0 if not, empty (NaN) if it is no equilibrium.",
        |plant| plant.report.stable.map_or(f64::NAN, |stable| f64::from(u8::from(stable)));
}

/// From the base of the main axis to its tip.
fn from_base(plant: &Plant) -> [f64; 3] {
    let points = &plant.polylines.points;
    let [x, y, z] = *points.first_chunk().unwrap_or(&[0.0; 3]);
    let end = plant.polylines.offsets.get(1).map_or(0, |&end| 3 * end as usize);
    let tip: &[f64; 3] = points.get(..end).and_then(<[f64]>::last_chunk).unwrap_or(&[0.0; 3]);
    [tip[0] - x, tip[1] - y, tip[2] - z]
}

fn height(plant: &Plant) -> f64 {
    let points = &plant.polylines.points;
    let base = points.get(1).copied().unwrap_or_default();
    points.chunks_exact(3).fold(0.0, |most, point| f64::max(most, point[1] - base))
}

fn reach(plant: &Plant) -> f64 {
    let points = &plant.polylines.points;
    let [x, _, z] = *points.first_chunk().unwrap_or(&[0.0; 3]);
    let squared = points.chunks_exact(3).fold(0.0, |most, point| {
        let (along, across) = (point[0] - x, point[2] - z);
        f64::max(most, along * along + across * across)
    });
    libm::sqrt(squared)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| f64::max(most, value.abs()))
}

/// All measures of a plant, in the order of [`MEASURES`].
pub fn measures(plant: &Plant) -> Vec<f64> {
    MEASURES.iter().map(|measure| measure.of(plant)).collect()
}
