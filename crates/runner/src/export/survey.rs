//! The survey of a case.

use wholestring::well::{Station, TieIn};
use wholestring_export::{Look, Row, rows, survey_report, trajectory};
use wholestring_report::path_of;
use wholestring_results::{Column, Data, Table};

use super::{
    format::{Format, Made, one_table},
    source::Source,
};
use crate::error::Error;

/// Exports the survey in the requested format.
pub(super) fn export(
    source: &Source,
    look: &Look,
    format: Format,
    notes: &mut Vec<String>,
) -> Result<Made, Error> {
    let Some(path) = path_of(&source.settings) else {
        return Err(Error::bad_input("the settings of these results hold no survey"));
    };
    let start = path.at(path.first_md_m()).position_m;
    let tie_in = TieIn { north_m: start.x, east_m: start.y, tvd_m: start.z };
    let stations: &[Station] = path.stations();
    let rows = rows(stations, tie_in).map_err(Error::bad_input)?;
    notes.push(format!("{} stations, positions by minimum curvature", rows.len()));
    if !source.settings["well"]["tortuosity"].is_null() {
        notes.push("the case's tortuosity is in the stations".to_owned());
    }
    let text = |text: String| Ok(Made::File(text.into_bytes()));
    match format {
        Format::Text => text(survey_report(look, &rows)),
        Format::Csv | Format::Xlsx => {
            one_table(&table(&rows), "Survey", "The stations of the case", look, format)
        }
        Format::Witsml(version) => text(trajectory(look, &rows, version).map_err(Error::failed)?),
    }
}

/// A row for each station.
fn table(rows: &[Row]) -> Table {
    type Of = fn(&Row) -> f64;
    let columns: [(&str, &str, &str, Of); 7] = [
        ("measured_depth_m", "m", "Measured depth", |row| row.md_m),
        ("inclination_rad", "rad", "Inclination from vertical", |row| row.inclination_rad),
        ("azimuth_rad", "rad", "Azimuth from north, clockwise", |row| row.azimuth_rad),
        ("tvd_m", "m", "True vertical depth", |row| row.tvd_m),
        ("north_m", "m", "Distance north", |row| row.north_m),
        ("east_m", "m", "Distance east", |row| row.east_m),
        ("dogleg_severity_rad_per_m", "rad/m", "Dogleg severity since the station above", |row| {
            row.dogleg_severity_rad_per_m
        }),
    ];
    let columns = columns.into_iter().map(|(name, unit, meaning, column)| Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        meaning: meaning.to_owned(),
        data: Data::Number(rows.iter().map(|row| Some(column(row))).collect()),
    });
    Table::new(columns.collect())
}
