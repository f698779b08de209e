//! Every check of readings and of what was found from them, in one list.
//!
//! What no reading can be, whatever the string, is checked where the file is read
//! ([`ImportedReadings::measured`](wholestring_tabular::ImportedReadings::measured)); what the string in this
//! hole cannot give is checked before the fit (`units`, `block`), and the fit after it (`found`).

mod block;
mod found;
mod trial;
mod units;

use wholestring_plan::calibration::{Channel, Settings};
use wholestring_results as results;
use wholestring_tabular::{CheckSeverity, ReadingCheck};
use wholestring_units::{Dimension, UnitSet};

pub(super) use found::of_fit;

use crate::{
    cancellation::CancellationToken,
    error::Error,
    readings::{Readings, refused},
};
use trial::Trial;

/// A warning that is not a matter of single readings.
pub(super) fn warning(kind: &'static str, sentence: String) -> ReadingCheck {
    ReadingCheck {
        kind,
        severity: CheckSeverity::Warning,
        places: Vec::new(),
        value: None,
        limit: None,
        sentence,
    }
}

/// Checks of readings against what the string in this hole gives with any friction. Readings that it cannot give
/// are left out; the others are refused where a whole column is none.
///
/// # Errors
/// Columns in another unit, or a hole in which friction changes nothing that was read.
pub(super) fn by_string(
    name: &str,
    data: &mut Readings,
    settings: &Settings,
    units: UnitSet,
    cancellation: &CancellationToken,
) -> Result<(), Error> {
    let Some(trial) = Trial::of(data, settings, cancellation)? else { return Ok(()) };
    let mut checks: Vec<ReadingCheck> = units::weights(data, &trial, units);
    checks.extend(units::torques(data, &trial, units));
    let wants_friction = settings.parameters.iter().any(|of| of.is_factor());
    if wants_friction && !checks.iter().any(|of| of.severity == CheckSeverity::Error) {
        checks.extend(block::no_friction(data, &trial, units));
    }
    refused(name, &checks)?;
    checks.extend(block::of_case(data, &trial, units));
    if !checks.iter().any(|of| of.kind == block::NOT_IN_READINGS) {
        checks.extend(block::below(data, &trial, units));
    }
    data.checks.extend(checks);
    Ok(())
}

/// The list as `summary.json` has it, warnings first.
pub(super) fn recorded(checks: &[ReadingCheck]) -> Vec<results::ReadingCheck> {
    let mut sorted: Vec<&ReadingCheck> = checks.iter().collect();
    sorted.sort_by_key(|of| std::cmp::Reverse(of.severity));
    let recorded = sorted.into_iter().map(|of| results::ReadingCheck {
        kind: of.kind.to_owned(),
        severity: of.severity.name().to_owned(),
        lines: of.places.clone(),
        value: of.value,
        limit: of.limit,
        sentence: of.sentence.clone(),
    });
    recorded.collect()
}

/// The sentences of one severity.
pub(super) fn sentences(checks: &[ReadingCheck], severity: CheckSeverity) -> Vec<String> {
    let of = checks.iter().filter(|of| of.severity == severity);
    of.map(|of| of.sentence.clone()).collect()
}

/// What a channel's readings measure.
pub(super) fn dimension(channel: Channel) -> Dimension {
    if channel.is_torque() { Dimension::Torque } else { Dimension::Force }
}

/// A channel in a sentence.
pub(super) fn words(channel: Channel) -> &'static str {
    match channel {
        Channel::PickUp => "pick-up weight",
        Channel::SlackOff => "slack-off weight",
        Channel::Rotating => "rotating weight",
        Channel::OffBottomTorque => "torque off bottom",
        Channel::OnBottomTorque => "torque on bottom",
    }
}

/// A number in three digits, with its unit.
pub(super) fn shown(value: f64, dimension: Dimension, units: UnitSet) -> String {
    let unit = dimension.unit_in(units);
    let value = unit.from_si(value);
    let digits = 2 - libm::log10(value.abs().max(1e-9)).floor() as i32;
    format!("{value:.*} {}", digits.clamp(0, 6) as usize, unit.symbol)
}

/// A depth in whole units.
pub(super) fn whole(depth_m: f64, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!("{:.0} {}", unit.from_si(depth_m), unit.symbol)
}

/// The value in the middle; zero of none.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        count if count % 2 == 1 => values[count / 2],
        count => 0.5 * (values[count / 2 - 1] + values[count / 2]),
    }
}
