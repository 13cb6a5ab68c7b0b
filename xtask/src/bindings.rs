use anyhow::{Context, Result};
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

/// Writes the ES module `name.js`, its type declarations and `name_bg.wasm` for the compiled module `wasm` into the folder `out`.
///
/// The glue holds `new URL('name_bg.wasm', import.meta.url)`, so that a browser and a bundler find the module beside it: the
/// library leaves that line out unless told otherwise, and Vite then builds a page without its module and reports no error.
///
/// # Errors
/// When the file cannot be read, is no module made with the same version of `wasm-bindgen`, or the output cannot be written.
pub(crate) fn write(wasm: &Path, out: &Path, name: &str) -> Result<()> {
    Bindgen::new()
        .input_path(wasm)
        .out_name(name)
        .web(true)?
        .typescript(true)
        .omit_default_module_path(false)
        .remove_producers_section(true)
        .generate(out)
        .with_context(|| format!("bindings of {} as {name}", wasm.display()))
}

#[cfg(test)]
mod tests {
    /// The version of a package in a lock file, when it is there exactly once.
    fn locked_version<'a>(lock: &'a str, package: &str) -> Option<&'a str> {
        let name = format!("name = \"{package}\"");
        let mut versions = lock
            .split("[[package]]")
            .filter(|entry| entry.lines().any(|line| line == name))
            .filter_map(|entry| entry.lines().find_map(|line| line.strip_prefix("version = ")));
        versions.next().filter(|_| versions.next().is_none()).map(|version| version.trim_matches('"'))
    }

    /// The two speak a private protocol: with different versions the bindings are refused or, worse, wrong.
    #[test]
    fn wasm_bindgen_and_its_command_line_support_have_the_same_version() {
        let lock = include_str!("../../Cargo.lock");
        let library = locked_version(lock, "wasm-bindgen");
        assert!(library.is_some(), "Cargo.lock holds wasm-bindgen not exactly once");
        assert_eq!(library, locked_version(lock, "wasm-bindgen-cli-support"));
    }

    #[test]
    fn locked_version_refuses_a_package_that_is_missing_or_there_twice() {
        let lock = "[[package]]\nname = \"a\"\nversion = \"1.0.0\"\n[[package]]\nname = \"b\"\nversion = \"1.0.0\"\n\
                    [[package]]\nname = \"b\"\nversion = \"2.0.0\"\n";
        assert_eq!(locked_version(lock, "a"), Some("1.0.0"));
        assert_eq!(locked_version(lock, "b"), None);
        assert_eq!(locked_version(lock, "c"), None);
    }
}
