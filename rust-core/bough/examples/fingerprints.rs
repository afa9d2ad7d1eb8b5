//! Prints the fingerprint of every preset's plant: the same on every platform, or something is wrong.
//!
//! `cargo run --release --example fingerprints`

use bough::History;
use bough::params::{Discretization, PRESETS, Params};

fn main() -> Result<(), bough::params::BoughError> {
    for preset in PRESETS {
        let mut params = Params::of_preset(preset);
        let step = preset.step.unwrap_or(u32::MAX);
        println!("{} {:016x}", preset.id, History::new(&params)?.at(step).fingerprint());
        params.solver.discretization = Discretization::Paper;
        println!("{}/paper {:016x}", preset.id, History::new(&params)?.at(step).fingerprint());
    }
    Ok(())
}
