//! Parts that can be exported, and their formats.

use wholestring_export::Version;

/// Part of a case or of its results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// Tables of a folder of results; in WITSML, hook load and torque against bit depth.
    Results,
    /// Survey stations of the well.
    Survey,
    /// Components of the string, from the bit up.
    Tally,
}

/// Format of the export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated text with units in the headings.
    Csv,
    /// An Excel workbook.
    Xlsx,
    /// Columns of fixed width, as in survey reports.
    Text,
    /// WITSML in one of its versions.
    Witsml(Version),
}

impl Format {
    /// Extension of the files.
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
