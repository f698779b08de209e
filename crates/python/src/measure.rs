//! The same work without Python's part, for comparison by `benchmarks/overhead.py`.

use std::sync::Arc;

use pyo3::prelude::*;
use wholestring_runner::{CancellationToken, Silent, run};

use crate::{
    case::{Case, change},
    error,
    simulation::Simulation,
};

/// Advances a run without any callback.
///
/// # Errors
/// A run that diverged.
#[pyfunction]
pub(crate) fn advance_alone(py: Python<'_>, simulation: &Simulation, seconds: f64) -> PyResult<()> {
    let advanced =
        simulation.asked(py, |live| live.advance(seconds, &Silent, &CancellationToken::new()))?;
    advanced.map_err(|error| error::of_work(py, &error))
}

/// Solves an operation of a case with one model, and returns its hook load, N; if changes are
/// given, the case is built again from its text with them.
///
/// # Errors
/// A case without such an operation or model, or without a result.
#[pyfunction]
pub(crate) fn solve_alone(
    py: Python<'_>,
    template: &Case,
    model: &str,
    operation: &str,
    changes: Vec<(String, String)>,
) -> PyResult<f64> {
    let mut all = template.changes.clone();
    all.extend(changes.iter().map(|(key, value)| change(key, Some(value))));
    all.push(change("model", Some(&format!("{model:?}"))));
    all.push(change("operation.kind", Some(&format!("{operation:?}"))));
    let case = match changes.is_empty() {
        true => {
            template.with_models(py, Some(vec![model.to_owned()]), Some(operation.to_owned()))?
        }
        false => {
            let case = py.detach(|| template.template.case(&all));
            Arc::new(case.map_err(|report| error::of_report(py, &report))?)
        }
    };
    let solved = py.detach(|| run::answer(&case, None, &Silent, &CancellationToken::new()));
    let solved = solved.map_err(|error| error::of_work(py, &error))?;
    let first = solved.answers.summary().operations.first();
    Ok(first.map_or(f64::NAN, |first| first.scalars.hook_load_N))
}
