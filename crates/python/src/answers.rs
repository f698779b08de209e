//! Results of commands: in memory, or from a folder.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring::outcome::SCALARS;
use wholestring_results::Summary;
use wholestring_runner::{Existing, Output, copy_results, run, sweep::operations_table};

use crate::{attended::attended, error, folder::Folder, table::Table};

/// A summary and tables.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Answers(Place);

enum Place {
    Memory(Box<run::Answers>),
    Folder(Folder),
}

impl From<run::Answers> for Answers {
    fn from(answers: run::Answers) -> Self {
        Self(Place::Memory(Box::new(answers)))
    }
}

/// Summary, tables, and whether the case requests spectra.
type Parts = (String, Vec<(&'static str, Table)>, bool);

/// Name, SI unit and meaning of the scalars of an operation.
pub(crate) fn scalars() -> Vec<(&'static str, &'static str, &'static str)> {
    let entry = |scalar: &wholestring::outcome::Scalar| {
        (scalar.quantity.name, scalar.quantity.unit, scalar.quantity.meaning)
    };
    SCALARS.iter().map(entry).collect()
}

#[pymethods]
impl Answers {
    /// Reads the results of a command from a folder.
    #[staticmethod]
    pub(crate) fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        let folder = py.detach(|| Folder::read(folder));
        Ok(Self(Place::Folder(folder.map_err(|error| error::of_results(py, &error))?)))
    }

    /// Their kind: `a run`, `a plan`, ...
    #[getter]
    fn kind(&self) -> &'static str {
        match &self.0 {
            Place::Memory(_) => "a run",
            Place::Folder(folder) => folder.kind,
        }
    }

    /// Restores results in memory from [`Answers::parts`].
    #[staticmethod]
    fn restore(
        py: Python<'_>,
        summary: &str,
        tables: Vec<(String, PyRef<'_, Table>)>,
        with_spectra: bool,
    ) -> PyResult<Self> {
        let tables = tables.iter().map(|(name, table)| (name.clone(), table.stored())).collect();
        let answers = py.detach(|| run::Answers::restore(summary, tables, with_spectra));
        Ok(answers.map_err(|error| error::of_results(py, &error))?.into())
    }

    /// The parts of results in memory: summary, tables, and whether the case requests spectra; none
    /// if they are in a folder.
    fn parts(&self, py: Python<'_>) -> PyResult<Option<Parts>> {
        let Place::Memory(answers) = &self.0 else { return Ok(None) };
        let named = |(name, table): (&'static str, _)| Ok((name, Table::of(table)?));
        let tables = answers.tables().into_iter().map(named).collect::<PyResult<_>>()?;
        Ok(Some((self.summary_json(py)?, tables, answers.with_spectra())))
    }

    /// `summary.json`; an empty object if a folder has none.
    fn summary_json(&self, py: Python<'_>) -> PyResult<String> {
        match &self.0 {
            Place::Memory(answers) => {
                let json = serde_json::to_string(answers.summary());
                json.map_err(|_| error::of_panic(py))
            }
            Place::Folder(folder) => Ok(folder.summary.clone()),
        }
    }

    /// A row for each operation: scalars, statistics and indicators, as in a sweep.
    fn scalars(&self, py: Python<'_>) -> PyResult<Table> {
        let table = match &self.0 {
            Place::Memory(answers) => operations_table(&answers.summary().operations),
            Place::Folder(folder) => {
                let summary = Summary::parse(&folder.path.join("summary.json"), &folder.summary);
                let summary = summary.map_err(|error| error::of_results(py, &error))?;
                operations_table(&summary.operations)
            }
        };
        Table::of(&table)
    }

    /// Their folder; none if they are in memory.
    #[getter]
    fn folder(&self) -> Option<PathBuf> {
        match &self.0 {
            Place::Memory(_) => None,
            Place::Folder(folder) => Some(folder.path.clone()),
        }
    }

    /// Names of the tables.
    fn table_names(&self) -> Vec<String> {
        match &self.0 {
            Place::Memory(answers) => {
                answers.tables().into_iter().map(|(name, _)| name.to_owned()).collect()
            }
            Place::Folder(folder) => folder.tables(),
        }
    }

    /// A table by name.
    fn table(&self, py: Python<'_>, name: &str) -> PyResult<Table> {
        let names = self.table_names();
        if !names.iter().any(|other| other == name) {
            let names = names.join(", ");
            return Err(error::not_found(format!("there is no table `{name}`: {names}")));
        }
        match &self.0 {
            Place::Memory(answers) => {
                let tables = answers.tables();
                let found = tables.into_iter().find(|(table, _)| *table == name);
                found.map_or_else(|| Err(error::of_panic(py)), |(_, table)| Table::of(table))
            }
            Place::Folder(folder) => {
                let read = py.detach(|| folder.table(name));
                Table::of(&read.map_err(|error| error::of_results(py, &error))?)
            }
        }
    }

    /// Writes the files of the command, and returns the folder.
    #[pyo3(signature = (folder, overwrite, csv, listener))]
    fn save(
        &self,
        py: Python<'_>,
        folder: Option<PathBuf>,
        overwrite: bool,
        csv: bool,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<PathBuf> {
        let existing = if overwrite { Existing::Overwrite } else { Existing::Protect };
        let output = Output { folder, existing, ..Output::default() };
        let saved = attended(py, listener, |observer, _| match &self.0 {
            Place::Memory(answers) => answers.save(&output, csv, observer),
            Place::Folder(folder) => {
                let to = copy_results(&folder.path, &output, observer)?;
                if csv {
                    folder.write_csv(&to)?;
                }
                Ok(to)
            }
        })?;
        match (saved.raised, saved.result) {
            (Some(raised), _) => Err(raised),
            (None, result) => result.map_err(|error| error::of_work(py, &error)),
        }
    }
}
