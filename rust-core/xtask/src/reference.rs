//! The declaration as a page of the docs.

use std::fmt::Write;

use anyhow::Result;
use bough::params::{Kind, PARAMETERS, PRESETS, Parameter};

use crate::text::{group_and_field, shown, shown_default};

/// The page `docs/parameters.md`.
pub(crate) fn markdown() -> Result<String> {
    let mut page = String::from(
        "# Parameters\n\n\
         Printed from the one declaration in `rust-core/bough/src/params`; `npm run fix` prints it anew.\n\
         Params are a plain JSON object, for example `{\"axis\": {\"segments\": 20}}`. Everything has a default: `{}` is valid.\n\
         Angles are in degrees, the rest in SI units. The key is the parameter's short name in a link.\n",
    );
    let mut open_group = "";
    for parameter in PARAMETERS {
        let (group, _) = group_and_field(parameter)?;
        if group != open_group {
            write!(
                page,
                "\n## {group}\n\n\
                 | Path | Symbol | Unit | Default | Takes | Key | Meaning | Source |\n\
                 | --- | --- | --- | --- | --- | --- | --- | --- |\n"
            )?;
            open_group = group;
        }
        writeln!(page, "{}", row(parameter)?)?;
    }
    page += "\n# Presets\n\nA released preset never changes.\n\n| Id | Title | What to see |\n| --- | --- | --- |\n";
    for preset in PRESETS {
        writeln!(page, "| `{}` | {} | {} |", preset.id, preset.title, preset.note)?;
    }
    Ok(page)
}

fn row(parameter: &Parameter) -> Result<String> {
    Ok(format!(
        "| `{}` | {} | {} | {} | {} | {} | {} | {} |",
        parameter.path,
        or_dash(parameter.symbol),
        or_dash(parameter.unit),
        shown_default(parameter)?,
        takes(parameter),
        key(parameter),
        parameter.help,
        parameter.source,
    ))
}

/// The short name in a link, where there is one.
fn key(parameter: &Parameter) -> String {
    if parameter.key.is_empty() { "-".into() } else { format!("`{}`", parameter.key) }
}

fn or_dash(text: &str) -> &str {
    if text.is_empty() { "-" } else { text }
}

fn takes(parameter: &Parameter) -> String {
    let range = format!("{} to {}", shown(parameter.min), shown(parameter.max));
    match parameter.kind {
        Kind::Number => range,
        Kind::Optional => format!("{range}, or null"),
        Kind::Integer => format!("whole, {range}"),
        Kind::Vector => format!("x, y, z, each {range}"),
        Kind::Flag => "true, false".into(),
        Kind::Choice(options) => options.join(", "),
        Kind::Forces => format!("list of {{segment, force: [x, y, z]}}, each {range}"),
    }
}
