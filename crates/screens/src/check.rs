//! Validation of a text as a case.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_case::{Files, Parts, parse};
use wholestring_config::node;

use crate::{
    diagnostic::{self, Diagnostic, Level},
    layout::Layout,
    values::{self, CaseValue, Quantities},
};

/// A text that may be the contents of a case file.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// The text.
    pub text: String,
}

/// Diagnostics and values of a text.
#[derive(Debug, Serialize, ToSchema)]
pub struct Checked {
    /// Errors, warnings and notes.
    diagnostics: Vec<Diagnostic>,
    /// The text as JSON, with unchanged numbers and texts; null if it is not TOML.
    #[schema(value_type = Option<BTreeMap<String, CaseValue>>)]
    values: Option<serde_json::Value>,
    /// SI values of its texts, by dimension and text: `{"length": {"10 ft": 3.048}}`.
    #[schema(value_type = BTreeMap<String, BTreeMap<String, f64>>)]
    quantities: Quantities,
    /// Its drawing.
    layout: Layout,
}

/// Returns the diagnostics of the command line for a text, as if it were in the file of this name
/// next to these files.
pub fn check(name: &str, text: &str, files: &dyn Files) -> Checked {
    let diagnostics = match &parse(name, text.as_bytes(), files, &[]) {
        Err(report) => diagnostic::of_report(report),
        Ok(checked) => {
            let survey = checked.survey_notes.iter().map(|note| ("well.survey", note));
            let hole = checked.hole_notes.iter().map(|note| ("well.hole", note));
            let mud = checked.mud_notes.iter().map(|note| ("mud.dial_readings", note));
            let notes = survey.chain(hole).chain(mud).map(|(key, note)| Diagnostic {
                level: Level::Note,
                key: Some(key.to_owned()),
                ..Diagnostic::sentence(note)
            });
            diagnostic::of_report(&checked.warnings).into_iter().chain(notes).collect()
        }
    };
    let tree = node::parse_text(text, 0).ok();
    let quantities = tree.as_ref().map(values::quantities_of_table).unwrap_or_default();
    let values = tree.map(|entries| values::of_table(&entries, text));
    let parts = Parts::read(name, text.as_bytes(), files);
    Checked { diagnostics, values, quantities, layout: Layout::of(parts) }
}
