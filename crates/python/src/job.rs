//! Jobs from Python: a command with its options as JSON, on cases in memory.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use pyo3::prelude::*;
use wholestring_case::Template;
use wholestring_runner::{
    Error,
    calibrate::{self, option},
    job::{CaseInput, DataInput, Job, JobFiles, OnDisk},
    study::Study,
};

use crate::{
    attended::{Attended, attended},
    case::{Case, Changes, overrides},
    error,
};

/// The files of a job, by the names in its JSON.
#[derive(Default)]
pub(crate) struct Files {
    cases: BTreeMap<PathBuf, CaseInput>,
    /// Paths of the other files.
    paths: BTreeMap<PathBuf, PathBuf>,
    /// Content of the readings, if they are not on the disk.
    content: Option<Vec<u8>>,
}

impl Files {
    /// Cases with the stems of their files, named by their numbers from zero.
    pub(crate) fn of_cases<'a>(cases: impl IntoIterator<Item = (&'a str, &'a Case)>) -> Self {
        let cases = cases.into_iter().enumerate().map(|(number, (file, case))| {
            let input = CaseInput {
                file: file.to_owned(),
                template: case.template.clone(),
                changes: case.changes.clone(),
                case: Some(case.case.clone()),
            };
            (number.to_string().into(), input)
        });
        Self { cases: cases.collect(), ..Self::default() }
    }

    fn path<'a>(&'a self, name: &'a Path) -> &'a Path {
        self.paths.get(name).map_or(name, PathBuf::as_path)
    }
}

impl JobFiles for Files {
    fn case(&self, name: &Path) -> Result<CaseInput, Error> {
        let input = self.cases.get(name);
        input.cloned().ok_or_else(|| Error::BadInput(format!("no case `{}`", name.display())))
    }

    fn data(&self, name: &Path, noun: &str) -> Result<DataInput, Error> {
        match &self.content {
            Some(bytes) => Ok(DataInput { path: name.to_owned(), bytes: bytes.clone() }),
            None => OnDisk.data(self.path(name), noun),
        }
    }

    fn study(&self, name: &Path) -> Result<Study, Error> {
        OnDisk.study(self.path(name))
    }

    fn study_case(&self, study: &Path, name: &str) -> Result<Template, Error> {
        OnDisk.study_case(self.path(study), name)
    }
}

/// The results folder, if there is one, the exception raised before the end, and a line for each
/// check whose severity is error.
type Ended = (Option<PathBuf>, Option<Py<PyAny>>, Vec<String>);

/// Runs a job while Python stays free. The cases have the numbers from zero as names in the JSON,
/// and the stems of their files; `paths` are those of other files by their names in it.
#[pyfunction]
#[pyo3(signature = (job, cases, paths, content, changes, folder, listener))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn carry_out(
    py: Python<'_>,
    job: &str,
    cases: Vec<(String, PyRef<'_, Case>)>,
    paths: BTreeMap<PathBuf, PathBuf>,
    content: Option<Vec<u8>>,
    changes: Changes,
    folder: PathBuf,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    let mut job = job_of(job, Some(folder))?;
    job.set = overrides(&changes);
    let cases = Files::of_cases(cases.iter().map(|(file, case)| (file.as_str(), &**case)));
    let files = Files { paths, content, ..cases };
    let Attended { result, raised } =
        attended(py, listener, |observer, cancellation| job.run(&files, observer, cancellation))?;
    let value = |raised: PyErr| raised.into_value(py).into_any();
    match (result, raised) {
        (Ok(outcome), raised) => {
            let errors = outcome.errors();
            let (folder, unfinished) = outcome.into_parts();
            let unfinished = unfinished.map(|reason| error::of_work(py, &reason));
            Ok((Some(folder), raised.or(unfinished).map(value), errors))
        }
        (Err(_), Some(raised)) => Ok((None, Some(value(raised)), Vec::new())),
        (Err(error), None) => Err(error::of_work(py, &error)),
    }
}

/// The job of a text, with its folder, which need not be Unicode as the text is.
pub(crate) fn job_of(text: &str, folder: Option<PathBuf>) -> PyResult<Job> {
    let mut job: Job = serde_json::from_str(text).map_err(|error| invalid(&error))?;
    job.output.folder = folder;
    Ok(job)
}

/// The error of an option, without its position in the JSON.
fn invalid(error: &serde_json::Error) -> PyErr {
    let position = format!(" at line {} column {}", error.line(), error.column());
    error::bad_input(error.to_string().replace(&position, ""))
}

/// Name of the dimension of a parameter that a calibration keeps fixed under this name; none for a
/// factor.
#[pyfunction]
pub(crate) fn held_dimension(py: Python<'_>, name: &str) -> PyResult<Option<&'static str>> {
    let refused = |reason| error::of_work(py, &Error::BadInput(format!("`hold`: {reason}")));
    let dimension = option::dimension(name).map_err(refused)?;
    Ok(dimension.map(wholestring_units::Dimension::name))
}

/// The keys of a case from a calibration in a folder, with their TOML values.
#[pyfunction]
pub(crate) fn calibrated(py: Python<'_>, folder: PathBuf) -> PyResult<Vec<(String, String)>> {
    calibrate::changes(&folder).map_err(|error| error::of_work(py, &error))
}
