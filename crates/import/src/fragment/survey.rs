//! The path of a well in a file.

use wholestring::well::{Station, TieIn};

/// Stations of a path, and where they were found.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The stations, m and rad, down the hole.
    pub stations: Vec<Station>,
    /// Where the first one lies, if the file says it.
    pub tie_in: Option<TieIn>,
    /// Where they were found: `lines 13 to 165`, `trajectory 'Plan #2'`.
    pub place: String,
    /// The units that they were found in: `ft, deg, deg`.
    pub units: String,
}
