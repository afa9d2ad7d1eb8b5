//! What is wrong with a set of params, worded for a person.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;
use alloc::string::ToString;
use alloc::vec::Vec;

use core::fmt;

/// One problem with one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Issue {
    /// What kind of problem: `"notFinite"`, `"outOfRange"`, `"notInteger"`, `"notAnOption"`,
    /// `"unsupported"` or `"tooLarge"`.
    pub code: &'static str,
    /// Path of the parameter.
    pub path: &'static str,
    /// The offending number.
    pub value: f64,
    /// A sentence that names the parameter and what it takes.
    pub sentence: Sentence,
    /// Smallest accepted value, where there is a range.
    pub min: Option<f64>,
    /// Largest accepted value, where there is a range.
    pub max: Option<f64>,
}

impl Issue {
    /// An issue whose sentence is `pattern` with the numbers in their places.
    #[inline(never)]
    pub(super) fn new(
        code: &'static str,
        path: &'static str,
        value: f64,
        pattern: &str,
        numbers: &[f64],
        (min, max): (Option<f64>, Option<f64>),
    ) -> Self {
        Issue { code, path, value, sentence: Sentence::new(pattern, numbers), min, max }
    }

    /// A plant with too many segments for the record of its relaxation.
    pub(crate) fn too_long_to_relax(segments: usize, most: usize) -> Self {
        let (segments, most) = (segments as f64, most as f64);
        Issue::new(
            "tooLarge",
            "axis.segments",
            segments,
            "axis.segments must leave at most {} segments where a relaxation is recorded; there are {}.",
            &[most, segments],
            (Some(1.0), Some(most)),
        )
    }

    /// The sentence for a person.
    pub fn message(&self) -> String {
        self.sentence.to_string()
    }
}

/// A sentence with numbers in it, which a host may word in its own way: JavaScript does, and saves the code.
#[derive(Clone, Debug, PartialEq)]
pub struct Sentence {
    /// The sentence, with `{}` where a number stands.
    pub pattern: String,
    /// The numbers, in the order of their places.
    pub numbers: Vec<f64>,
}

impl Sentence {
    pub(super) fn new(pattern: impl Into<String>, numbers: &[f64]) -> Self {
        Sentence { pattern: pattern.into(), numbers: numbers.to_vec() }
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut numbers = self.numbers.iter();
        for (position, text) in self.pattern.split("{}").enumerate() {
            if let (true, Some(number)) = (position > 0, numbers.as_slice().first()) {
                formatter.write_str(&shown(*number))?;
                numbers.next();
            }
            formatter.write_str(text)?;
        }
        Ok(())
    }
}

/// Params that no plant can be grown from; lists every problem at once.
#[derive(Clone, Debug, PartialEq)]
pub struct BoughError {
    /// All problems, in the order of the declaration.
    pub issues: Vec<Issue>,
}

impl fmt::Display for BoughError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, issue) in self.issues.iter().enumerate() {
            let separator = if position == 0 { "" } else { " " };
            write!(formatter, "{separator}{}", issue.sentence)?;
        }
        Ok(())
    }
}

impl core::error::Error for BoughError {}

/// A number as a person would write it: plain where it is short, scientific where it is not.
fn shown(number: f64) -> String {
    let size = number.abs();
    if size == f64::INFINITY {
        return (if number > 0.0 { "Infinity" } else { "-Infinity" }).to_owned();
    }
    if number == 0.0 || (1e-3..1e6).contains(&size) || number.is_nan() {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}
