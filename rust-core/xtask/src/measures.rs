//! The columns of sweeps, for TypeScript.

use bough::plant::{MEASURES, Measure};

/// The module `measures.ts`: the names, and a type with one number for each, so that none can be forgotten.
pub(crate) fn module() -> String {
    let fields: String = MEASURES.iter().map(field).collect();
    let names: String = MEASURES.iter().map(|measure| format!("  \"{}\",\n", measure.name)).collect();
    format!(
        "// Printed by xtask from the measures of the core (rust-core/bough/src/plant/measure.rs).\n\n\
         /** What is told of a plant in a row of numbers. */\n\
         export interface Measures {{\n{fields}}}\n\n\
         /** Their names, in the order of columns. */\n\
         export const measureNames: readonly (keyof Measures)[] = [\n{names}];\n"
    )
}

fn field(Measure { name, unit, help, .. }: &Measure) -> String {
    let unit = if unit.is_empty() { String::new() } else { format!(" In {unit}.") };
    format!("  /** {help}{unit} */\n  {name}: number;\n")
}
