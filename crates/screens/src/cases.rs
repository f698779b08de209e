//! Data of a case for a list.

use wholestring_case::{Files, Severity, parse};
use wholestring_config::node::{Value, parse_text};

/// Name of a case, and its first mistake.
#[derive(Debug, Default)]
pub struct Title {
    /// Its name in results, if it has one.
    pub name: Option<String>,
    /// Its first mistake; none if it is valid.
    pub problem: Option<String>,
    /// The case with all defaults filled in; none if it is not valid.
    pub settings: Option<serde_json::Value>,
}

impl Title {
    /// Reads the title of a text in a file of this name next to these files.
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

/// The name in an invalid case.
fn named(text: &str) -> Option<String> {
    match &parse_text(text, 0).ok()?.get("name")?.value {
        Value::Text { text, .. } => Some(text.clone()),
        _ => None,
    }
}
