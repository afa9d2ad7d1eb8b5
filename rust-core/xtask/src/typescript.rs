//! The declaration as TypeScript types, their comments included.

use std::fmt::Write;

use anyhow::Result;
use bough::params::{Kind, PARAMETERS, PRESETS, Parameter};

use crate::text::{group_and_field, shown, shown_default};

/// The module `params.ts`.
pub(crate) fn module() -> Result<String> {
    let mut module = String::from(
        "// Printed by xtask from the declaration of the parameters (rust-core/bough/src/params).\n\n\
         /** A force on the distal end of a segment. */\n\
         export interface PointForce {\n  \
           /** Index of the segment in the result's arrays. */\n  segment: number;\n  \
           /** x, y, z in N. */\n  force: [x: number, y: number, z: number];\n\
         }\n\n\
         /** Everything that determines a plant, complete. */\n\
         export interface Params {\n",
    );
    let mut open_group = "";
    for parameter in PARAMETERS {
        let (group, field) = group_and_field(parameter)?;
        if group != open_group {
            if !open_group.is_empty() {
                module += "  };\n";
            }
            writeln!(module, "  {group}: {{")?;
            open_group = group;
        }
        let (comment, kind) = (comment(parameter)?, type_of(parameter.kind));
        write!(module, "    /**\n{comment}     */\n    {field}: {kind};\n")?;
    }
    let presets =
        PRESETS.iter().fold(String::new(), |union, preset| format!("{union}\n  | \"{}\"", preset.id));
    write!(
        module,
        "  }};\n}}\n\n\
         /** Params as they may be given: what is left out takes its default. */\n\
         export type ParamsInput = {{ [Group in keyof Params]?: Partial<Params[Group]> }};\n\n\
         /** Names of the presets. */\n\
         export type PresetId ={presets};\n"
    )?;
    Ok(module)
}

fn comment(parameter: &Parameter) -> Result<String> {
    let mut comment = format!("     * {}\n     *\n", parameter.help);
    for (what, value) in [("Symbol", parameter.symbol), ("Unit", parameter.unit)] {
        if !value.is_empty() {
            writeln!(comment, "     * - {what}: {value}")?;
        }
    }
    if matches!(parameter.kind, Kind::Number | Kind::Optional | Kind::Integer | Kind::Vector | Kind::Forces) {
        writeln!(comment, "     * - Range: {} to {}", shown(parameter.min), shown(parameter.max))?;
    }
    writeln!(comment, "     * - Default: {}", shown_default(parameter)?)?;
    writeln!(comment, "     * - Source: {}", parameter.source)?;
    Ok(comment)
}

fn type_of(kind: Kind) -> String {
    match kind {
        Kind::Number | Kind::Integer => "number".into(),
        Kind::Optional => "number | null".into(),
        Kind::Flag => "boolean".into(),
        Kind::Vector => "[x: number, y: number, z: number]".into(),
        Kind::Forces => "PointForce[]".into(),
        Kind::Choice(options) => {
            options.iter().map(|option| format!("\"{option}\"")).collect::<Vec<_>>().join(" | ")
        }
    }
}
