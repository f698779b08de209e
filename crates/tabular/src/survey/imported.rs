//! Contents of a survey file.

use wholestring::well::{Station, TieIn};
use wholestring_units::{Dimension, Unit, UnitSet};

use super::reader::Reader;
use crate::{
    cells::table::{Row, Table},
    columns::{column::Column, heading, layout::Layout},
    error::TableError,
    survey::{places::StationPlaces, preamble::Stated},
};

/// A survey and notes on its interpretation.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedSurvey {
    /// Two or more stations in order of increasing measured depth. Azimuths are as written, between
    /// -360 and 360 degrees; those up to 720 degrees are a turn less than written.
    pub stations: Vec<Station>,
    /// Position of the first station, if given in the file: its true vertical depth, north and
    /// east.
    pub tie_in: Option<TieIn>,
    /// Place of its rows: `lines 13 to 165`, `rows 5 to 20 of sheet 'Survey'`.
    pub place: String,
    /// The row of each station.
    pub places: StationPlaces,
    /// Symbols of the units of measured depth, inclination and azimuth.
    pub units: [&'static str; 3],
    /// Further values of each station in the file, with which the reading can be checked.
    pub stated: Vec<StatedPosition>,
    /// Headings of the columns that are not read.
    pub unread: Vec<String>,
    /// Information above the table: the well, the north reference.
    pub preamble: Vec<Stated>,
    /// Notes on what was recognised, assumed and skipped.
    pub notes: Vec<String>,
}

/// Position and dogleg severity of a station as the file states them; `None` where it does not.
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
    /// Its name: its sheet, its design, the title above it, or the place of its header.
    pub name: String,
    /// Its sheet, in a workbook.
    pub sheet: Option<String>,
    /// The survey, or the error in it.
    pub survey: Result<ImportedSurvey, TableError>,
}

impl ImportedSurvey {
    /// Position of the first station as the file states it, or else on the vertical below the
    /// origin at its measured depth.
    pub fn start(&self) -> TieIn {
        self.tie_in.unwrap_or_else(|| under_origin(&self.stations))
    }

    /// Units of sentences on it: field units for a survey in feet.
    pub fn unit_set(&self) -> UnitSet {
        let feet = Dimension::Length.unit_in(UnitSet::Field).symbol;
        if self.units[0] == feet { UnitSet::Field } else { UnitSet::Si }
    }
}

/// Puts the first station on the vertical below the origin at its measured depth.
pub fn under_origin(stations: &[Station]) -> TieIn {
    TieIn { tvd_m: stations.first().map_or(0.0, |first| first.md_m), ..TieIn::default() }
}

// Values of stations in a file that are not needed to compute the path: columns with which a
// reading is checked.

/// The column of dogleg severities and its unit.
pub(crate) struct Dogleg {
    index: usize,
    unit: &'static Unit,
}

impl Dogleg {
    /// Returns the column, if there is one with a unit.
    pub(crate) fn of(table: &Table, layout: &Layout) -> Option<Self> {
        let is_dogleg = |text: &String| {
            let plain: String = text.chars().filter(|c| c.is_alphabetic()).collect();
            let plain = plain.to_lowercase();
            plain.starts_with("dls") || plain.starts_with("dogleg") || plain.starts_with("dlsev")
        };
        let index = layout.header.iter().position(is_dogleg)?;
        let find = |text: &str| Dimension::DoglegSeverity.find_unit(text);
        let (_, brackets) = heading::part_brackets(&layout.header[index]);
        let in_row = || {
            let row = table.rows.get(layout.data.checked_sub(1)?)?;
            find(heading::bare_unit(row.text(index)))
        };
        let unit = brackets.iter().find_map(|bracket| find(bracket)).or_else(in_row)?;
        Some(Self { index, unit })
    }
}

/// Values of a station in a row; `None` for those that are not numbers.
pub(crate) fn position(
    reader: &Reader,
    layout: &Layout,
    dogleg: Option<&Dogleg>,
    row: &Row,
) -> StatedPosition {
    let length_m = |column: Column| {
        let found = layout.column(column)?;
        let cell = row.cells.get(found.index)?;
        reader.number(cell, column, found.unit).filter(|_| !reader.is_null(cell, column))
    };
    let dogleg_severity_rad_per_m = dogleg.and_then(|dogleg| {
        reader.number(row.cells.get(dogleg.index)?, Column::Inclination, dogleg.unit)
    });
    StatedPosition {
        tvd_m: length_m(Column::TrueVerticalDepth),
        north_m: length_m(Column::North),
        east_m: length_m(Column::East),
        dogleg_severity_rad_per_m,
    }
}
