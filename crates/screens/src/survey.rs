//! A survey out of a spreadsheet, as it comes out of the clipboard.

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
    /// Unit of the lengths, where the heading does not tell it.
    #[serde(default)]
    length_unit: Option<String>,
}

/// A survey.
#[derive(Debug, Serialize, ToSchema)]
pub struct Survey {
    /// The stations.
    stations: Stations,
    /// Where the first lies, if that is said.
    tie_in: Option<Start>,
    /// What was recognised and assumed, in sentences.
    notes: Vec<String>,
}

/// Stations, column by column.
#[derive(Debug, Serialize, ToSchema)]
pub struct Stations {
    md_m: Vec<f64>,
    inclination_rad: Vec<f64>,
    azimuth_rad: Vec<f64>,
    /// From the station above, along a circular arc; 0 of the first.
    dogleg_severity_rad_per_m: Vec<f64>,
}

/// Where the first station lies.
#[derive(Debug, Serialize, ToSchema)]
pub struct Start {
    north_m: f64,
    east_m: f64,
    tvd_m: f64,
}

impl Stations {
    /// Columns of a survey. Where the depth does not grow there is no dogleg: 0.
    pub(super) fn of(list: &[Station]) -> Self {
        let above = list.iter().take(1).chain(list);
        let dogleg = above.zip(list).map(|(above, below)| {
            let length_m = below.md_m - above.md_m;
            if length_m > 0.0 { above.dogleg_rad(below) / length_m } else { 0.0 }
        });
        Self {
            md_m: list.iter().map(|of| of.md_m).collect(),
            inclination_rad: list.iter().map(|of| of.inclination_rad).collect(),
            azimuth_rad: list.iter().map(|of| of.azimuth_rad).collect(),
            dogleg_severity_rad_per_m: dogleg.collect(),
        }
    }
}

impl From<TieIn> for Start {
    fn from(of: TieIn) -> Self {
        Self { north_m: of.north_m, east_m: of.east_m, tvd_m: of.tvd_m }
    }
}

/// Reads rows as `import` reads a survey's file: columns by their headings, units from there. Nothing
/// is written.
///
/// # Errors
/// A unit that is none of length, and rows that are no survey.
pub fn survey(pasted: &Pasted) -> Result<Survey, Refusal> {
    let unit = |symbol: &str| {
        let known = Dimension::Length.find_unit(symbol);
        known.ok_or_else(|| Refusal::bad_input(format!("`{symbol}` is no unit of length")))
    };
    let length_unit = pasted.length_unit.as_deref().map(unit).transpose()?;
    let said = Said { length_unit, ..Said::default() };
    let read = read_as(pasted.text.as_bytes(), "what was pasted", &said);
    let read = read.map_err(|error| Refusal::bad_input(error.to_string()))?;
    Ok(Survey {
        stations: Stations::of(&read.stations),
        tie_in: read.tie_in.map(Start::from),
        notes: read.notes,
    })
}
