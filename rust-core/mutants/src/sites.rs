//! The places of a source where a choice between mutants goes.

use std::ops::Range;

use anyhow::{Result, ensure};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprBinary, ExprMatch, ExprStruct, ExprUnary, Stmt};

use crate::list::{Genre, Mutant};

/// An expression of which there are mutants, or the begin of a body that mutants leave at once.
pub(crate) struct Site {
    /// Its bytes; none before the first statement of a body.
    pub(crate) range: Range<usize>,
    /// A whole statement takes no parentheses: with them what follows would be its argument.
    pub(crate) is_statement: bool,
    pub(crate) changes: Vec<Change>,
}

/// One mutant: these bytes become that text.
pub(crate) struct Change {
    pub(crate) id: u32,
    pub(crate) range: Range<usize>,
    pub(crate) replacement: String,
}

/// All sites of a source, the outer before the inner.
///
/// # Errors
/// The source is no Rust.
pub(crate) fn of(source: &str, mutants: &[&Mutant]) -> Result<Vec<Site>> {
    let mutants = mutants.iter().map(|&mutant| (mutant, mutant.span.in_bytes(source))).collect();
    let mut finder = Finder { mutants, sites: Vec::new(), statement: 0..0 };
    let file = syn::parse_file(source)?;
    ensure!(source.is_empty() || file.span().byte_range().end <= source.len(), "bytes are not counted");
    finder.visit_file(&file);
    let (mutants, mut sites) = (finder.mutants, finder.sites);
    for (mutant, span) in mutants.iter().filter(|(mutant, _)| mutant.genre == Genre::FnValue) {
        let at = span.start;
        let change = Change { id: mutant.id, range: at..at, replacement: mutant.replacement.clone() };
        match sites.iter_mut().find(|site| site.range == (at..at)) {
            Some(site) => site.changes.push(change),
            None => sites.push(Site { range: at..at, is_statement: true, changes: vec![change] }),
        }
    }
    sites.sort_by_key(|site| {
        let is_within = !site.range.is_empty();
        (site.range.start, is_within, usize::MAX - site.range.end)
    });
    Ok(sites)
}

struct Finder<'a> {
    /// Each with its bytes.
    mutants: Vec<(&'a Mutant, Range<usize>)>,
    sites: Vec<Site>,
    /// The statement without a semicolon that was entered last.
    statement: Range<usize>,
}

impl Finder<'_> {
    /// Makes `whole` a site, if there are mutants of that kind that change what `changed` accepts.
    fn note(&mut self, whole: Range<usize>, genres: &[Genre], changed: impl Fn(&Range<usize>) -> bool) {
        let changes: Vec<Change> = self
            .mutants
            .iter()
            .filter(|(mutant, range)| genres.contains(&mutant.genre) && changed(range))
            .map(|(mutant, range)| Change {
                id: mutant.id,
                range: range.clone(),
                replacement: mutant.replacement.clone(),
            })
            .collect();
        if !changes.is_empty() {
            let is_statement = whole == self.statement;
            self.sites.push(Site { range: whole, is_statement, changes });
        }
    }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        if let Stmt::Expr(expression, None) = statement {
            self.statement = expression.span().byte_range();
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_expr_binary(&mut self, binary: &'ast ExprBinary) {
        let operator = operator(&binary.op);
        // `if let … && …` is no expression that can stand elsewhere.
        if !is_chain(binary) {
            self.note(binary.span().byte_range(), &[Genre::BinaryOperator], |range| *range == operator);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'ast ExprUnary) {
        let operator = unary.op.span().byte_range();
        self.note(unary.span().byte_range(), &[Genre::UnaryOperator], |range| *range == operator);
        visit::visit_expr_unary(self, unary);
    }

    fn visit_expr_match(&mut self, choice: &'ast ExprMatch) {
        let arms: Vec<_> = choice
            .arms
            .iter()
            .map(|arm| {
                let guard = arm.guard.as_ref().map(|(_, guard)| guard.span().byte_range());
                (arm.span().byte_range(), guard)
            })
            .collect();
        self.note(choice.span().byte_range(), &[Genre::MatchArm, Genre::MatchArmGuard], |range| {
            arms.iter().any(|(arm, guard)| arm.start == range.start || guard.as_ref() == Some(range))
        });
        visit::visit_expr_match(self, choice);
    }

    fn visit_expr_struct(&mut self, value: &'ast ExprStruct) {
        let fields: Vec<_> = value.fields.iter().map(|field| field.span().byte_range().start).collect();
        self.note(value.span().byte_range(), &[Genre::StructField], |range| fields.contains(&range.start));
        visit::visit_expr_struct(self, value);
    }
}

fn operator(operator: &BinOp) -> Range<usize> {
    operator.span().byte_range()
}

fn is_chain(binary: &ExprBinary) -> bool {
    let has_let = |side: &Expr| match side {
        Expr::Let(_) => true,
        Expr::Binary(inner) => is_chain(inner),
        _ => false,
    };
    has_let(&binary.left) || has_let(&binary.right)
}
