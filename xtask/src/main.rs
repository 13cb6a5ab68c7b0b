//! Build helper: writes the JavaScript bindings of compiled modules.
//!
//! ```text
//! cargo xtask bindings OUT NAME=FILE.wasm [NAME=FILE.wasm ...]
//! ```
//! writes `NAME.js`, `NAME.d.ts`, `NAME_bg.wasm` and `NAME_bg.wasm.d.ts` into the folder OUT for every pair. `scripts/lib/modules.mjs`
//! calls it after it has compiled the modules.

mod bindings;

use anyhow::{Context, Result, bail};
use std::path::Path;

const USAGE: &str = "usage: cargo xtask bindings OUT NAME=FILE.wasm [NAME=FILE.wasm ...]";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [command, out, modules @ ..] if command == "bindings" && !modules.is_empty() => {
            for module in modules {
                let (name, file) = module
                    .split_once('=')
                    .with_context(|| format!("'{module}' is not NAME=FILE.wasm\n{USAGE}"))?;
                bindings::write(Path::new(file), Path::new(out), name)?;
            }
            Ok(())
        }
        _ => bail!("{USAGE}"),
    }
}
