//! Numbers and values as JSON and as a person would write them.

use anyhow::{Result, bail};
use bough::params::{Kind, Parameter};
use serde_json::{Number, Value};

/// A number without a needless `.0`.
pub(crate) fn number(value: f64) -> Value {
    let is_whole = value.fract() == 0.0 && value.abs() < 1e15;
    if is_whole { Value::from(value as i64) } else { Number::from_f64(value).into() }
}

/// The JSON value of a parameter's flat form: a number, an option's name, true or false, or three numbers.
pub(crate) fn value(parameter: &Parameter, flat: &[f64]) -> Result<Value> {
    let json = match (parameter.kind, flat) {
        (Kind::Number | Kind::Integer, [one]) => number(*one),
        (Kind::Optional, [one]) => {
            if one.is_nan() {
                Value::Null
            } else {
                number(*one)
            }
        }
        (Kind::Flag, [flag]) => Value::from(*flag != 0.0),
        (Kind::Vector, [_, _, _]) => flat.iter().copied().map(number).collect(),
        (Kind::Forces, []) => Value::Array(Vec::new()),
        (Kind::Choice(options), [index]) => match options.get(*index as usize) {
            Some(option) => Value::from(*option),
            None => bail!("{} has no option {index}", parameter.path),
        },
        _ => bail!("{} cannot be {flat:?}", parameter.path),
    };
    Ok(json)
}

/// A number for reading: plain where it is short, scientific where it is not.
pub(crate) fn shown(value: f64) -> String {
    let is_plain = value == 0.0 || (1e-4..1e6).contains(&value.abs());
    if is_plain { format!("{value}") } else { format!("{value:e}") }
}

/// The default for reading: numbers as [`shown`], others as JSON.
pub(crate) fn shown_default(parameter: &Parameter) -> Result<String> {
    match (parameter.kind, parameter.default) {
        (Kind::Number | Kind::Integer, [one]) => Ok(shown(*one)),
        (Kind::Optional, [one]) if one.is_nan() => Ok("none".into()),
        _ => Ok(value(parameter, parameter.default)?.to_string()),
    }
}

/// A path's group and field: every parameter belongs to one group.
pub(crate) fn group_and_field(parameter: &Parameter) -> Result<(&'static str, &'static str)> {
    match parameter.path.split_once('.') {
        Some((group, field)) if !field.contains('.') => Ok((group, field)),
        _ => bail!("the path {} is not `group.field`", parameter.path),
    }
}
