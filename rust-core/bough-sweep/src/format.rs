//! Lines of the output.

use std::io::{self, Write};

use bough::plant::MEASURES;
use serde_json::{Map, Number, Value, json};

use crate::params::Problem;

/// How rows are written.
#[derive(Clone, Copy)]
pub(crate) enum Format {
    /// A JSON object a line.
    Json,
    /// Comma-separated values with a header.
    Csv,
}

impl Format {
    /// What stands before the first row.
    pub(crate) fn begin(self, output: &mut impl Write) -> io::Result<()> {
        let Format::Csv = self else { return Ok(()) };
        let names: Vec<_> = MEASURES.iter().map(|measure| measure.name).collect();
        writeln!(output, "line,status,{},error", names.join(","))
    }

    /// The row of a plant.
    pub(crate) fn plant(
        self,
        output: &mut impl Write,
        line: u64,
        status: &str,
        measures: &[f64],
    ) -> io::Result<()> {
        match self {
            Format::Json => {
                let mut row = Map::new();
                row.insert("line".into(), line.into());
                row.insert("status".into(), status.into());
                for (measure, value) in MEASURES.iter().zip(measures) {
                    row.insert(measure.name.into(), number(*value));
                }
                writeln!(output, "{}", Value::Object(row))
            }
            Format::Csv => {
                write!(output, "{line},{status}")?;
                for value in measures {
                    // JSON writes as many digits as it takes to read the very number back.
                    match number(*value) {
                        Value::Null => write!(output, ",")?,
                        shown => write!(output, ",{shown}")?,
                    }
                }
                writeln!(output, ",")
            }
        }
    }

    /// The row of a bad line.
    pub(crate) fn problem(self, output: &mut impl Write, line: u64, problem: &Problem) -> io::Result<()> {
        match self {
            Format::Json => {
                let issues: Vec<_> = problem
                    .issues
                    .iter()
                    .map(|issue| json!({ "code": issue.code, "path": issue.path, "message": issue.message }))
                    .collect();
                writeln!(output, "{}", json!({ "line": line, "error": problem.message, "issues": issues }))
            }
            Format::Csv => {
                let empty = ",".repeat(MEASURES.len() + 2);
                writeln!(output, "{line}{empty}\"{}\"", problem.message.replace('"', "\"\""))
            }
        }
    }
}

/// A number without a needless `.0`; null for what JSON has no number for.
fn number(value: f64) -> Value {
    let is_whole = value.fract() == 0.0 && value.abs() < 1e15;
    if is_whole { Value::from(value as i64) } else { Number::from_f64(value).into() }
}
