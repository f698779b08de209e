//! A survey as a text report in columns of fixed width, like that of well planning programs.

use std::fmt::Write;

use wholestring_units::Dimension;

use crate::{look::Look, survey::Row};

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
