//! A checked case.

use std::{
    collections::BTreeMap,
    num::NonZeroUsize,
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
};

use pyo3::{
    prelude::*,
    types::{PyBytes, PyDict, PyList},
};
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case as Checked, Override, Quote, Template};
use wholestring_runner::{
    run::{self, Live},
    sweep::{Many, solve_many},
};

use crate::{
    answers::Answers,
    attended::attended,
    error,
    law::{self, Function},
    option::{self, statics},
    simulation::Simulation,
    table::Table,
};

/// A checked case, with its text and the changes made to it.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Case {
    pub(crate) template: Arc<Template>,
    pub(crate) changes: Vec<Override>,
    pub(crate) case: Arc<Checked>,
    /// The same with other models, as requested.
    with_models: Mutex<BTreeMap<String, Arc<Checked>>>,
}

/// A change as quoted in diagnostics: a key and a TOML value, or none if the key is removed.
pub(crate) fn change(key: &str, value: Option<&str>) -> Override {
    let quote = Quote::of_value("with_", key, value.unwrap_or("None"));
    match value {
        Some(value) => Override::quoted(key, value, quote),
        None => Override::removal(key, quote),
    }
}

/// Changes, each a key and a TOML value, or none if the key is removed.
pub(crate) type Changes = Vec<(String, Option<String>)>;

/// The changes as overrides.
pub(crate) fn overrides(changes: &Changes) -> Vec<Override> {
    changes.iter().map(|(key, value)| change(key, value.as_deref())).collect()
}

impl Case {
    fn of(py: Python<'_>, template: Arc<Template>, changes: Vec<Override>) -> PyResult<Self> {
        let case = py.detach(|| template.case(&changes));
        let case = Arc::new(case.map_err(|report| error::of_report(py, &report))?);
        Ok(Self { template, changes, case, with_models: Mutex::default() })
    }

    /// The case to be solved with these models, and one operation if it is named.
    pub(crate) fn with_models(
        &self,
        py: Python<'_>,
        models: Option<Vec<String>>,
        operation: Option<String>,
    ) -> PyResult<Arc<Checked>> {
        match self.narrowed(models.as_deref(), operation.as_deref()) {
            Some(case) => Ok(case),
            None => self.read_with(py, models, operation),
        }
    }

    /// The same without parsing the text again, which takes as long as solving statics; none if the
    /// text is required.
    fn narrowed(&self, models: Option<&[String]>, only: Option<&str>) -> Option<Arc<Checked>> {
        if models.is_none() && only.is_none() {
            return Some(self.case.clone());
        }
        let kind = only.map(OperationKind::from_name);
        let only = match kind {
            Some(None) => return None,
            Some(kind) => kind,
            None => None,
        };
        let of_name =
            |name: &String| ModelKind::ALL.iter().copied().find(|kind| kind.name() == name);
        let models: Option<Vec<ModelKind>> = match models {
            Some(names) => names.iter().map(of_name).collect(),
            None => Some(self.case.models.clone()),
        };
        self.case.narrowed(&models?, only).map(Arc::new)
    }

    /// The same from its text, with the diagnostics for these models and operations.
    fn read_with(
        &self,
        py: Python<'_>,
        models: Option<Vec<String>>,
        operation: Option<String>,
    ) -> PyResult<Arc<Checked>> {
        let mut changes = self.changes.clone();
        let mut name = String::new();
        for (key, words) in
            [("model", models), ("operation.kind", operation.map(|operation| vec![operation]))]
        {
            if let Some(words) = words {
                let quoted: Vec<String> = words.iter().map(|word| format!("{word:?}")).collect();
                let list = format!("[{}]", quoted.join(", "));
                name.push_str(&list);
                changes.push(change(key, Some(&list)));
            }
            name.push(';');
        }
        let held = || self.with_models.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(case) = held().get(&name) {
            return Ok(case.clone());
        }
        let case = py.detach(|| self.template.case(&changes));
        let case = Arc::new(case.map_err(|report| error::of_report(py, &report))?);
        held().insert(name, case.clone());
        Ok(case)
    }
}

