//! The source with a choice at each site.

use serde::Serialize;

use crate::sites::{Change, Site};

/// Where a mutant is in the rewritten file: an error of the compiler within is its own.
#[derive(Serialize)]
pub(crate) struct Placed {
    id: u32,
    file: String,
    start: usize,
    end: usize,
}

/// The new text, and where the mutants are in it.
pub(crate) fn rewrite(source: &str, file: &str, sites: &[Site]) -> (String, Vec<Placed>) {
    let mut writer = Writer { source, file, text: String::new(), placed: Vec::new() };
    writer.write(0, source.len(), sites);
    (writer.text, writer.placed)
}

struct Writer<'a> {
    source: &'a str,
    file: &'a str,
    text: String,
    placed: Vec<Placed>,
}

impl Writer<'_> {
    /// Bytes `start..end` of the source, with the sites within.
    fn write(&mut self, start: usize, end: usize, mut sites: &[Site]) {
        let mut done = start;
        while let Some((site, after)) = sites.split_first() {
            let within = after.partition_point(|other| other.range.start < site.range.end);
            self.text.push_str(&self.source[done..site.range.start]);
            self.choose(site, &after[..within]);
            done = site.range.end;
            sites = &after[within..];
        }
        self.text.push_str(&self.source[done..end]);
    }

    fn choose(&mut self, site: &Site, within: &[Site]) {
        let (start, end) = (site.range.start, site.range.end);
        let (open, close) = if site.is_statement { ("", "") } else { ("(", ")") };
        self.text.push_str(open);
        for change in &site.changes {
            let begin = self.text.len();
            self.text.push_str(&format!("if crate::mutant::on({}) {{ ", change.id));
            self.text.push_str(&self.changed(site, change));
            self.text.push_str(if start == end { "; } " } else { " } else " });
            let file = self.file.to_owned();
            self.placed.push(Placed { id: change.id, file, start: begin, end: self.text.len() });
        }
        if start < end {
            self.text.push_str("{ ");
            self.write(start, end, within);
            self.text.push_str(" }");
        }
        self.text.push_str(close);
    }

    /// What the mutant has in place of the site: as only one mutant is ever on, without those within.
    fn changed(&self, site: &Site, change: &Change) -> String {
        if site.range.is_empty() {
            return format!("return {}", change.replacement);
        }
        let before = &self.source[site.range.start..change.range.start];
        let after = &self.source[change.range.end..site.range.end];
        format!("{before}{}{after}", change.replacement)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::list::Mutant;
    use crate::sites;

    /// Mutants as cargo-mutants lists them, in the only line of a source.
    fn rewritten(source: &str, changes: &[(&str, &str, &str)]) -> Result<String, anyhow::Error> {
        let listed = changes.iter().enumerate().map(|(id, (genre, from, to))| {
            let start = source.find(from).map_or(0, |at| at + 1);
            let (start, end) = ((1, start), (1, start + from.len()));
            let place = |(line, column)| serde_json::json!({ "line": line, "column": column });
            serde_json::from_value(serde_json::json!({
                "id": id, "file": "lib.rs", "genre": genre, "replacement": to,
                "span": { "start": place(start), "end": place(end) },
            }))
        });
        let mutants = listed.collect::<Result<Vec<Mutant>, _>>()?;
        let sites = sites::of(source, &mutants.iter().collect::<Vec<_>>())?;
        let (text, placed) = rewrite(source, "lib.rs", &sites);
        for Placed { id, start, end, .. } in placed {
            assert!(text[start..end].starts_with(&format!("if crate::mutant::on({id}) {{ ")), "{text}");
        }
        syn::parse_file(&text)?;
        Ok(text)
    }

    #[test]
    fn one_in_another_is_left_out_of_the_changed_copy() -> anyhow::Result<()> {
        let text = rewritten(
            "fn f(a: i32) -> i32 { a + 2 * a }",
            &[("BinaryOperator", "+", "-"), ("BinaryOperator", "*", "/"), ("BinaryOperator", "+", "*")],
        )?;
        assert_eq!(
            text,
            "fn f(a: i32) -> i32 { if crate::mutant::on(0) { a - 2 * a } else if crate::mutant::on(2) { a * 2 * a } \
             else { a + (if crate::mutant::on(1) { 2 / a } else { 2 * a }) } }",
        );
        Ok(())
    }

    #[test]
    fn values_guards_and_deletions_find_their_places() -> anyhow::Result<()> {
        let text = rewritten(
            "fn g(a: i32) -> P { let b = match a { c if c < 1 => !a, _ => 0 }; P { x: b, ..P::new() } }",
            &[
                ("FnValue", "let b", "P::default()"),
                ("MatchArmGuard", "c < 1", "false"),
                ("BinaryOperator", "<", "<="),
                ("UnaryOperator", "!", ""),
                ("StructField", "x: b,", ""),
            ],
        )?;
        for part in [
            "{ if crate::mutant::on(0) { return P::default(); } let b = ",
            "(if crate::mutant::on(1) { match a { c if false => !a, _ => 0 } } else { match a { c if ",
            "(if crate::mutant::on(2) { c <= 1 } else { c < 1 })",
            "(if crate::mutant::on(3) { a } else { !a })",
            "if crate::mutant::on(4) { P {  ..P::new() } } else { P { x: b, ..P::new() } }",
        ] {
            assert!(text.contains(part), "{part} is not in {text}");
        }
        Ok(())
    }

    /// What `if let` binds holds only there: such a chain is left as it is.
    #[test]
    fn chains_are_no_expressions() -> anyhow::Result<()> {
        let changes = [("BinaryOperator", "&&", "||")];
        let pure = "fn h(a: bool, b: bool) -> bool { a && b }";
        assert!(rewritten(pure, &changes)?.contains("{ a || b }"));
        let chain = "fn h(a: bool, b: Option<u8>) { if a && let Some(c) = b { drop(c) } }";
        assert_eq!(rewritten(chain, &changes)?, chain);
        Ok(())
    }
}
