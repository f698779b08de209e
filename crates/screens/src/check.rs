//! Is a text a valid case?

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_case::{Files, Parts, parse};
use wholestring_config::node;

use crate::{
    diagnostic::{self, Diagnostic, Level},
    layout::Layout,
    quantities::{self, Quantities},
    values,
};

/// A text that may stand in the file of a case.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// The text.
    pub text: String,
}

/// What is to be said about a text.
#[derive(Debug, Serialize, ToSchema)]
pub struct Checked {
    /// Errors, warnings and notes.
    diagnostics: Vec<Diagnostic>,
    /// The text as JSON, numbers and texts as they stand; null where it is no TOML.
    #[schema(value_type = Option<Object>)]
    values: Option<serde_json::Value>,
    /// What its texts are worth in SI, by dimension and text: `{"length": {"10 ft": 3.048}}`.
    #[schema(value_type = Object)]
    quantities: Quantities,
    /// What can be drawn of it.
    layout: Layout,
}

/// Says what the command line says of a text, as if it stood in the file of this name beside these
/// files.
pub fn check(name: &str, text: &str, files: &dyn Files) -> Checked {
    let diagnostics = match &parse(name, text.as_bytes(), files, &[]) {
        Err(report) => diagnostic::of_report(report),
        Ok(checked) => {
            let survey = checked.survey_notes.iter().map(|note| ("well.survey", note));
            let mud = checked.mud_notes.iter().map(|note| ("mud.dial_readings", note));
            let notes = survey.chain(mud).map(|(key, note)| Diagnostic {
                level: Level::Note,
                key: Some(key.to_owned()),
                ..Diagnostic::sentence(note)
            });
            diagnostic::of_report(&checked.warnings).into_iter().chain(notes).collect()
        }
    };
    let tree = node::parse_text(text, 0).ok();
    let quantities = tree.as_ref().map(quantities::of_table).unwrap_or_default();
    let values = tree.map(|entries| values::of_table(&entries, text));
    let parts = Parts::read(name, text.as_bytes(), files);
    Checked { diagnostics, values, quantities, layout: Layout::of(parts) }
}
