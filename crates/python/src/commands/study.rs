//! A study.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring_runner::{Keep, study};

use super::{
    carry_out::{Ended, carry_out},
    common::Common,
    option,
};
use crate::{
    case::{Changes, overrides},
    error,
};

/// The folder of a study, the exception raised before its end, and a sentence for each case with
/// errors in its results.
#[pyfunction]
pub(crate) fn study_of(
    py: Python<'_>,
    path: PathBuf,
    changes: Changes,
    keep: Option<&str>,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<(Ended, Vec<String>)> {
    let study = py.detach(|| study::load(&path));
    let study = study.map_err(|report| error::of_report(py, &report))?;
    let overrides = overrides(&changes);
    let mut with_errors = Vec::new();
    let ended = carry_out(py, listener, |observer, cancellation| {
        if !study.warnings.is_empty() {
            observer.diagnostics(&study.warnings);
        }
        let keep = option::keep(keep)?;
        if common.csv && keep == Some(Keep::Summary) {
            return Err(option::bad("csv", "it writes tables, and keep=\"summary\" keeps none"));
        }
        let request = study::Request {
            study: &study,
            cases: study::CaseFiles::Beside(path.parent().unwrap_or(std::path::Path::new(""))),
            overrides: &overrides,
            keep,
            png: common.png,
            batch: common.batch()?,
        };
        let batch = study::run(&request, observer, cancellation)?;
        let wrong = batch.with_errors.iter();
        with_errors =
            wrong.map(|row| format!("{}: {}", row.name, row.operations.join(", "))).collect();
        Ok(super::carry_out::ended(batch))
    })?;
    Ok((ended, with_errors))
}
