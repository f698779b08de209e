//! A starting case.

/// The case. Its name is filled in.
const TEMPLATE: &str = include_str!("new_case.toml");

/// The placeholder of the name.
const NAME: &str = "\"My well\"";

/// Returns the text of a commented starting case with the name `name`.
pub fn new_case(name: &str) -> String {
    let name = name.replace('\\', "\\\\").replace('"', "\\\"");
    TEMPLATE.replacen(NAME, &format!("\"{name}\""), 1)
}
