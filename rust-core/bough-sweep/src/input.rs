//! Lines as they come, whatever is in them.

use std::io::{self, BufRead, Read};

use serde_json::Value;

use crate::params::Problem;

/// Longest line that is read; a plant of a million forces takes less.
const LONGEST: u64 = 100_000_000;

/// A line of the input.
pub(crate) struct Line {
    bytes: Vec<u8>,
    is_too_long: bool,
    /// Whether the input ends in it, without a line break.
    is_cut: bool,
}

/// The next line, if there is one.
pub(crate) fn next(input: &mut impl BufRead) -> io::Result<Option<Line>> {
    let mut bytes = Vec::new();
    if input.by_ref().take(LONGEST).read_until(b'\n', &mut bytes)? == 0 {
        return Ok(None);
    }
    let is_whole = bytes.last() == Some(&b'\n');
    let is_too_long = !is_whole && bytes.len() as u64 == LONGEST;
    if is_too_long {
        input.skip_until(b'\n')?;
    }
    Ok(Some(Line { bytes, is_too_long, is_cut: !is_whole && !is_too_long }))
}

impl Line {
    /// Whether there is nothing in it.
    pub(crate) fn is_blank(&self) -> bool {
        self.bytes.trim_ascii().is_empty()
    }

    /// What it says.
    pub(crate) fn json(&self) -> Result<Value, Problem> {
        if self.is_too_long {
            return Err(Problem::of_line(format!("The line is longer than {LONGEST} bytes.")));
        }
        // Some editors begin a file with a mark of its encoding.
        let bytes = self.bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&self.bytes);
        serde_json::from_slice(bytes.trim_ascii_end()).map_err(|error| {
            Problem::of_line(if error.is_eof() && self.is_cut {
                "The input ends in the middle of the line.".to_owned()
            } else if error.is_eof() {
                "The line is only the beginning of JSON.".to_owned()
            } else {
                // There is but one line.
                format!(
                    "The line is not JSON: {}.",
                    error.to_string().replace(" at line 1 column ", " at byte ")
                )
            })
        })
    }
}
