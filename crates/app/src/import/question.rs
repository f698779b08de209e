//! Questions about missing information, answered as by `--unit`, `--value` and `--pick`.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_import::{ImportError, ImportErrorKind};
use wholestring_units::Dimension;

/// A choice that is missing or invalid.
#[derive(Debug, PartialEq, Serialize, ToSchema)]
pub(crate) struct Question {
    /// `unit`, `value` or `pick`: the option that answers it.
    ask: &'static str,
    /// The name under which it is answered: `md`, `block-weight`, `tubular`.
    name: String,
    /// Possible answers; for a value, examples of its notation.
    options: Vec<String>,
    /// The question as a sentence, with the file and the place in it.
    message: String,
}

fn units(dimension: Dimension) -> Vec<String> {
    dimension.units().iter().map(|unit| unit.symbol.to_owned()).collect()
}

impl Question {
    /// The question of an import error; none if no choice helps.
    pub(super) fn of(error: &ImportError) -> Option<Self> {
        let (ask, name, options) = match error.kind() {
            ImportErrorKind::MissingUnit { name, dimension, .. }
            | ImportErrorKind::SaidUnit { name, dimension, .. } => {
                ("unit", name.clone(), units(*dimension))
            }
            ImportErrorKind::MissingValue { name, example, .. } => {
                ("value", name.clone(), vec![example.clone()])
            }
            ImportErrorKind::SaidValue { name, .. } => ("value", name.clone(), Vec::new()),
            ImportErrorKind::Ambiguous { what, names }
            | ImportErrorKind::NoSuch { what, names, .. } => ("pick", what.clone(), names.clone()),
            ImportErrorKind::InTwoFiles { what, first } => {
                let files = vec![first.clone(), error.file().to_owned()];
                ("pick", (*what).to_owned(), files)
            }
            _ => return None,
        };
        Some(Self { ask, name, options, message: message(error) })
    }
}

/// The message without options of the command line.
fn message(error: &ImportError) -> String {
    let sentence = match error.kind() {
        ImportErrorKind::MissingUnit { what, .. } => format!("the {what} has no unit"),
        ImportErrorKind::MissingValue { what, hint, .. } => {
            format!("the {what} is missing{hint}")
        }
        ImportErrorKind::SaidUnit { said, dimension, .. } => {
            format!("'{said}' is no unit of {}", dimension.name())
        }
        ImportErrorKind::SaidValue { said, reason, .. } => format!("'{said}': {reason}"),
        ImportErrorKind::Ambiguous { what, names } => {
            format!("it holds {} of the kind '{what}'", names.len())
        }
        ImportErrorKind::InTwoFiles { what, first } => {
            format!("it holds the {what}, and so does {first}")
        }
        kind => kind.to_string(),
    };
    let place = error.place().map_or_else(String::new, |place| format!(", {place}"));
    format!("{}{place}: {sentence}", error.file())
}
