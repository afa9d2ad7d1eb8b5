//! The declaration as data: what the form, the links and the flat form are made from.

use anyhow::{Context, Result};
use bough::params::{Kind, PARAMETERS, PRESETS, Parameter, Preset, Scale, flat_length};
use serde_json::{Map, Value, json};

use crate::text::{group_and_field, number, value};

/// The module `declaration.ts`. A module, as unlike a JSON file every bundler and browser can import it; its type is
/// left open, as a literal's would be as long as the literal.
pub(crate) fn module() -> Result<String> {
    let json = json()?;
    Ok(format!(
        "// Printed by xtask from the declaration of the parameters.\nexport const declaration: unknown = {json};\n"
    ))
}

/// The module `help.ts`: what each parameter does and where it comes from, by path. Apart, as pages load it when the first
/// person asks.
pub(crate) fn help_module() -> String {
    let help: Map<String, Value> =
        PARAMETERS.iter().map(|one| (one.path.into(), json!([one.help, one.source]))).collect();
    format!(
        "// Printed by xtask from the declaration of the parameters.\nexport const help: Readonly<Record<string, readonly [help: string, source: string]>> = {};\n",
        Value::Object(help)
    )
}

/// `{version, parameters, flatLength, presets}`.
fn json() -> Result<Value> {
    let mut offset = 0;
    let mut parameters = Vec::new();
    for parameter in PARAMETERS {
        parameters.push(parameter_json(parameter, offset)?);
        offset += parameter.kind.width();
    }
    Ok(json!({
        "version": bough::VERSION,
        "flatLength": flat_length(),
        "parameters": parameters,
        "presets": PRESETS.iter().map(preset_json).collect::<Result<Value>>()?,
    }))
}

fn parameter_json(parameter: &Parameter, offset: usize) -> Result<Value> {
    let mut json = json!({
        "path": parameter.path,
        "key": parameter.key,
        "symbol": parameter.symbol,
        "unit": parameter.unit,
        "kind": kind(parameter.kind),
        "default": value(parameter, parameter.default)?,
        "min": number(parameter.min),
        "max": number(parameter.max),
        "slider": {
            "min": number(parameter.slider_min),
            "max": number(parameter.slider_max),
            "scale": match parameter.scale { Scale::Linear => "linear", Scale::Log => "log" },
        },
        "label": parameter.label,
        "offset": offset,
        "width": parameter.kind.width(),
    });
    if let Kind::Choice(options) = parameter.kind {
        json["options"] = options.into();
    }
    Ok(json)
}

/// The name of a kind of value.
fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Number => "number",
        Kind::Optional => "optional",
        Kind::Integer => "integer",
        Kind::Choice(_) => "choice",
        Kind::Flag => "flag",
        Kind::Vector => "vector",
        Kind::Forces => "forces",
    }
}

fn preset_json(preset: &Preset) -> Result<Value> {
    let mut json = json!({
        "id": preset.id,
        "title": preset.title,
        "note": preset.note,
        "params": preset_params(preset).with_context(|| format!("in preset {}", preset.id))?,
    });
    if let Some(step) = preset.step {
        json["step"] = step.into();
    }
    Ok(json)
}

/// The preset's params as an object of groups.
fn preset_params(preset: &Preset) -> Result<Value> {
    let mut params = Map::new();
    for (path, flat) in preset.set {
        let parameter = PARAMETERS
            .iter()
            .find(|parameter| parameter.path == *path)
            .with_context(|| format!("no parameter has the path {path}"))?;
        let (group, field) = group_and_field(parameter)?;
        let fields = params.entry(group).or_insert_with(|| json!({}));
        fields[field] = value(parameter, flat)?;
    }
    Ok(Value::Object(params))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_flat_form_has_no_gaps() {
        let declaration = json().unwrap();
        let mut expected = 0;
        for parameter in declaration["parameters"].as_array().unwrap() {
            assert_eq!(parameter["offset"], expected);
            expected += parameter["width"].as_u64().unwrap();
        }
        assert_eq!(declaration["flatLength"], expected);
    }

    #[test]
    fn keys_and_paths_are_unique() {
        for parameter in PARAMETERS {
            let with_key = PARAMETERS.iter().filter(|other| other.key == parameter.key);
            let with_path = PARAMETERS.iter().filter(|other| other.path == parameter.path);
            assert_eq!((with_key.count(), with_path.count()), (1, 1), "{}", parameter.path);
        }
    }
}
