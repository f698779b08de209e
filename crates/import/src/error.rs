//! Errors of an import.

use wholestring_tabular::TableError;
use wholestring_units::Dimension;

/// Description of an error in one sentence, with the expected value and the option to set.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImportErrorKind {
    /// The file cannot be opened or read.
    #[error("it cannot be read: {reason}")]
    Unreadable {
        /// Message of the system.
        reason: String,
    },
    /// A table that cannot be read.
    #[error("{}", .0.sentence())]
    Table(TableError),
    /// The format is not supported.
    #[error(
        "{found}; expected a survey or a tally as text or Excel, WITSML, Landmark EDM, LAS, or a \
         log as CSV or Excel"
    )]
    NotRecognised {
        /// Description of the format found.
        found: String,
    },
    /// XML that is not well formed.
    #[error("it is not well-formed XML: {reason}")]
    NotXml {
        /// Message of the parser.
        reason: String,
    },
    /// A document type, which can make XML expand without limit.
    #[error("it declares a document type (DTD), which is not read; remove the line")]
    DocumentType,
    /// A limit on an amount is exceeded.
    #[error("it holds {found}; at most {most} are read")]
    TooMuch {
        /// The amount found and its kind.
        found: String,
        /// The limit.
        most: String,
    },
    /// A quantity without a unit.
    #[error(
        "the {what} has no unit; give it with --unit {name}={}, or one of {}", example(*dimension),
        units(*dimension)
    )]
    MissingUnit {
        /// The quantity in words.
        what: String,
        /// Its name in `--unit`.
        name: String,
        /// Its dimension.
        dimension: Dimension,
    },
    /// A unit of another dimension, or an unknown one.
    #[error("'{found}' is not a unit of {}; expected {}", dimension.name(), units(*dimension))]
    WrongUnit {
        /// The unit as written.
        found: String,
        /// The dimension.
        dimension: Dimension,
    },
    /// A value of `--unit` that is not a unit of the quantity.
    #[error("--unit {name}={said}: expected a unit of {}: {}", dimension.name(), units(*dimension))]
    SaidUnit {
        /// The name in `--unit`.
        name: String,
        /// The unit as given.
        said: String,
        /// The dimension.
        dimension: Dimension,
    },
    /// A quantity that is in no file.
    #[error("the {what} is missing; give it with --value {name}=\"{example}\"{hint}")]
    MissingValue {
        /// The quantity in words.
        what: String,
        /// Its name in `--value`.
        name: String,
        /// An example of its value.
        example: String,
        /// Its probable value with the reason: empty, or a sentence that begins with `; `.
        hint: String,
    },
    /// A value of `--value` that is not such a quantity.
    #[error("--value {name}=\"{said}\": {reason}")]
    SaidValue {
        /// The name in `--value`.
        name: String,
        /// The quantity as given.
        said: String,
        /// The error in it.
        reason: String,
    },
    /// A number was expected.
    #[error("'{found}' is not a number; the {what} was expected")]
    NotANumber {
        /// The expected quantity.
        what: String,
        /// The text found.
        found: String,
    },
    /// A number outside its range.
    #[error("the {what} {found} is out of range; expected {expected}")]
    OutOfRange {
        /// The quantity.
        what: String,
        /// The number with its unit.
        found: String,
        /// The allowed range.
        expected: String,
    },
    /// An element without which the file is useless.
    #[error("{what} is missing")]
    Missing {
        /// The missing element.
        what: String,
    },
    /// Several items of which one must be picked.
    #[error("it holds {} of the kind '{what}': {}; pick one: --pick {what}=NAME", names.len(), listed(names))]
    Ambiguous {
        /// Their kind, as in `--pick`.
        what: String,
        /// Their names.
        names: Vec<String>,
    },
    /// A picked name that is not present.
    #[error("there is no {what} '{name}'; it holds: {}", listed(names))]
    NoSuch {
        /// Its kind.
        what: String,
        /// The name that was picked.
        name: String,
        /// The names that are present.
        names: Vec<String>,
    },
    /// The same part of a case in two files.
    #[error("it holds the {what}, and so does {first}; pick one: --pick {what}={first}")]
    InTwoFiles {
        /// The part.
        what: &'static str,
        /// The other file.
        first: String,
    },
    /// Options that no file used.
    #[error("no file uses {}", .options.join(" and "))]
    Unused {
        /// The options.
        options: Vec<String>,
    },
    /// Another reason, as a sentence.
    #[error("{0}")]
    Refused(String),
}

/// Maximum number of units or names in a sentence.
const LISTED: usize = 20;

fn example(dimension: Dimension) -> &'static str {
    dimension.units().first().map_or("", |unit| unit.symbol)
}

fn units(dimension: Dimension) -> String {
    let symbols: Vec<&str> = dimension.units().iter().map(|unit| unit.symbol).collect();
    symbols.join(", ")
}

fn listed(names: &[String]) -> String {
    let mut text: Vec<String> = names.iter().take(LISTED).map(|name| format!("'{name}'")).collect();
    if names.len() > LISTED {
        text.push(format!("and {} more", names.len() - LISTED));
    }
    text.join(", ")
}

/// Error of an import, with its place in a file.
///
/// Its `Display` writes file, place and sentence.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{file}{}: {kind}", place.as_ref().map_or(String::new(), |place| format!(", {place}")))]
pub struct ImportError {
    file: String,
    place: Option<String>,
    kind: Box<ImportErrorKind>,
}

impl ImportError {
    pub(crate) fn new(file: &str, place: Option<String>, kind: ImportErrorKind) -> Self {
        Self { file: file.to_owned(), place, kind: Box::new(kind) }
    }

    /// The file's name as given.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Place in the file: `line 12`, `sheet 'BHA', cell C4`.
    pub fn place(&self) -> Option<&str> {
        self.place.as_deref()
    }

    /// Kind of error.
    pub fn kind(&self) -> &ImportErrorKind {
        &self.kind
    }
}

impl From<TableError> for ImportError {
    fn from(error: TableError) -> Self {
        let place = error.place().map(ToString::to_string);
        let file = error.file().to_owned();
        Self { file, place, kind: Box::new(ImportErrorKind::Table(error)) }
    }
}
