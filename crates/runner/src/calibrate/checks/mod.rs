//! Every check of readings and of what was found from them, in one list.
//!
//! What no reading can be, whatever the string, is checked where the file is read
//! ([`ImportedReadings::measured`](wholestring_tabular::ImportedReadings::measured)); what the string in this
//! hole cannot give is checked before the fit (`units`, `block`), and the fit after it (`found`).

mod block;
mod found;
mod text;
mod trial;
mod units;

use wholestring_judge::{CheckKind, ReadingCheck, Severity};
use wholestring_plan::calibration::Settings;
use wholestring_units::UnitSet;

pub(super) use found::of_fit;
pub(super) use text::{median, shown, warning};

use crate::{
    cancellation::CancellationToken,
    error::Error,
    readings::{Readings, refused},
};
use trial::Trial;

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
    if wants_friction && !checks.iter().any(|of| of.check.severity == Severity::Error) {
        checks.extend(block::no_friction(data, &trial, units));
    }
    refused(name, &checks)?;
    checks.extend(block::of_case(data, &trial, units));
    if !checks.iter().any(|of| of.check.kind == CheckKind::BlockNotInReadings) {
        checks.extend(block::below(data, &trial, units));
    }
    data.checks.extend(checks);
    Ok(())
}

/// The list as `summary.json` has it, warnings first.
pub(super) fn recorded(checks: &[ReadingCheck]) -> Vec<ReadingCheck> {
    let mut sorted = checks.to_vec();
    sorted.sort_by_key(|found| std::cmp::Reverse(found.check.severity));
    sorted
}

/// The sentences of one severity.
pub(super) fn sentences(checks: &[ReadingCheck], severity: Severity) -> Vec<String> {
    let of = checks.iter().filter(|of| of.check.severity == severity);
    of.map(|of| of.check.sentence.clone()).collect()
}
