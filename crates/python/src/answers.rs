//! What a case comes to: in memory, or as a folder has it.

use std::path::PathBuf;

use pyo3::{exceptions::PyKeyError, prelude::*};
use wholestring::outcome::SCALARS;
use wholestring_results::{Summary, TABLES, Table as StoredTable};
use wholestring_runner::{Existing, Output, run};

use crate::{attended::attended, error, table::Table};

/// A summary and tables.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Answers(Place);

enum Place {
    Memory(run::Answers),
    Folder { path: PathBuf, summary: Summary },
}

impl From<run::Answers> for Answers {
    fn from(answers: run::Answers) -> Self {
        Self(Place::Memory(answers))
    }
}

impl Answers {
    /// Those that a run left in a folder.
    pub(crate) fn of_folder(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let summary = Summary::read(&path.join("summary.json"));
        let summary = summary.map_err(|error| error::of_results(py, &error))?;
        Ok(Self(Place::Folder { path, summary }))
    }

    fn summary(&self) -> &Summary {
        match &self.0 {
            Place::Memory(answers) => answers.summary(),
            Place::Folder { summary, .. } => summary,
        }
    }
}

/// Name, SI unit and meaning of the scalars of an operation.
pub(crate) fn scalars() -> Vec<(&'static str, &'static str, &'static str)> {
    let of = |of: &wholestring::outcome::Scalar| {
        (of.quantity.name, of.quantity.unit, of.quantity.meaning)
    };
    SCALARS.iter().map(of).collect()
}

#[pymethods]
impl Answers {
    /// Those that a run left in a folder.
    #[staticmethod]
    fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        Self::of_folder(py, folder)
    }

    /// `summary.json`.
    fn summary_json(&self, py: Python<'_>) -> PyResult<String> {
        let json = serde_json::to_string(self.summary());
        json.map_err(|_| error::of_panic(py))
    }

    /// Where they lie; nothing where they are in memory.
    #[getter]
    fn folder(&self) -> Option<PathBuf> {
        match &self.0 {
            Place::Memory(_) => None,
            Place::Folder { path, .. } => Some(path.clone()),
        }
    }

    /// Names of the tables.
    fn table_names(&self) -> Vec<String> {
        match &self.0 {
            Place::Memory(answers) => {
                answers.tables().into_iter().map(|(name, _)| name.to_owned()).collect()
            }
            Place::Folder { path, .. } => {
                let names = TABLES.iter().map(|(name, _)| *name);
                let is_there = |name: &&str| path.join(format!("{name}.parquet")).is_file();
                names.filter(is_there).map(str::to_owned).collect()
            }
        }
    }

    /// A table by its name.
    fn table(&self, py: Python<'_>, name: &str) -> PyResult<Table> {
        if !self.table_names().iter().any(|of| of == name) {
            let names = self.table_names().join(", ");
            return Err(PyKeyError::new_err(format!("there is no table `{name}`: {names}")));
        }
        match &self.0 {
            Place::Memory(answers) => {
                let tables = answers.tables();
                let found = tables.into_iter().find(|(of, _)| *of == name);
                found.map_or_else(|| Err(error::of_panic(py)), |(_, table)| Table::of(table))
            }
            Place::Folder { path, .. } => {
                let path = path.join(format!("{name}.parquet"));
                let read = py.detach(|| StoredTable::read_parquet(&path));
                Table::of(&read.map_err(|error| error::of_results(py, &error))?)
            }
        }
    }

    /// Writes what a run leaves, and gives the folder.
    #[pyo3(signature = (folder, overwrite, csv, listener))]
    fn save(
        &self,
        py: Python<'_>,
        folder: Option<PathBuf>,
        overwrite: bool,
        csv: bool,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<PathBuf> {
        let Place::Memory(answers) = &self.0 else {
            let Place::Folder { path, .. } = &self.0 else { return Err(error::of_panic(py)) };
            return Ok(path.clone());
        };
        let existing = if overwrite { Existing::Overwrite } else { Existing::Protect };
        let output = Output { folder, existing };
        let saved = attended(py, listener, |observer, _| answers.save(&output, csv, observer))?;
        match (saved.raised, saved.result) {
            (Some(raised), _) => Err(raised),
            (None, result) => result.map_err(|error| error::of_work(py, &error)),
        }
    }
}
