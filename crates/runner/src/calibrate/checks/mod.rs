//! Checks of readings and of the fit to them, in one list.
//!
//! Values that are impossible for any string are checked where the file is read
//! ([`ImportedReadings::measured`](wholestring_tabular::ImportedReadings::measured)); values that
//! the string in this hole cannot give are checked before the fit (`units`, `block`), and the
//! result after it (`found`).

mod block;
mod found;
mod text;
mod trial;
mod units;

use wholestring_case::Case;
use wholestring_judge::{CheckKind, ReadingCheck, Severity};
use wholestring_plan::calibration::{Channel, Settings};
use wholestring_units::UnitSet;

pub(super) use found::of_fit;
pub(super) use text::{median, shown, warning};

use super::settings;
use crate::{
    cancellation::CancellationToken,
    error::Error,
    readings::{Readings, deepest_m, refused},
};
use trial::Trial;

/// Checks readings against the loads of the string in this hole with any friction. Impossible
/// readings are left out; if a whole column is impossible, the readings are refused.
///
/// # Errors
/// Columns in another unit, or a hole in which friction does not change any reading.
pub(super) fn by_string(
    name: &str,
    data: &mut Readings,
    settings: &Settings,
    units: UnitSet,
    cancellation: &CancellationToken,
) -> Result<(), Error> {
    let Some(trial) = Trial::of(data, settings, cancellation)? else { return Ok(()) };
    let at = |factor: f64| match scaled(data, factor) {
        Some(other) => Trial::of(&other, settings, cancellation),
        None => Ok(None),
    };
    let mut checks: Vec<ReadingCheck> = match units::depths(data, &trial, at)? {
        Some(check) => vec![check],
        None => units::weights(data, &trial),
    };
    checks.extend(units::torques(data, &trial));
    let wants_friction = settings.parameters.iter().any(|parameter| parameter.is_factor());
    if wants_friction && !checks.iter().any(|check| check.check.severity == Severity::Error) {
        checks.extend(block::no_friction(data, &trial));
    }
    let mut checks = in_units(checks, units);
    refused(name, &checks)?;
    checks.extend(block::in_some(data, &trial).or_else(|| block::of_case(data, &trial)));
    if !checks.iter().any(|check| check.check.kind == CheckKind::BlockNotInReadings) {
        checks.extend(in_units(block::below(data, &trial), units));
        refused(name, &checks)?;
    }
    data.checks.extend(in_units(checks, units));
    Ok(())
}

/// Checks the readings that a plan is compared with, as a calibration does, except that the hole may
/// be too straight for friction to have an effect, and with the rows that a fit does not use.
///
/// # Errors
/// Columns in another unit, or too few valid readings.
pub(crate) fn of_comparison(
    name: &str,
    data: &mut Readings,
    case: &Case,
    units: UnitSet,
    cancellation: &CancellationToken,
) -> Result<(), Error> {
    let held_out = std::mem::take(&mut data.held_out);
    let held_out_places = std::mem::take(&mut data.held_out_places);
    let held_out: Vec<(Channel, String)> = held_out
        .into_iter()
        .zip(held_out_places)
        .map(|(reading, place)| {
            data.readings.push(reading);
            data.places.push(place.clone());
            (reading.channel, place)
        })
        .collect();
    by_string(name, data, &settings::of_comparison(case), units, cancellation)?;
    let readings = std::mem::take(&mut data.readings);
    for (reading, place) in readings.into_iter().zip(std::mem::take(&mut data.places)) {
        let key = (reading.channel, place);
        let (readings, places) = match held_out.contains(&key) {
            true => (&mut data.held_out, &mut data.held_out_places),
            false => (&mut data.readings, &mut data.places),
        };
        readings.push(reading);
        places.push(key.1);
    }
    Ok(())
}

/// The readings with their depths multiplied by a factor; `None` if one is not in its hole then.
fn scaled(data: &Readings, factor: f64) -> Option<Readings> {
    let mut scaled = data.clone();
    for reading in &mut scaled.readings {
        let assembly = &data.assemblies[reading.setup];
        reading.bit_depth_m *= factor;
        // A depth at the end of the hole may be rounded beyond it.
        let deepest_m = deepest_m(assembly);
        if reading.bit_depth_m > deepest_m + 1.0
            || reading.bit_depth_m <= assembly.setup.assembly_m()
        {
            return None;
        }
        reading.bit_depth_m = reading.bit_depth_m.min(deepest_m);
    }
    Some(scaled)
}

/// The checks with their sentences in these units.
pub(super) fn in_units(checks: Vec<ReadingCheck>, units: UnitSet) -> Vec<ReadingCheck> {
    checks.into_iter().map(|check| check.in_units(units)).collect()
}

/// The checks as in `summary.json`, warnings first.
pub(super) fn recorded(checks: &[ReadingCheck]) -> Vec<ReadingCheck> {
    let mut sorted = checks.to_vec();
    sorted.sort_by_key(|found| std::cmp::Reverse(found.check.severity));
    sorted
}

/// The sentences of one severity.
pub(crate) fn sentences(checks: &[ReadingCheck], severity: Severity) -> Vec<String> {
    let checks = checks.iter().filter(|check| check.check.severity == severity);
    checks.map(|check| check.check.sentence.clone()).collect()
}
