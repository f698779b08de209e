//! Notes of an import.

/// A sentence on the interpretation of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Note {
    /// An assumption on a value that the file does not give.
    Assumed(String),
    /// Contents of the file that are not in the case, with the reason.
    LeftOut(String),
    /// Disagreement of two statements of the file, or a value that is probably wrong.
    Warning(String),
    /// Agreement of two statements of the file, or the one that is used of two.
    Checked(String),
    /// Information on reading.
    Read(String),
}

impl Note {
    /// The sentence.
    pub fn text(&self) -> &str {
        match self {
            Note::Assumed(text)
            | Note::LeftOut(text)
            | Note::Warning(text)
            | Note::Checked(text)
            | Note::Read(text) => text,
        }
    }

    /// Kind of note: `warning`, `assumed`, `left out`, `checked`, `read`.
    pub fn kind(&self) -> &'static str {
        match self {
            Note::Assumed(_) => "assumed",
            Note::LeftOut(_) => "left out",
            Note::Warning(_) => "warning",
            Note::Checked(_) => "checked",
            Note::Read(_) => "read",
        }
    }
}
