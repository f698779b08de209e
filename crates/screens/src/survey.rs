//! A survey pasted from a spreadsheet.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring::well::{Station, TieIn};
use wholestring_tabular::{Said, read_as};
use wholestring_units::Dimension;

use crate::refusal::Refusal;

/// Rows with a heading, separated by tabs, commas, semicolons or blanks.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Pasted {
    /// The rows.
    text: String,
    /// Unit of the lengths, if the heading does not give it.
    #[serde(default)]
    length_unit: Option<String>,
}

/// A survey.
#[derive(Debug, Serialize, ToSchema)]
pub struct Survey {
    /// The stations.
    stations: Stations,
    /// Position of the first station, if given.
    tie_in: Option<Start>,
    /// Recognised and assumed properties, in sentences.
    notes: Vec<String>,
}

/// Stations, column by column.
#[derive(Debug, Serialize, ToSchema)]
pub struct Stations {
    md_m: Vec<f64>,
    inclination_rad: Vec<f64>,
    azimuth_rad: Vec<f64>,
    /// From the preceding station, along a circular arc; 0 for the first.
    dogleg_severity_rad_per_m: Vec<f64>,
}

/// Position of the first station.
#[derive(Debug, Serialize, ToSchema)]
pub struct Start {
    north_m: f64,
    east_m: f64,
    tvd_m: f64,
}

impl Stations {
    /// Columns of a survey. The dogleg severity is 0 where the depth does not increase.
    pub(super) fn of(list: &[Station]) -> Self {
        let above = list.iter().take(1).chain(list);
        let dogleg = above.zip(list).map(|(above, below)| {
            let length_m = below.md_m - above.md_m;
            if length_m > 0.0 { above.dogleg_rad(below) / length_m } else { 0.0 }
        });
        Self {
            md_m: list.iter().map(|list| list.md_m).collect(),
            inclination_rad: list.iter().map(|list| list.inclination_rad).collect(),
            azimuth_rad: list.iter().map(|list| list.azimuth_rad).collect(),
            dogleg_severity_rad_per_m: dogleg.collect(),
        }
    }
}

impl From<TieIn> for Start {
    fn from(tie_in: TieIn) -> Self {
        Self { north_m: tie_in.north_m, east_m: tie_in.east_m, tvd_m: tie_in.tvd_m }
    }
}

/// Reads rows as `import` reads a survey file: columns by their headings, which also give the
/// units. Nothing is written.
///
/// # Errors
/// A unit that is not a length, and rows that are not a survey.
pub fn survey(pasted: &Pasted) -> Result<Survey, Refusal> {
    let unit = |symbol: &str| {
        let known = Dimension::Length.find_unit(symbol);
        known.ok_or_else(|| Refusal::bad_input(format!("`{symbol}` is not a unit of length")))
    };
    let length_unit = pasted.length_unit.as_deref().map(unit).transpose()?;
    let hints = Said { length_unit, ..Said::default() };
    let read = read_as(pasted.text.as_bytes(), "pasted text", &hints);
    let read = read.map_err(|error| Refusal::bad_input(error.to_string()))?;
    Ok(Survey {
        stations: Stations::of(&read.stations),
        tie_in: read.tie_in.map(Start::from),
        notes: read.notes,
    })
}
