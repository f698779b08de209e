//! What a list says of a case.

use wholestring_case::{Files, Severity, parse};
use wholestring_config::node::{Value, parse_text};

/// What a case is called, and what is wrong with it.
#[derive(Debug, Default)]
pub struct Title {
    /// What it is called in results, if it says so.
    pub name: Option<String>,
    /// The first that is wrong with it; none where nothing is.
    pub problem: Option<String>,
    /// The case with all defaults filled in; none where it is not valid.
    pub settings: Option<serde_json::Value>,
}

impl Title {
    /// Of a text in a file of this name beside these files.
    pub fn of(name: &str, text: &str, files: &dyn Files) -> Self {
        match parse(name, text.as_bytes(), files, &[]) {
            Ok(case) => {
                Self { name: Some(case.name), problem: None, settings: Some(case.settings) }
            }
            Err(report) => {
                let mut errors = report.diagnostics.iter();
                let first = errors.find(|one| one.severity == Severity::Error);
                let problem = first.map(|error| error.message.clone());
                Self { name: named(text), problem, settings: None }
            }
        }
    }
}

/// The name that a case gives itself, though it is not valid.
fn named(text: &str) -> Option<String> {
    match &parse_text(text, 0).ok()?.get("name")?.value {
        Value::Text { text, .. } => Some(text.clone()),
        _ => None,
    }
}
