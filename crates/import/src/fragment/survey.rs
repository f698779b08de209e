//! The path of a well in a file.

use wholestring::well::{Station, TieIn};

/// Stations of a path and their location.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The stations, m and rad, down the hole.
    pub stations: Vec<Station>,
    /// Position of the first one, if given in the file.
    pub tie_in: Option<TieIn>,
    /// Their location: `lines 13 to 165`, `trajectory 'Plan #2'`.
    pub place: String,
    /// Their units in the file: `ft, deg, deg`.
    pub units: String,
}
