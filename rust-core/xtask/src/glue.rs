//! The wasm's JavaScript: what wasm-bindgen's command line does, as a library of the locked version.

use std::path::Path;

use anyhow::Result;
use wasm_bindgen_cli_support::Bindgen;

/// Writes `<name>.js`, `<name>.d.ts` and `<name>_bg.wasm` into the folder.
pub(crate) fn generate(wasm: &Path, folder: &Path, name: &str) -> Result<()> {
    Bindgen::new()
        .input_path(wasm)
        .out_name(name)
        .web(true)?
        // Who calls says where the wasm is. A default path would make bundlers pack it, or inline it, unasked.
        .omit_default_module_path(true)
        .typescript(true)
        // After a trap the wasm's memory is in disorder: the page then makes a fresh instance.
        .reset_state_function(true)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(folder)
}
