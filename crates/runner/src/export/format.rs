//! What is exported, and how it is written.

use wholestring_export::Version;

/// A part of a case or of its results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// The tables of a folder of results; in WITSML hook load and torque against the depth of the bit.
    Results,
    /// The stations of the well.
    Survey,
    /// The components of the string, from the bit up.
    Tally,
}

/// How it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text with commas, units in the headings.
    Csv,
    /// An Excel workbook.
    Xlsx,
    /// Columns of one width, as reports of surveys have them.
    Text,
    /// WITSML, in one of its versions.
    Witsml(Version),
}

impl Format {
    /// The ending of its files.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Xlsx => "xlsx",
            Self::Text => "txt",
            Self::Witsml(_) => "xml",
        }
    }

    pub(super) fn version(self) -> Option<Version> {
        match self {
            Self::Witsml(version) => Some(version),
            Self::Csv | Self::Xlsx | Self::Text => None,
        }
    }
}
