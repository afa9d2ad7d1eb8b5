//! Prints the centre lines of a preset as CSV: axis, x, y, z and radius, in metres, from the base of each axis to its tip.
//!
//! `cargo run --example centre_line -- figure-13a`

use bough::History;
use bough::params::{PRESETS, Params};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let id = std::env::args().nth(1).unwrap_or_else(|| "figure-13a".to_owned());
    let known = || PRESETS.iter().map(|preset| preset.id).collect::<Vec<_>>().join(", ");
    let preset = PRESETS
        .iter()
        .find(|preset| preset.id == id)
        .ok_or_else(|| format!("{id} is none of {}", known()))?;
    let plant = History::new(&Params::of_preset(preset))?.at(preset.step.unwrap_or(u32::MAX));
    let lines = &plant.polylines;
    println!("axis,x,y,z,radius");
    for (axis, ends) in lines.offsets.windows(2).enumerate() {
        for point in ends[0] as usize..ends[1] as usize {
            let [x, y, z] = [0, 1, 2].map(|k| lines.points[3 * point + k]);
            println!("{axis},{x},{y},{z},{}", lines.radii[point]);
        }
    }
    Ok(())
}
