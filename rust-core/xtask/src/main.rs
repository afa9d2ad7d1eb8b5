//! Build tool of Bough. What it writes is made from the wasm or from the declaration of the parameters.
//!
//! ```text
//! xtask glue <wasm> <folder> <name>    JavaScript and types that load the wasm
//! xtask declaration <folder>           declaration.ts, help.ts, params.ts and measures.ts
//! xtask reference [--check] <file>     the table of parameters in the docs; --check fails when it is stale
//! ```

mod declaration;
mod glue;
mod measures;
mod reference;
mod text;
mod typescript;

use std::path::Path;
use std::{env, fs};

use anyhow::{Context, Result, bail, ensure};

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["glue", wasm, folder, name] => glue::generate(Path::new(wasm), Path::new(folder), name),
        ["declaration", folder] => write_declaration(Path::new(folder)),
        ["reference", file] => write(Path::new(file), &reference::markdown()?),
        ["reference", "--check", file] => check(Path::new(file), &reference::markdown()?),
        _ => bail!(
            "xtask takes: glue <wasm> <folder> <name> | declaration <folder> | reference [--check] <file>"
        ),
    }
}

fn write_declaration(folder: &Path) -> Result<()> {
    write(&folder.join("declaration.ts"), &declaration::module()?)?;
    write(&folder.join("help.ts"), &declaration::help_module())?;
    write(&folder.join("params.ts"), &typescript::module()?)?;
    write(&folder.join("measures.ts"), &measures::module())
}

fn write(file: &Path, content: &str) -> Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(file, content).with_context(|| format!("cannot write {}", file.display()))
}

fn check(file: &Path, content: &str) -> Result<()> {
    let found = fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
    ensure!(found == content, "{} is stale; `npm run fix` prints it anew", file.display());
    Ok(())
}
