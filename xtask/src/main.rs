//! Build helper: writes the JavaScript bindings of a compiled module.

fn main() {}
