//! All mutants of the core in one build: mutant schemata (Untch, Offutt & Harrold 1993).
//!
//! cargo-mutants, which decides what the mutants are, compiles each of them anew; that takes a day for three thousand. Here each
//! place that mutants change becomes a choice, `if crate::mutant::on(17) { a - b } else { a + b }`, and which one is on is said
//! when a test is started.
//!
//! `mutants <list> <crate> <map>`: the list is that of `cargo mutants --list --json`, less what is not to be built; the sources
//! of the crate are rewritten in place; the map tells where each mutant is in them, so that the compiler's errors can be told
//! apart.

mod list;
mod rewrite;
mod sites;

use std::collections::BTreeMap;
use std::{env, fs, path::Path};

use anyhow::{Context, Result};

use list::Mutant;

/// What decides which mutant is on; goes into the crate as `src/mutant.rs`.
const SWITCH: &str = include_str!("switch.rs");

fn main() -> Result<()> {
    let mut given = env::args().skip(1);
    let mut next = |what: &str| given.next().with_context(|| format!("No {what} is given."));
    let (list, folder, map) = (next("list")?, next("crate")?, next("map")?);
    let mutants: Vec<Mutant> = serde_json::from_str(&fs::read_to_string(list)?)?;
    let mut by_file: BTreeMap<&str, Vec<&Mutant>> = BTreeMap::new();
    for mutant in &mutants {
        by_file.entry(&mutant.file).or_default().push(mutant);
    }
    let mut placed = Vec::new();
    for (file, mutants) in by_file {
        let path = Path::new(&folder).join(file);
        let source = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        let sites = sites::of(&source, &mutants).with_context(|| path.display().to_string())?;
        let (text, places) = rewrite::rewrite(&source, file, &sites);
        fs::write(&path, text)?;
        placed.extend(places);
    }
    let root = Path::new(&folder).join("bough/src");
    let library = fs::read_to_string(root.join("lib.rs"))?;
    fs::write(root.join("lib.rs"), library + "\npub mod mutant;\n")?;
    fs::write(root.join("mutant.rs"), SWITCH)?;
    fs::write(map, serde_json::to_string(&placed)?)?;
    Ok(())
}
