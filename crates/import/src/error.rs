//! Why a file cannot be imported.

use wholestring_tabular::TableError;
use wholestring_units::Dimension;

/// What is wrong, in one sentence, with what was expected and how to say it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImportErrorKind {
    /// The system does not give it.
    #[error("it cannot be read: {reason}")]
    Unreadable {
        /// What the system says.
        reason: String,
    },
    /// A table that cannot be read.
    #[error("{}", .0.sentence())]
    Table(TableError),
    /// None of the formats that are known.
    #[error(
        "{found}; expected a survey or a tally as text or Excel, WITSML, Landmark EDM, LAS, or a \
         log as CSV or Excel"
    )]
    NotRecognised {
        /// What it is instead.
        found: String,
    },
    /// XML that is not well formed.
    #[error("it is not well-formed XML: {reason}")]
    NotXml {
        /// What the parser says.
        reason: String,
    },
    /// A document type, with which XML can be made to grow without end.
    #[error("it declares a document type (DTD), which is not read; take the line out")]
    DocumentType,
    /// More of something than is read.
    #[error("it holds {found}; at most {most} are read")]
    TooMuch {
        /// How much of what.
        found: String,
        /// How much is read.
        most: String,
    },
    /// A quantity whose unit nothing tells.
    #[error(
        "the {what} has no unit; say it: --unit {name}={}, or one of {}", example(*dimension),
        units(*dimension)
    )]
    MissingUnit {
        /// The quantity in words.
        what: String,
        /// Its name in `--unit`.
        name: String,
        /// What it measures.
        dimension: Dimension,
    },
    /// A unit of something else, or none that is known.
    #[error("'{found}' is no unit of {}; expected {}", dimension.name(), units(*dimension))]
    WrongUnit {
        /// The unit as it is written.
        found: String,
        /// What is measured.
        dimension: Dimension,
    },
    /// What is said with `--unit` is no unit of the quantity.
    #[error("--unit {name}={said}: expected a unit of {}: {}", dimension.name(), units(*dimension))]
    SaidUnit {
        /// The name in `--unit`.
        name: String,
        /// The unit as it is said.
        said: String,
        /// What is measured.
        dimension: Dimension,
    },
    /// A quantity that no file tells.
    #[error("the {what} is missing; give it with --value {name}=\"{example}\"{hint}")]
    MissingValue {
        /// The quantity in words.
        what: String,
        /// Its name in `--value`.
        name: String,
        /// One as it may be said.
        example: String,
        /// What it probably is, and why; empty, or a sentence that begins with `; `.
        hint: String,
    },
    /// What is said with `--value` is no such quantity.
    #[error("--value {name}=\"{said}\": {reason}")]
    SaidValue {
        /// The name in `--value`.
        name: String,
        /// The quantity as it is said.
        said: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A number was expected.
    #[error("'{found}' is not a number; the {what} was expected")]
    NotANumber {
        /// What should stand there.
        what: String,
        /// What stands there.
        found: String,
    },
    /// A number that cannot be.
    #[error("the {what} {found} is out of range; expected {expected}")]
    OutOfRange {
        /// What it is.
        what: String,
        /// The number with its unit.
        found: String,
        /// The range.
        expected: String,
    },
    /// Something without which nothing can be made of the file.
    #[error("{what} is missing")]
    Missing {
        /// What.
        what: String,
    },
    /// Several things of which one must be picked.
    #[error("it holds {} of the kind '{what}': {}; pick one: --pick {what}=NAME", names.len(), listed(names))]
    Ambiguous {
        /// What they are, as `--pick` calls it.
        what: String,
        /// Their names.
        names: Vec<String>,
    },
    /// A name that is picked and not there.
    #[error("there is no {what} '{name}'; it holds: {}", listed(names))]
    NoSuch {
        /// What it should be.
        what: String,
        /// The name that was picked.
        name: String,
        /// The names that are there.
        names: Vec<String>,
    },
    /// Two files hold the same part of a case.
    #[error("it holds the {what}, and so does {first}; pick one: --pick {what}={first}")]
    InTwoFiles {
        /// The part.
        what: &'static str,
        /// The other file.
        first: String,
    },
    /// An option that no file asked for.
    #[error("{} says nothing that a file asks for", .options.join(" and "))]
    Unused {
        /// The options.
        options: Vec<String>,
    },
    /// Another reason, which is a sentence.
    #[error("{0}")]
    Refused(String),
}

/// How many units or names a sentence lists.
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

/// Why a file cannot be imported, and where in it.
///
/// Its `Display` gives file, place and sentence.
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

    /// The file's name as it was given.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Where in it: `line 12`, `sheet 'BHA', cell C4`.
    pub fn place(&self) -> Option<&str> {
        self.place.as_deref()
    }

    /// What is wrong.
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
