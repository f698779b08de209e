//! Sentences on implausible turns of a survey.

use wholestring::well::{DoubtfulTurn, Station, doubtful_turns};
use wholestring_units::UnitSet;

use super::places::{degrees, depth, severity};

/// Difference from the expected angle below which a candidate is accepted as the intended one, deg.
const MEANT_DEG: f64 = 3.0;

/// An implausible turn, in words.
#[derive(Debug, Clone, PartialEq)]
pub struct StationDoubt {
    /// The station of the turn, counted from 0.
    pub index: usize,
    /// Description of the turn.
    pub sentence: String,
    /// The station's angles.
    pub label: String,
    /// Possible explanation.
    pub help: String,
}

/// Returns the implausible turns of a survey, in words: sharper than `endured_rad_per_m`, or there
/// and back at one station.
pub fn station_doubts(
    stations: &[Station],
    endured_rad_per_m: f64,
    set: UnitSet,
) -> Vec<StationDoubt> {
    let turns = doubtful_turns(stations, endured_rad_per_m).into_iter();
    turns.filter_map(|turn| in_words(turn, stations, endured_rad_per_m, set)).collect()
}

fn in_words(
    turn: DoubtfulTurn,
    stations: &[Station],
    endured_rad_per_m: f64,
    set: UnitSet,
) -> Option<StationDoubt> {
    let station = stations.get(turn.index())?;
    let label = format!(
        "inclination {} deg, azimuth {} deg",
        degrees(station.inclination_rad),
        degrees(station.azimuth_rad)
    );
    let (sentence, help) = match turn {
        DoubtfulTurn::Slip { above_rad_per_m, below_rad_per_m, expected, .. } => (
            format!(
                "the hole turns by {} above the station at {} and back by {} below it: probably a \
                 typing error",
                severity(above_rad_per_m, set),
                depth(station.md_m, set),
                severity(below_rad_per_m, set)
            ),
            format!(
                "between its neighbours it would have an inclination of {} deg and an azimuth of {} \
                 deg{}",
                degrees(expected.inclination_rad),
                degrees(expected.azimuth_rad),
                meant(station, &expected)
            ),
        ),
        DoubtfulTurn::Sharp { first, last, severity_rad_per_m, .. } => (
            format!(
                "the hole turns by {} between {} and {}: pipe that rotates there endures {}",
                severity(severity_rad_per_m, set),
                depth(stations.get(first)?.md_m, set),
                depth(stations.get(last)?.md_m, set),
                severity(endured_rad_per_m, set)
            ),
            "is a depth, an inclination or an azimuth wrong?".to_owned(),
        ),
    };
    Some(StationDoubt { index: turn.index(), sentence, label, help })
}

/// Probable intended value: the same digits with another decimal point, or two of them exchanged.
fn meant(station: &Station, expected: &Station) -> String {
    let inclination = (station.inclination_rad, expected.inclination_rad);
    let azimuth = (station.azimuth_rad, expected.azimuth_rad);
    [inclination, azimuth]
        .into_iter()
        .filter(|(found, expected)| (found - expected).to_degrees().abs() > MEANT_DEG)
        .find_map(|(found, expected)| {
            let written = degrees(found);
            let meant = candidates(&written).into_iter().min_by(|a, b| {
                let off = |value: &f64| (value - expected.to_degrees()).abs();
                off(a).total_cmp(&off(b))
            })?;
            let is_near = (meant - expected.to_degrees()).abs() <= MEANT_DEG;
            is_near.then(|| {
                let meant = wholestring_units::number_text(meant);
                format!(": is {written} a typing error for {meant}?")
            })
        })
        .unwrap_or_default()
}

/// Numbers that a typing error may have changed into this one.
fn candidates(written: &str) -> Vec<f64> {
    let digits: Vec<char> = written.chars().collect();
    let exchanged = (1..digits.len()).map(|at| {
        let mut exchanged = digits.clone();
        exchanged.swap(at - 1, at);
        exchanged.into_iter().collect::<String>()
    });
    let mut numbers: Vec<f64> = exchanged.filter_map(|text| text.parse().ok()).collect();
    if let Ok(number) = written.parse::<f64>() {
        numbers.extend([number * 10.0, number / 10.0]);
    }
    numbers
}
