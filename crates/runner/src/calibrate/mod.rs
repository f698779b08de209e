//! Friction factors, block weight and torque on bit from readings at the surface.

mod checks;
mod dynamic;
mod notes;
pub mod option;
mod outliers;
mod page;
mod search;
mod settings;
mod tables;
mod toml;

pub use crate::readings::NamedCase;
pub(crate) use checks::{of_comparison, sentences};
pub use dynamic::CheckDynamics;
pub use option::Fit;
pub use toml::{FRAGMENT, changes};
pub use wholestring_plan::calibration::Parameter;

use std::{
    path::{Path, PathBuf},
    time::Duration,
};

use wholestring_judge::{CheckKind, Severity};
use wholestring_plan::calibration::{Calibration, Outliers, Settings};
use wholestring_report as report;
use wholestring_results::{CALIBRATION_VERSION, CalibrationSummary, Occupant, Texts, digest};
use wholestring_units::UnitSet;

use self::{search::Search, settings::settings};
use crate::{
    cancellation::CancellationToken,
    claim::Claim,
    clock::Instant,
    error::Error,
    observer::Observer,
    output::Output,
    readings::{self, Readings},
    results_kind::Results,
};

// Request of a calibration, and its outcome.

/// Request to find friction factors from readings.
#[derive(Debug)]
pub struct Request<'a> {
    /// The cases of the strings that were in the hole.
    pub cases: &'a [NamedCase<'a>],
    /// The file of the readings.
    pub data: &'a Path,
    /// Content of the file, if it is not on the disk.
    pub content: Option<&'a [u8]>,
    /// Parameters and options of the fit.
    pub fit: Fit,
    /// Depths at which dynamic simulations check the result, if requested.
    pub check: Option<CheckDynamics>,
    /// Units of the pictures and the page; by default those of the first case.
    pub units: Option<UnitSet>,
    /// Destination of the results.
    pub output: Output,
    /// Whether to also write PNG images.
    pub png: bool,
}

impl Request<'_> {
    /// Identity of the calibration: the case, readings, fit and check determine it.
    fn identity(&self, readings: &[u8]) -> String {
        let cases: Vec<_> = self.cases.iter().map(|case| case.case.identity()).collect();
        let checked = self.check.as_ref().map(|check| &check.bit_depths_m);
        digest(&(cases, digest(&readings), format!("{:?}", self.fit), checked))
    }
}

/// Outcome of a calibration.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: CalibrationSummary,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Wall-clock time, without writing and the dynamic check.
    pub took: Duration,
    /// Whether the dynamic check was interrupted.
    pub interrupted: bool,
}