#[pymethods]
impl Case {
    /// Reads a case file.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let template = py.detach(|| Template::read(&path));
        let template = template.map_err(|report| error::of_report(py, &report))?;
        Self::of(py, Arc::new(template), Vec::new())
    }

    /// Reads a case from its text and the files that it names.
    #[staticmethod]
    fn parse(
        py: Python<'_>,
        text: &str,
        name: &str,
        files: BTreeMap<String, Vec<u8>>,
    ) -> PyResult<Self> {
        Self::of(py, Arc::new(Template::in_memory(name, text, files)), Vec::new())
    }

    /// Another case: this one with changes, each a key and a TOML value, or none if the key is
    /// removed.
    fn changed(&self, py: Python<'_>, changes: Changes) -> PyResult<Self> {
        let mut all = self.changes.clone();
        all.extend(overrides(&changes));
        Self::of(py, self.template.clone(), all)
    }

    /// The text of the case, with its changes.
    fn to_toml(&self, py: Python<'_>) -> PyResult<String> {
        self.template.text(&self.changes).map_err(|report| error::of_report(py, &report))
    }

    /// The text that it was read from, without the changes made to it.
    fn template_text(&self, py: Python<'_>) -> PyResult<String> {
        self.template.text(&[]).map_err(|report| error::of_report(py, &report))
    }

    /// Its name in diagnostics.
    #[getter]
    fn source(&self) -> &str {
        self.template.name()
    }

    /// The files used in addition to its text.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let files = PyDict::new(py);
        for (name, bytes) in self.template.files() {
            files.set_item(name, PyBytes::new(py, &bytes))?;
        }
        Ok(files)
    }

    /// The settings with all defaults filled in, as JSON.
    fn settings_json(&self) -> String {
        self.case.settings.to_string()
    }

    /// Its complete settings, as text: equal for equal cases.
    fn identity(&self) -> String {
        let Checked { settings, plan, modes, .. } = &*self.case;
        serde_json::json!([settings, plan, modes]).to_string()
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.case.name
    }

    /// Its models.
    #[getter]
    fn models(&self) -> Vec<&'static str> {
        self.case.models.iter().map(|model| model.name()).collect()
    }

    /// Its operations.
    #[getter]
    fn operations(&self) -> Vec<&'static str> {
        self.case.operations.iter().map(|operation| operation.kind.name()).collect()
    }

    /// The same with these models, and one operation if it is named: probable mistakes.
    ///
    /// # Errors
    /// A case that these cannot solve.
    #[pyo3(signature = (models, operation))]
    fn check<'py>(
        &self,
        py: Python<'py>,
        models: Option<Vec<String>>,
        operation: Option<String>,
    ) -> PyResult<Bound<'py, PyList>> {
        let case = self.read_with(py, models, operation)?;
        error::diagnostics(py, std::slice::from_ref(&case.warnings))
    }

    /// Probable mistakes that can be computed nevertheless.
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        error::diagnostics(py, std::slice::from_ref(&self.case.warnings))
    }

    /// Solves it in memory: the results, and the exception raised before the end, if any.
    #[pyo3(signature = (models, operation, jobs, listener))]
    fn answer(
        &self,
        py: Python<'_>,
        models: Option<Vec<String>>,
        operation: Option<String>,
        jobs: Option<NonZeroUsize>,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<(Answers, Option<Py<PyAny>>)> {
        let case = self.with_models(py, models, operation)?;
        let work = attended(py, listener, |observer, cancellation| {
            run::answer(&case, jobs, observer, cancellation)
        })?;
        let solved = work.result.map_err(|error| error::of_work(py, &error))?;
        let stopped = solved.stopped.map(|stop| error::of_work(py, &stop.into()));
        let raised = work.raised.or(stopped).map(|raised| raised.into_value(py).into_any());
        Ok((solved.answers.into(), raised))
    }

    /// Solves variations of it by a static model, in memory: a table, the number of its varied
    /// columns, and the exception raised meanwhile.
    #[pyo3(signature = (variations, model, operation, jobs, listener))]
    fn many(
        &self,
        py: Python<'_>,
        variations: Vec<Changes>,
        model: &str,
        operation: Option<&str>,
        jobs: Option<NonZeroUsize>,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<(Table, usize)> {
        let variations: Vec<Vec<Override>> = variations.iter().map(overrides).collect();
        let work = attended(py, listener, |observer, cancellation| {
            let many = Many {
                template: &self.template,
                overrides: &self.changes,
                variations: &variations,
                model: statics(model)?,
                operation: operation.map(option::operation).transpose()?,
                jobs,
            };
            solve_many(&many, observer, cancellation)
        })?;
        match (work.raised, work.result) {
            (Some(raised), _) => Err(raised),
            (None, Ok((table, changed))) => Ok((Table::of(&table)?, changed)),
            (None, Err(error)) => Err(error::of_work(py, &error)),
        }
    }

    /// A dynamic run controlled from Python, from a checkpoint if there is one. Laws are functions
    /// with their names and rates.
    #[pyo3(signature = (operation, checkpoint, bit_law, excitation, jobs, listener))]
    #[allow(clippy::too_many_arguments)]
    fn simulation(
        &self,
        py: Python<'_>,
        operation: Option<&str>,
        checkpoint: Option<&[u8]>,
        bit_law: Option<Function>,
        excitation: Option<Function>,
        jobs: Option<NonZeroUsize>,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<Simulation> {
        let case = self.case.clone();
        let (laws, raised) = law::laws(bit_law, excitation);
        let work = attended(py, listener, |observer, cancellation| match checkpoint {
            Some(bytes) => Live::resume(case, &laws, jobs, bytes),
            None => Live::begin(case, operation, &laws, jobs, observer, cancellation),
        })?;
        match (work.raised.or(raised.take()), work.result) {
            (Some(error), _) => Err(error),
            (None, Ok(live)) => Ok(Simulation::new(live, raised)),
            (None, Err(error)) => Err(error::of_work(py, &error)),
        }
    }
}
