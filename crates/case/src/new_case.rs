//! A case to begin with.

/// The case. Its name is filled in.
const TEMPLATE: &str = include_str!("new_case.toml");

/// What stands in its place.
const NAME: &str = "\"My well\"";

/// The text of a commented case to begin with, called `name`.
pub fn new_case(name: &str) -> String {
    let name = name.replace('\\', "\\\\").replace('"', "\\\"");
    TEMPLATE.replacen(NAME, &format!("\"{name}\""), 1)
}