/// Fits the requested parameters, and writes tables, pictures, page and the fragment of a case.
///
/// # Errors
/// Readings that cannot be read or do not determine the parameters, a string without a solution, or
/// a folder that cannot take the results.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let [first, ..] = request.cases else {
        return Err(Error::BadInput("no case is given".into()));
    };
    let bytes = readings::bytes(request.data, request.content)?;
    let mut data = readings::read(request.data, &bytes, request.cases)?;
    let units = request.units.unwrap_or(first.case.units);
    let name = request.data.display().to_string();
    if data.readings.is_empty() {
        return Err(Error::BadInput(format!(
            "{name}: no row is used, because `use` is \"no\" in every row that has a reading; write \
             \"yes\" in the rows to fit"
        )));
    }
    // Rows that were left out may be the reason why there is no fit.
    let about = format!("{name}: {}", data.notes.join("; "));
    let found = prepared(request, &name, &mut data, units, observer, cancellation);
    let (settings, search, mut robust) = found.inspect_err(|_| observer.note(&about))?;
    if let Some(check) = &request.check {
        dynamic::chosen(check, &data, units)?;
    }
    let name = format!("{} calibration", first.case.name);
    let occupant =
        Occupant { kind: "calibration".into(), name, identity: request.identity(&bytes) };
    let claimed = Claim::new(occupant, &request.output, observer).folder()?;
    let folder = &claimed.folder;
    let begun = Instant::now();
    let outliers::Fits { data, found, comparison } =
        outliers::fits(&search, data, &settings, robust.as_mut())
            .inspect_err(|_| observer.note(&about))?;
    let check = match &request.check {
        Some(check) => Some((check, dynamic::chosen(check, &data, units)?)),
        None => None,
    };
    let took = begun.elapsed();
    let robust = robust.filter(|robust| robust.outlier.len() == found.points.len());
    let mut all = data.checks.clone();
    all.extend(checks::of_fit(&data, &found, &settings, robust.as_ref()));
    all.extend(outliers::check(comparison.as_ref()));
    let mut summary = summary(request, &data, &settings, &found, units);
    summary.comparison = comparison;
    let (fragment, refused) = toml::fragment(first, &summary, &found, first.case.units);
    all.extend(refused);
    if let Some((check, depths)) = check {
        let inputs = (request.cases, check);
        summary.dynamics = dynamic::checked(inputs, &data, &found, &depths, observer, cancellation);
        let warnings = dynamic::warnings(&summary.dynamics).into_iter();
        all.extend(warnings.map(|sentence| checks::warning(CheckKind::CheckByDynamics, sentence)));
    }
    let interrupted = cancellation.is_cancelled();
    if interrupted {
        let sentence = "the dynamic check was interrupted".to_owned();
        all.push(checks::warning(CheckKind::Interrupted, sentence));
    }
    let all = checks::in_units(all, units);
    all.iter().for_each(|check| summary.texts.record(&check.check));
    summary.notes.extend(checks::sentences(&all, Severity::Note));
    summary.warnings = checks::sentences(&all, Severity::Warning);
    summary.checks = checks::recorded(&all);
    tables::write(folder, &data, &summary, &found)?;
    folder.write_file(toml::FRAGMENT, fragment.as_bytes())?;
    report::Calibration::gather(folder.path(), Some(units))?.write(folder, request.png)?;
    Ok(Outcome { summary, folder: folder.path().to_owned(), took, interrupted })
}

/// Checks the readings by the string, and returns the settings of the fit, its search and the fit
/// with a robust loss; readings that contradict the string are left out.
fn prepared<'a>(
    request: &'a Request<'a>,
    name: &str,
    data: &mut Readings,
    units: UnitSet,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
) -> Result<(Settings, Search<'a>, Option<Outliers>), Error> {
    let first_settings = settings(&request.fit, request.cases, data)?;
    checks::by_string(name, data, &first_settings, units, cancellation)?;
    // Determined again, because the readings that were left out may be the only ones of a part of
    // the hole.
    let settings = settings(&request.fit, request.cases, data)?;
    let search = Search { fit: &request.fit, cases: request.cases, observer, cancellation };
    let robust = outliers::robust(&search, data, &settings)?;
    Ok((settings, search, robust))
}

fn summary(
    request: &Request<'_>,
    data: &Readings,
    settings: &Settings,
    found: &Calibration,
    units: UnitSet,
) -> CalibrationSummary {
    let mut texts = Texts::default();
    let notes = notes::notes(data, found, settings).into_iter();
    let notes = notes.map(|note| texts.worded(note, units)).collect();
    let status = texts.worded(notes::status(found, settings), units);
    CalibrationSummary {
        schema_version: CALIBRATION_VERSION,
        cases: request.cases.iter().map(|case| case.case.name.clone()).collect(),
        settings: request.cases[0].case.settings.clone(),
        data: request.data.display().to_string(),
        model: request.fit.model,
        estimates: tables::estimates(found),
        held: tables::held(settings),
        correlation: found.correlation.clone(),
        condition: found.condition,
        errors: tables::errors(found),
        chi2: found.chi2,
        degrees_of_freedom: found.degrees_of_freedom,
        log_likelihood: found.log_likelihood,
        confidence: settings.confidence,
        band_confidence: settings.band_confidence,
        outlier_beyond: settings.outlier_beyond,
        readings: found.points.len(),
        within_band: found.points.iter().filter(|point| point.within_band).count(),
        held_out: found.held_out.len(),
        held_out_within_band: found.held_out.iter().filter(|held_out| held_out.within_band).count(),
        interpolation_error: found.interpolation_error,
        strings: found.strings,
        status,
        comparison: None,
        checks: Vec::new(),
        notes,
        warnings: Vec::new(),
        dynamics: Vec::new(),
        texts,
    }
}
