//! What a survey file gives.

use wholestring::well::{Station, TieIn};

use wholestring_units::{Dimension, UnitSet};

use crate::{
    error::TableError,
    survey::{places::StationPlaces, preamble::Stated},
};

/// A survey and how it was understood.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedSurvey {
    /// Two stations or more, by growing measured depth. Azimuths are as written, between -360 and
    /// 720 degrees: they are not wrapped.
    pub stations: Vec<Station>,
    /// Where the first station lies, if the file says so: its true vertical depth, north and east.
    pub tie_in: Option<TieIn>,
    /// Where its rows stand: `lines 13 to 165`, `rows 5 to 20 of sheet 'Survey'`.
    pub place: String,
    /// The row of each station.
    pub places: StationPlaces,
    /// Symbols of the units of measured depth, inclination and azimuth.
    pub units: [&'static str; 3],
    /// What the file says of each station beside, by which its reading can be checked.
    pub stated: Vec<StatedPosition>,
    /// Headings of the columns that are not read.
    pub unread: Vec<String>,
    /// What stands above the table: the well, where north is.
    pub preamble: Vec<Stated>,
    /// What was recognised, assumed and passed over, in sentences for people.
    pub notes: Vec<String>,
}

/// Where a file says that a station lies, and how the hole turns there; none where it does not.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StatedPosition {
    /// True vertical depth, m.
    pub tvd_m: Option<f64>,
    /// Distance north, m.
    pub north_m: Option<f64>,
    /// Distance east, m.
    pub east_m: Option<f64>,
    /// Dogleg severity since the station above, rad/m.
    pub dogleg_severity_rad_per_m: Option<f64>,
}

/// One of the surveys of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct SurveyTable {
    /// What it is called: its sheet, its design, the title above it, or the place of its header.
    pub name: String,
    /// Its sheet, in a workbook.
    pub sheet: Option<String>,
    /// The survey, or why it is none.
    pub survey: Result<ImportedSurvey, TableError>,
}

impl ImportedSurvey {
    /// Where the first station lies: as the file says, or else on the vertical under the origin, as
    /// deep as its measured depth.
    pub fn start(&self) -> TieIn {
        self.tie_in.unwrap_or_else(|| under_origin(&self.stations))
    }

    /// The units that sentences on it are in: a survey in feet has the field's.
    pub fn unit_set(&self) -> UnitSet {
        let feet = Dimension::Length.unit_in(UnitSet::Field).symbol;
        if self.units[0] == feet { UnitSet::Field } else { UnitSet::Si }
    }
}

/// The first station on the vertical under the origin, as deep as its measured depth.
pub fn under_origin(stations: &[Station]) -> TieIn {
    TieIn { tvd_m: stations.first().map_or(0.0, |first| first.md_m), ..TieIn::default() }
}
