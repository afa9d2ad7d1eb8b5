//! What `cargo mutants --list --json` says of a mutant.

use std::ops::Range;

use serde::Deserialize;

/// A change of the code: what stands in `span` of `file` becomes `replacement`.
#[derive(Deserialize)]
pub(crate) struct Mutant {
    /// Its number in the whole list; what is left out of the list keeps the numbers of the others.
    pub(crate) id: u32,
    pub(crate) file: String,
    pub(crate) genre: Genre,
    pub(crate) span: Span,
    pub(crate) replacement: String,
}

/// What is changed.
#[derive(Deserialize, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Genre {
    /// The body of a function becomes a value.
    FnValue,
    BinaryOperator,
    UnaryOperator,
    MatchArm,
    MatchArmGuard,
    StructField,
}

#[derive(Deserialize)]
pub(crate) struct Span {
    start: Place,
    end: Place,
}

/// Counted from 1, the column in characters.
#[derive(Deserialize)]
struct Place {
    line: usize,
    column: usize,
}

impl Span {
    /// The bytes of `source` that it covers.
    pub(crate) fn in_bytes(&self, source: &str) -> Range<usize> {
        self.start.in_bytes(source)..self.end.in_bytes(source)
    }
}

impl Place {
    fn in_bytes(&self, source: &str) -> usize {
        let before: usize = source.split_inclusive('\n').take(self.line - 1).map(str::len).sum();
        let line = source[before..].chars().take(self.column - 1);
        before + line.map(char::len_utf8).sum::<usize>()
    }
}
