//! What is to be said of an import.

/// A sentence on how a file was understood.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Note {
    /// Something that the file does not tell was taken to be so.
    Assumed(String),
    /// Something of the file is not in the case, and why.
    LeftOut(String),
    /// Two statements of the file agree, or do not.
    Checked(String),
    /// How something was read.
    Read(String),
}

impl Note {
    /// The sentence.
    pub fn text(&self) -> &str {
        match self {
            Note::Assumed(text) | Note::LeftOut(text) | Note::Checked(text) | Note::Read(text) => {
                text
            }
        }
    }

    /// What it is: `assumed`, `left out`, `checked`, `read`.
    pub fn kind(&self) -> &'static str {
        match self {
            Note::Assumed(_) => "assumed",
            Note::LeftOut(_) => "left out",
            Note::Checked(_) => "checked",
            Note::Read(_) => "read",
        }
    }
}
