//! A survey in the usual form: stations with their positions by minimum curvature.

use std::fmt::Write;

use wholestring::well::{Interpolation, Path, PathError, Station, TieIn};
use wholestring_units::Dimension;

use crate::look::Look;

/// A station and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Measured depth, m.
    pub md_m: f64,
    /// Inclination, rad.
    pub inclination_rad: f64,
    /// Azimuth, rad, from 0 to 2π.
    pub azimuth_rad: f64,
    /// True vertical depth, m.
    pub tvd_m: f64,
    /// North, m.
    pub north_m: f64,
    /// East, m.
    pub east_m: f64,
    /// Dogleg severity from the preceding station, rad/m; zero at the first.
    pub dogleg_severity_rad_per_m: f64,
}

/// The rows of stations that begin at a tie-in. Positions are by minimum curvature, whichever curve
/// the case uses between the stations, because readers of surveys assume it.
///
/// # Errors
/// There is no path through the stations.
pub fn rows(stations: &[Station], tie_in: TieIn) -> Result<Vec<Row>, PathError> {
    let path = Path::new(stations, Interpolation::MinimumCurvature, tie_in)?;
    let points: Vec<_> = stations.iter().map(|station| path.at(station.md_m)).collect();
    let rows = stations.iter().enumerate().map(|(place, station)| {
        let above = place.checked_sub(1);
        let severity = above.map_or(0.0, |above| {
            points[above].dogleg_rad(&points[place]) / (station.md_m - stations[above].md_m)
        });
        let [north_m, east_m, tvd_m] = points[place].position_m.into();
        Row {
            md_m: station.md_m,
            inclination_rad: station.inclination_rad,
            azimuth_rad: station.azimuth_rad.rem_euclid(std::f64::consts::TAU),
            tvd_m,
            north_m,
            east_m,
            dogleg_severity_rad_per_m: severity,
        }
    });
    Ok(rows.collect())
}

// A survey as a text report in columns of fixed width, like that of well planning programs.

/// Width of a column, characters.
const WIDTH: usize = 12;

/// Decimals of lengths and positions, of angles, and of dogleg severities.
const LENGTH_DECIMALS: usize = 2;
const ANGLE_DECIMALS: usize = 3;
const SEVERITY_DECIMALS: usize = 2;

/// The report: a title, headings in three lines, a row for each station.
///
/// Lengths have two decimals, angles three.
pub fn survey_report(look: &Look, rows: &[Row]) -> String {
    // Metres and feet; metric units have surveys in metres.
    let unit = |dimension: Dimension| dimension.unit_in(look.units);
    let length = unit(Dimension::Length);
    let severity = unit(Dimension::DoglegSeverity);
    let per = severity.symbol.trim_start_matches("deg");
    let mut text = format!(
        "Well:                        {}\nMD Reference:                zero of the case\n\
         North Reference:             as in the case\n\
         Survey Calculation Method:   Minimum Curvature\n\
         Made by:                     {}, {}\n\nSurvey\n",
        plain(&look.name),
        plain(&look.program),
        plain(&look.created)
    );
    let headings = [
        ["Measured", "Depth", &format!("({})", length.symbol)],
        ["", "Inclination", "(deg)"],
        ["", "Azimuth", "(deg)"],
        ["Vertical", "Depth", &format!("({})", length.symbol)],
        ["", "+N/-S", &format!("({})", length.symbol)],
        ["", "+E/-W", &format!("({})", length.symbol)],
        ["Dogleg", "Rate", &format!("(deg{per})")],
    ];
    for line in 0..3 {
        let cells = headings.iter().map(|heading| format!("{:>WIDTH$}", heading[line]));
        let _ = writeln!(text, "{}", cells.collect::<String>().trim_end());
    }
    for row in rows {
        let lengths = |si_m: f64| fixed(length.from_si(si_m), LENGTH_DECIMALS);
        let angle = |rad: f64| fixed(rad.to_degrees(), ANGLE_DECIMALS);
        let cells = [
            lengths(row.md_m),
            angle(row.inclination_rad),
            angle(row.azimuth_rad),
            lengths(row.tvd_m),
            lengths(row.north_m),
            lengths(row.east_m),
            fixed(severity.from_si(row.dogleg_severity_rad_per_m), SEVERITY_DECIMALS),
        ];
        let cells = cells.iter().map(|cell| format!("{cell:>WIDTH$}"));
        let _ = writeln!(text, "{}", cells.collect::<String>());
    }
    text
}

/// A number without negative zero after rounding.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(size) if size.chars().all(|c| matches!(c, '0' | '.')) => size.to_owned(),
        _ => text,
    }
}

/// A text on one line.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
