//! Questions about missing information, answered as by `--unit`, `--value` and `--pick`.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_import::{ImportError, ImportErrorKind};
use wholestring_units::Dimension;

/// An option that answers a question: `--unit`, `--value` or `--pick`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Ask {
    /// A unit.
    Unit,
    /// A value.
    Value,
    /// One of several.
    Pick,
}

/// A choice that is missing or invalid.
#[derive(Debug, PartialEq, Serialize, ToSchema)]
pub(crate) struct Question {
    /// The option that answers it.
    ask: Ask,
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
                (Ask::Unit, name.clone(), units(*dimension))
            }
            ImportErrorKind::MissingValue { name, example, .. } => {
                (Ask::Value, name.clone(), vec![example.clone()])
            }
            ImportErrorKind::SaidValue { name, .. } => (Ask::Value, name.clone(), Vec::new()),
            ImportErrorKind::Ambiguous { what, names }
            | ImportErrorKind::NoSuch { what, names, .. } => {
                (Ask::Pick, what.clone(), names.clone())
            }
            ImportErrorKind::InTwoFiles { what, first } => {
                let files = vec![first.clone(), error.file().to_owned()];
                (Ask::Pick, (*what).to_owned(), files)
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
